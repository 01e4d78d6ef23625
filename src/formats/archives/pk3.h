// PK3 archives: zip files, as later engines mount them. Stored and deflated entries; no encryption, no zip64.
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

struct Pk3Limits {
  std::uint64_t unpacked_bytes = std::uint64_t{1} << 30;  // of all entries together
};

struct Pk3Entry {
  std::string name;             // as stored; is_contained_name()
  std::uint64_t size = 0;       // bytes, unpacked, as the archive states it
  std::uint64_t zip_index = 0;  // its place in the zip's directory, which also lists folders
};

// An open archive: holds the packed bytes and unpacks an entry when it is asked for.
class Pk3 {
 public:
  Pk3(Pk3&&) noexcept;
  Pk3& operator=(Pk3&&) noexcept;
  ~Pk3();

  // Files in the order of the zip's directory, without its folders. Names may repeat (the last one counts).
  std::span<const Pk3Entry> entries() const { return entries_; }

  // Unpacks entries()[position]. CHECKs the position. An error when the data is damaged, or is not as long as
  // the archive states. May be called from several threads.
  base::Result<base::ByteVector> read(std::size_t position) const;

 private:
  friend base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits);
  struct Zip;
  Pk3(std::unique_ptr<Zip> zip, std::vector<Pk3Entry> entries);

  std::unique_ptr<Zip> zip_;
  std::vector<Pk3Entry> entries_;
};

// Takes the archive over and checks its directory: kUnsupported for encryption, a packing method other than
// store and deflate, or zip64; kTooLarge over a limit; kMalformed for a name that leads outside or a size
// that its packed bytes cannot give.
base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits = {});

// Deflates the files in the order given; the same files give the same bytes (entries carry the zip epoch,
// 1980, as their date). Names must be is_contained_name() and differ.
base::Result<base::ByteVector> write_pk3(std::span<const ArchiveFile> files);

}  // namespace temblor::formats
