// PAK archives: a header, the files one after another, a table of names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/archives/archive.h"

namespace temblor::formats {

constexpr std::size_t kPakHeaderBytes = 12;
constexpr std::size_t kPakRecordBytes = 64;
constexpr std::size_t kPakNameChars = 55;  // and a zero
// The original's limit was 2048 files; this one only keeps a hostile table out of memory.
constexpr std::size_t kMaxPakEntries = 1 << 18;

struct PakHeader {
  std::uint64_t directory_offset = 0;
  std::uint64_t directory_bytes = 0;  // a multiple of kPakRecordBytes
};

struct PakEntry {
  std::string name;  // as stored, at most 55 characters
  std::uint64_t offset = 0;
  std::uint64_t size = 0;  // bytes
  bool operator==(const PakEntry&) const = default;
};

// A PAK can be used without reading it whole: read_pak_header() of its first 12 bytes says where the table
// is, read_pak_directory() of the table's bytes gives the entries. `archive_bytes` is the size of the whole
// file; header and entries lie inside it.
base::Result<PakHeader> read_pak_header(base::Bytes header, std::uint64_t archive_bytes);
base::Result<std::vector<PakEntry>> read_pak_directory(base::Bytes directory, std::uint64_t archive_bytes);

// Both at once, for an archive that is in memory: every entry lies inside `archive`. Entries may overlap and
// names may repeat (the first one counts).
base::Result<std::vector<PakEntry>> read_pak(base::Bytes archive);

// The files in the order given. kTooLarge for a name over 55 characters, for more than kMaxPakEntries files
// or for more than 2^31 - 1 bytes.
base::Result<base::ByteVector> write_pak(std::span<const ArchiveFile> files);

}  // namespace temblor::formats
