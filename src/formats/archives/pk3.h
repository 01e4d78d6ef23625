// PK3 archives: zip files with another extension, as later engines use them. Supports stored and deflated
// entries, also with zip64 records. Built on libzip, with our own limits against zip bombs and damaged
// directories:
//
//   | local header, packed data | local header, packed data | ... | central directory | end record |
//
// Reading starts at the end record, which has the place of the central directory. Bytes before the archive
// (a program that unpacks it) and after it are ignored. The whole archive stays in memory; entries are
// unpacked when they are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/archives/archive.h"

namespace temblor::formats {

// Limits against archives that unpack to far more than they contain.
struct Pk3Limits {
  std::uint64_t unpacked_bytes = std::uint64_t{1} << 30;  // limit for all entries together
};

// A file in the archive.
struct Pk3Entry {
  std::string name;             // as stored; is_contained_name()
  std::uint64_t size = 0;       // unpacked bytes, as declared in the archive
  std::uint64_t zip_index = 0;  // index in the zip directory, which also lists folders
};

// An open archive. Owns the packed bytes, and unpacks entries on demand.
class Pk3 {
 public:
  Pk3(Pk3&&) noexcept;
  Pk3& operator=(Pk3&&) noexcept;
  ~Pk3();

  // Files in the order of the zip directory, without folders. Names may repeat; the last one counts.
  std::span<const Pk3Entry> entries() const { return entries_; }
  // The reasons why other files were left out.
  std::span<const std::string> left_out() const { return left_out_; }

  // Unpacks entries()[position]; CHECKs the position. Returns kMalformed if the data cannot be unpacked or
  // its size differs from the directory. A wrong checksum is an error only on request: other engines do not
  // compute it. Thread-safe.
  enum class Checksum { kIgnore, kVerify };
  base::Result<base::ByteVector> read(std::size_t position, Checksum checksum = Checksum::kIgnore) const;

 private:
  friend base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits);
  struct Zip;
  Pk3(std::unique_ptr<Zip> zip, std::vector<Pk3Entry> entries, std::vector<std::string> left_out);

  std::unique_ptr<Zip> zip_;
  std::vector<Pk3Entry> entries_;
  std::vector<std::string> left_out_;
};

// Opens an archive and checks its directory. Leaves out files that are encrypted or compressed by a method
// other than deflate, and those with a name that leaves the folder or an impossible size. Returns kTooLarge
// above a limit, and kMalformed if there is no directory.
base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits = {});

// Packs files in the given order. The result is reproducible: all entries have the date 1980-01-01. Names
// must be unique and satisfy is_contained_name(), or it returns kUsage.
base::Result<base::ByteVector> write_pk3(std::span<const ArchiveFile> files);

}  // namespace temblor::formats
