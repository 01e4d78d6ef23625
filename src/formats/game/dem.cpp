#include "formats/game/dem.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/check.h"

namespace temblor::formats {
namespace {

// Longer than any line that another program writes; a file of another kind may have no line end at all.
constexpr std::size_t kMaxTrackLine = 64;
constexpr std::string_view kBlanks = " \t\r";
constexpr int kNoTrack = -1;

bool is_text(std::string_view line) {
  return std::all_of(line.begin(), line.end(), [](char c) {
    return (c >= ' ' && c <= '~') || kBlanks.find(c) != std::string_view::npos;
  });
}

// Other engines also play demos whose line has blanks, too many digits, letters, or nothing.
int parse_track(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(kBlanks), line.size());
  line = line.substr(begin, line.find_last_not_of(kBlanks) + 1 - begin);
  if (line.starts_with('+')) line.remove_prefix(1);
  int track = kNoTrack;
  const auto [rest, fault] = std::from_chars(line.data(), line.data() + line.size(), track);
  return fault == std::errc{} && rest == line.data() + line.size() ? track : kNoTrack;
}

}  // namespace

base::Result<DemReader> DemReader::open(base::Bytes bytes) {
  const std::string_view start = base::as_text(bytes).substr(0, kMaxTrackLine);
  const std::size_t line_end = start.find('\n');
  if (line_end == std::string_view::npos || !is_text(start.substr(0, line_end)))
    return base::malformed("not a demo: the first {} bytes have no line with the number of a CD track",
                           start.size());
  DemReader recording(bytes);
  recording.forced_track_ = parse_track(start.substr(0, line_end));
  recording.reader_.seek(line_end + 1);
  return recording;
}

// Reads into a copy of the reader, so that offset() stays at the last complete record. A demo whose end is
// missing, because the program that recorded it was killed, still plays up to there.
base::Result<std::optional<DemMessage>> DemReader::next() {
  using Message = std::optional<DemMessage>;
  if (is_truncated_ || reader_.remaining() == 0) return Message{};
  base::ByteReader record = reader_;
  const std::int32_t length = record.i32();
  if (record.ok() && (length < 0 || static_cast<std::size_t>(length) > kMaxDemMessage))
    return base::malformed("message at offset {}: size of {} bytes exceeds the limit of {}", reader_.offset(),
                           length, kMaxDemMessage);
  DemMessage message;
  for (int axis = 0; axis < 3; ++axis) message.view_angles_deg[axis] = record.f32();
  message.offset = record.offset();
  message.message = record.take(static_cast<std::size_t>(length));
  if (!record.ok()) {
    is_truncated_ = true;
    return Message{};
  }
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(message.view_angles_deg[axis])) message.view_angles_deg[axis] = 0;
  reader_ = record;
  return Message{message};
}

DemWriter::DemWriter(int forced_track) {
  writer_.bytes(base::as_bytes(fmt::format("{}\n", forced_track)));
}

void DemWriter::add(const math::Vec3& view_angles_deg, base::Bytes message) {
  CHECK(message.size() <= kMaxDemMessage, "{}", message.size());
  writer_.i32(static_cast<std::int32_t>(message.size()));
  for (int axis = 0; axis < 3; ++axis) writer_.f32(view_angles_deg[axis]);
  writer_.bytes(message);
}

}  // namespace temblor::formats
