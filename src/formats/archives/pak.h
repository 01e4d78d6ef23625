// PAK archives: a header, the data of the files, and a directory at any place. Little-endian, without
// compression, so the game can read a file from the middle of the archive. The vfs reads only the directory
// when it mounts a PAK.
//
//   header, 12 bytes               0  "PACK"
//                                  4  directory offset i32    from the start of the file
//                                  8  directory size i32      bytes, 64 for each entry
//   data of the files, in any order, with gaps or overlaps
//   directory entry, 64 bytes      0  name char[56]           "maps/start.bsp", zero-terminated
//                                 56  data offset i32
//                                 60  data size i32           bytes
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
constexpr std::size_t kPakNameChars = 55;  // without the terminating zero
// The original engine allowed 2048 files; this limit only bounds the memory for hostile files.
constexpr std::size_t kMaxPakEntries = 1 << 18;

// The place of the directory, inside of the file.
struct PakHeader {
  std::uint64_t directory_offset = 0;
  std::uint64_t directory_bytes = 0;  // a multiple of kPakRecordBytes
};

// A file in the archive. Its name is not checked; the vfs skips names that leave the folder.
struct PakEntry {
  std::string name;  // as stored, at most 56 characters
  std::uint64_t offset = 0;
  std::uint64_t size = 0;  // bytes
  bool operator==(const PakEntry&) const = default;
};

// Reads a PAK without loading it: read_pak_header() parses the first 12 bytes and returns the place of the
// directory, and read_pak_directory() parses the bytes there. `archive_bytes`: size of the file. Returns
// kMalformed if the directory exceeds it. Ignores entries that exceed it, and an incomplete entry at the end.
base::Result<PakHeader> read_pak_header(base::Bytes header, std::uint64_t archive_bytes);
std::vector<PakEntry> read_pak_directory(base::Bytes directory, std::uint64_t archive_bytes);

// Reads the directory of an archive in memory. Every entry is inside of `archive`. Entries may overlap, and
// names may repeat; the first one counts.
base::Result<std::vector<PakEntry>> read_pak(base::Bytes archive);

// Packs files in the given order. Returns kTooLarge for a name over 55 characters, more than kMaxPakEntries
// files, or more than 2^31 - 1 bytes.
base::Result<base::ByteVector> write_pak(std::span<const ArchiveFile> files);

}  // namespace temblor::formats
