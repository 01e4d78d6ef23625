// The directory of a zip archive, which lists its files. It is hostile input: everything is checked against
// the archive's size before it is used.
//
//   | local header, packed data | ... | directory record | ... | zip64 end record, locator | end record |
//
// Reading starts at the end record, near the end of the archive. Its directory is the one that ends before
// it; the zip64 records between them are optional. Source: PKWARE, APPNOTE.TXT - .ZIP File Format
// Specification (2022).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// The numbers of APPNOTE that the reader and the writer share.
namespace zip {
constexpr std::uint32_t kLocalHeader = 0x04034b50, kDirectoryRecord = 0x02014b50, kEndRecord = 0x06054b50;
constexpr std::size_t kDirectoryRecordBytes = 46;  // without name, extra field, and comment
constexpr std::uint16_t kStored = 0, kDeflated = 8;
constexpr std::uint16_t kIsEncrypted = 1 << 0, kHasUtf8Name = 1 << 11;
}  // namespace zip

// A file or folder, as the directory declares it.
struct ZipRecord {
  std::string name;  // as stored; folders end with '/'
  std::uint16_t flags = 0, method = 0;
  std::uint32_t crc = 0;            // of the unpacked bytes
  std::uint64_t packed_size = 0;    // bytes in the archive
  std::uint64_t size = 0;           // bytes unpacked
  std::uint64_t header_offset = 0;  // of the local header, from the start of the archive's bytes
};

struct ZipDirectory {
  std::vector<ZipRecord> records;
  std::uint64_t unreadable = 0;  // records that the end record counts after those
};

// Reads the directory of the last end record that has one. Ignores bytes before the archive, even if its
// offsets do not count them, and bytes after it. Returns kTooLarge for a directory of more than 32 MiB.
base::Result<ZipDirectory> read_zip_directory(base::Bytes archive);

// Returns the packed data of a record, or kMalformed if it is not in the archive. Borrows the archive's
// bytes.
base::Result<base::Bytes> find_packed_data(base::Bytes archive, const ZipRecord& record);

}  // namespace temblor::formats
