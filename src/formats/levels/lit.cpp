#include "formats/levels/lit.h"

#include <span>

namespace temblor::formats {
namespace {

constexpr std::string_view kMark = "QLIT";
constexpr std::int32_t kLitVersion = 1;

}  // namespace

base::Result<Lit> read_lit(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  if (base::as_text(reader.take(kMark.size())) != kMark)
    return base::malformed("not a colored light file: it does not start with QLIT");
  const std::int32_t version = reader.i32();
  if (!reader.ok()) return base::malformed("{} bytes are shorter than the header", bytes.size());
  if (version != kLitVersion)
    return error(base::ErrorCode::kUnsupported,
                 "version {} of colored light is not supported (supported: {})", version, kLitVersion);
  const std::size_t size = reader.remaining();
  if (size % 3 != 0) return base::malformed("{} bytes after the header are not a multiple of 3", size);
  const auto samples = base::as_u8(reader.take(size));
  return Lit{{samples.begin(), samples.end()}};
}

base::ByteVector write_lit(const Lit& lit) {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes(kMark));
  writer.i32(kLitVersion);
  writer.bytes(std::as_bytes(std::span(lit.samples)));
  return std::move(writer).take();
}

}  // namespace temblor::formats
