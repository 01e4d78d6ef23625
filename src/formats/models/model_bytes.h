// What the files of models and sprites share: their first words, the start of a skin or frame, which is
// single or a group, and the check that the bytes that a count promises are there. `part` names, in errors,
// what is read: "frame 3".
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

struct FileKind {
  std::string_view name;   // "model"
  std::string_view magic;  // the first four bytes
  std::int32_t version = 0;
};

// Magic and version, of a file that has header_bytes of which they are the first eight.
base::Status read_file_kind(base::ByteReader& io_reader, const FileKind& kind, std::size_t header_bytes);
void write_file_kind(base::ByteWriter& io_writer, const FileKind& kind);

// A number of the header, called `what` in errors, that has to be finite.
base::Result<float> read_finite(base::ByteReader& io_reader, std::string_view what);

// To be asked before anything is allocated. An error when fewer than `bytes` are left.
base::Status need_bytes(const base::ByteReader& reader, std::uint64_t bytes, std::string_view part);

// The number of members of a group, at least one; 0: not a group.
base::Result<std::uint32_t> read_group_members(base::ByteReader& io_reader, std::string_view part);
// What errors call member number `i`: "frame 3, pose 7", or, where there is no group, "frame 3".
std::string member_name(std::string_view part, std::string_view kind, std::uint32_t i, std::uint32_t members);
void write_group_members(base::ByteWriter& io_writer, std::size_t members);

// One end time a member, as group_time.h has them.
base::Result<std::vector<float>> read_group_times(base::ByteReader& io_reader, std::uint32_t members,
                                                  std::string_view part);
// CHECKs are_group_times().
void write_group_times(base::ByteWriter& io_writer, std::span<const float> end_times_s);

}  // namespace temblor::formats
