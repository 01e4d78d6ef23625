#include "formats/levels/lit.h"

#include <utility>

namespace temblor::formats {
namespace {

constexpr std::string_view kMark = "QLIT";
constexpr std::int32_t kLitVersion = 1;

}  // namespace

base::Result<std::vector<std::uint8_t>> read_light_samples(base::Bytes bytes, std::string_view meaning) {
  base::ByteReader reader(bytes);
  if (base::as_text(reader.take(kMark.size())) != kMark)
    return base::malformed("not a {} file: it does not start with QLIT", meaning);
  const std::int32_t version = reader.i32();
  if (!reader.ok()) return base::malformed("{} bytes are shorter than the header", bytes.size());
  if (version != kLitVersion)
    return error(base::ErrorCode::kUnsupported, "version {} of {} is not supported (supported: {})", version,
                 meaning, kLitVersion);
  const std::size_t size = reader.remaining();
  if (size % 3 != 0) return base::malformed("{} bytes after the header are not a multiple of 3", size);
  const auto samples = base::as_u8(reader.take(size));
  return std::vector<std::uint8_t>(samples.begin(), samples.end());
}

base::ByteVector write_light_samples(std::span<const std::uint8_t> samples) {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes(kMark));
  writer.i32(kLitVersion);
  writer.bytes(std::as_bytes(samples));
  return std::move(writer).take();
}

base::Result<Lit> read_lit(base::Bytes bytes) {
  TRY(std::vector<std::uint8_t> samples, read_light_samples(bytes, "colored light"));
  return Lit{std::move(samples)};
}

base::ByteVector write_lit(const Lit& lit) {
  return write_light_samples(lit.samples);
}

}  // namespace temblor::formats
