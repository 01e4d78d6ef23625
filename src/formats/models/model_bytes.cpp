#include "formats/models/model_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "formats/models/group_time.h"

namespace temblor::formats {
namespace {

constexpr std::int32_t kSingle = 0, kGroup = 1;
constexpr float kReplacedMemberS = 0.1f;
constexpr float kEndlessS = std::numeric_limits<float>::infinity();

}  // namespace

base::Status read_file_kind(base::ByteReader& io_reader, const FileKind& kind, std::size_t header_bytes) {
  if (io_reader.remaining() < header_bytes)
    return base::malformed("{} header needs {} bytes, the file has {}", kind.name, header_bytes,
                           io_reader.remaining());
  if (base::as_text(io_reader.take(kind.magic.size())) != kind.magic)
    return base::malformed("not a {}: it does not start with \"{}\"", kind.name, kind.magic);
  if (const std::int32_t version = io_reader.i32(); version != kind.version)
    return base::error(base::ErrorCode::kUnsupported, "{} version {} is not supported, only {}", kind.name,
                       version, kind.version);
  return base::Ok{};
}

void write_file_kind(base::ByteWriter& io_writer, const FileKind& kind) {
  io_writer.bytes(base::as_bytes(kind.magic));
  io_writer.i32(kind.version);
}

base::Result<float> read_finite(base::ByteReader& io_reader, std::string_view what) {
  const std::size_t offset = io_reader.offset();
  const float number = io_reader.f32();
  if (!std::isfinite(number))
    return base::malformed("header at offset {:#x}: {} is {}", offset, what, number);
  return number;
}

float read_unused_number(base::ByteReader& io_reader) {
  const float number = io_reader.f32();
  return std::isfinite(number) ? number : 0;
}

base::Status need_bytes(const base::ByteReader& reader, std::uint64_t bytes, std::string_view part) {
  if (bytes <= reader.remaining()) return base::Ok{};
  return base::malformed("{} at offset {:#x}: needs {} bytes, only {} are left", part, reader.offset(), bytes,
                         reader.remaining());
}

base::Result<std::uint32_t> read_group_members(base::ByteReader& io_reader, std::string_view part) {
  const std::size_t offset = io_reader.offset();
  TRY_STATUS(need_bytes(io_reader, sizeof(std::int32_t), part));
  const std::int32_t kind = io_reader.i32();
  if (kind == kSingle) return std::uint32_t{0};
  if (kind != kGroup)
    return base::malformed("{} at offset {:#x}: unknown type {} (expected {} for single or {} for group)",
                           part, offset, kind, kSingle, kGroup);
  TRY_STATUS(need_bytes(io_reader, sizeof(std::uint32_t), part));
  const std::uint32_t members = io_reader.u32();
  if (members == 0) return base::malformed("{} at offset {:#x}: empty group", part, offset);
  return members;
}

std::string member_name(std::string_view part, std::string_view kind, std::uint32_t i,
                        std::uint32_t members) {
  return members > 0 ? fmt::format("{}, {} {}", part, kind, i) : std::string(part);
}

void write_group_members(base::ByteWriter& io_writer, std::size_t members) {
  io_writer.i32(members > 0 ? kGroup : kSingle);
  if (members > 0) io_writer.u32(static_cast<std::uint32_t>(members));
}

// The place of a time without a sensible one is small and visible. Only a time at the end of what a float can
// hold leaves no room after it.
base::Result<std::vector<float>> read_group_times(base::ByteReader& io_reader, std::uint32_t members,
                                                  std::string_view part) {
  const std::size_t offset = io_reader.offset();
  TRY_STATUS(need_bytes(io_reader, std::uint64_t{members} * sizeof(float), part));
  std::vector<float> end_times_s(members);
  for (std::size_t i = 0; i < members; ++i) {
    const float last_s = i > 0 ? end_times_s[i - 1] : 0;
    end_times_s[i] = io_reader.f32();
    if (!std::isfinite(end_times_s[i]) || end_times_s[i] <= last_s)
      end_times_s[i] = std::max(last_s + kReplacedMemberS, std::nextafter(last_s, kEndlessS));
    if (!are_group_times(std::span(end_times_s).subspan(i > 0 ? i - 1 : 0, i > 0 ? 2 : 1)))
      return base::malformed(
          "{} at offset {:#x}: end time {} of {} is {} after {}, end times must be positive and increasing",
          part, offset + i * sizeof(float), i, members, end_times_s[i], i > 0 ? end_times_s[i - 1] : 0.0f);
  }
  return end_times_s;
}

void write_group_times(base::ByteWriter& io_writer, std::span<const float> end_times_s) {
  CHECK(are_group_times(end_times_s));
  for (const float end_s : end_times_s) io_writer.f32(end_s);
}

}  // namespace temblor::formats
