// PK3 archives: zip files with another extension, as later engines use them. Supports stored and deflated
// entries, also with zip64 records (zip_directory.h describes the layout). zlib packs and unpacks the data
// (L. Peter Deutsch, RFC 1951, 1996); our own limits stop zip bombs.
//
// The whole archive stays in memory; entries are unpacked when they are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/archives/archive.h"
#include "formats/archives/zip_directory.h"

namespace temblor::formats {

// Limits against archives that unpack to far more than they contain.
struct Pk3Limits {
  std::uint64_t unpacked_bytes = std::uint64_t{1} << 30;  // limit for all entries together
};

// An open archive. Owns the packed bytes, and unpacks entries on demand.
class Pk3 {
 public:
  // Files in the order of the zip directory, without folders. is_contained_name(name); names may repeat, and
  // the last one counts.
  std::span<const ZipRecord> entries() const { return entries_; }
  // The reasons why other files were left out.
  std::span<const std::string> left_out() const { return left_out_; }

  // Unpacks entries()[position]; CHECKs the position. Returns kMalformed if the data cannot be unpacked or
  // its size differs from the directory. A wrong checksum is an error only on request: other engines do not
  // compute it. Thread-safe.
  enum class Checksum { kIgnore, kVerify };
  base::Result<base::ByteVector> read(std::size_t position, Checksum checksum = Checksum::kIgnore) const;

 private:
  friend base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits);
  Pk3() = default;

  base::ByteVector bytes_;
  std::vector<ZipRecord> entries_;
  std::vector<std::string> left_out_;
};

// Opens an archive and checks its directory. Leaves out files that are encrypted or compressed by a method
// other than deflate, and those with a name that leaves the folder or an impossible size. Returns kTooLarge
// above a limit, and kMalformed if there is no directory.
base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits = {});

// Packs files in the given order. The result is reproducible: all entries have the date 1980-01-01. Names
// must be unique and satisfy is_contained_name(), or it returns kUsage. Returns kTooLarge for more than
// 65,535 files or 4 GiB.
base::Result<base::ByteVector> write_pk3(std::span<const ArchiveFile> files);

}  // namespace temblor::formats
