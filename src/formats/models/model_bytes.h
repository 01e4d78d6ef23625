// Parts that model and sprite files share: the start of the header, single and group members, and size checks
// before allocations. In all functions, `part` names the part in errors, such as "frame 3".
//
//   single:  0 i32 | data
//   group:   1 i32 | count i32 | [bounds, model frames only] | count x end time f32 (seconds) | count x data
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// The start of a file format.
struct FileKind {
  std::string_view name;   // "model"
  std::string_view magic;  // the first four bytes
  std::int32_t version = 0;
};

// Reads magic and version, and checks that the file has header_bytes, of which they are the first eight.
base::Status read_file_kind(base::ByteReader& io_reader, const FileKind& kind, std::size_t header_bytes);
void write_file_kind(base::ByteWriter& io_writer, const FileKind& kind);

// Reads a number of the header; it must be finite. `what` names it in errors.
base::Result<float> read_finite(base::ByteReader& io_reader, std::string_view what);
// Reads a number of the header that the game does not use. One that is not finite becomes 0.
float read_unused_number(base::ByteReader& io_reader);

// Returns kMalformed if fewer than `bytes` are left. Call it before allocating memory.
base::Status need_bytes(const base::ByteReader& reader, std::uint64_t bytes, std::string_view part);

// Returns the number of group members, at least 1; or 0 for a single.
base::Result<std::uint32_t> read_group_members(base::ByteReader& io_reader, std::string_view part);
// Names member `i` in errors: "frame 3, pose 7"; for a single just "frame 3".
std::string member_name(std::string_view part, std::string_view kind, std::uint32_t i, std::uint32_t members);
// Writes the start of a single (0 members) or a group.
void write_group_members(base::ByteWriter& io_writer, std::size_t members);

// Reads one end time for each member. A member that would end before it begins, or never, is shown for 0.1 s
// instead. The result satisfies are_group_times().
base::Result<std::vector<float>> read_group_times(base::ByteReader& io_reader, std::uint32_t members,
                                                  std::string_view part);
// CHECKs are_group_times().
void write_group_times(base::ByteWriter& io_writer, std::span<const float> end_times_s);

}  // namespace temblor::formats
