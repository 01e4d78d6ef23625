// libzip reads the archive in memory. It does not limit everything itself, so this file also checks the size
// of the central directory before libzip parses it, and the declared sizes of entries before they are
// unpacked.
#include "formats/archives/pk3.h"

#include <zip.h>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "base/text.h"

namespace temblor::formats {

namespace {

using base::ErrorCode;

// libzip keeps about 300 bytes for each directory record of at least 46.
constexpr std::uint64_t kMaxDirectoryBytes = std::uint64_t{32} << 20;
// Upper bound of deflate: a byte encodes at most four matches of 258 bytes.
constexpr std::uint64_t kMaxDeflateRatio = 1032;
constexpr std::string_view kEndRecord = "PK\5\6";
constexpr std::string_view kZip64Locator = "PK\6\7";
// The end record, the longest possible comment after it, and the zip64 locator before it.
constexpr std::size_t kTailBytes = 65536 + 22 + 20;
constexpr zip_uint16_t kDosDate1980 = (1 << 5) | 1;  // January 1st

// Owns the error object of libzip calls that have no archive yet.
class ZipError {
 public:
  ZipError() { zip_error_init(&error_); }
  ~ZipError() { zip_error_fini(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;

  zip_error_t* get() { return &error_; }
  base::Error to_error(ErrorCode code, std::string_view what) {
    return base::error(code, "PK3: {}: {}", what, zip_error_strerror(&error_));
  }

 private:
  zip_error_t error_;
};

struct DiscardZip {
  void operator()(zip_t* zip) const { zip_discard(zip); }
};
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using ZipHandle = std::unique_ptr<zip_t, DiscardZip>;
using SourceHandle = std::unique_ptr<zip_source_t, FreeSource>;
using FileHandle = std::unique_ptr<zip_file_t, CloseFile>;

// libzip parses the whole directory at once, so first check the size that the end record declares. The mark
// of an end record may also occur in the comment after it, and libzip may choose any of them, so check all:
//
//   end record: "PK\5\6" | disk numbers u16 x2 | entries u16 x2 | 12: directory size u32 | offset u32 |
//   comment
base::Status check_directory_size(base::Bytes bytes) {
  const std::string_view tail = base::as_text(bytes.last(std::min(bytes.size(), kTailBytes)));
  if (tail.find(kZip64Locator) != std::string_view::npos)
    return base::error(ErrorCode::kUnsupported, "PK3: zip64 is not supported; save it as an ordinary zip");
  std::size_t position = tail.find(kEndRecord);
  if (position == std::string_view::npos)
    return base::malformed("PK3: no zip directory: not a zip file, or truncated");
  for (; position != std::string_view::npos; position = tail.find(kEndRecord, position + 1)) {
    constexpr std::size_t kSizeField = 12;
    base::ByteReader reader(base::as_bytes(tail));
    reader.seek(position + kSizeField);
    if (const std::uint32_t size = reader.u32(); reader.ok() && size > kMaxDirectoryBytes)
      return base::error(ErrorCode::kTooLarge, "PK3: directory of {} bytes exceeds the limit of {}", size,
                         kMaxDirectoryBytes);
  }
  return base::Ok{};
}

// Checks name, encryption, compression, and size of one entry before anything is unpacked.
base::Status check_entry(const zip_stat_t& stat, std::size_t archive_bytes) {
  const std::string name = base::printable(stat.name);
  if (!is_contained_name(stat.name))
    return base::malformed("PK3: \"{}\": the name leads outside of the game folder", name);
  if (stat.encryption_method != ZIP_EM_NONE)
    return base::error(ErrorCode::kUnsupported, "PK3: \"{}\" is encrypted; pack it without a password", name);
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    return base::error(ErrorCode::kUnsupported,
                       "PK3: \"{}\": compression method {} is not supported; use deflate", name,
                       stat.comp_method);
  const std::uint64_t ratio = stat.comp_method == ZIP_CM_STORE ? 1 : kMaxDeflateRatio;
  if (stat.comp_size > archive_bytes || stat.size > stat.comp_size * ratio)
    return base::malformed("PK3: \"{}\": {} bytes cannot come out of {} packed in {}", name, stat.size,
                           stat.comp_size, archive_bytes);
  return base::Ok{};
}

base::Result<std::vector<Pk3Entry>> read_directory(zip_t* zip, std::size_t archive_bytes,
                                                   const Pk3Limits& limits) {
  constexpr zip_uint64_t kNeeded =
      ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
  const auto count = static_cast<std::uint64_t>(std::max<zip_int64_t>(0, zip_get_num_entries(zip, 0)));
  std::vector<Pk3Entry> entries;
  std::uint64_t total = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(zip, i, ZIP_FL_ENC_RAW, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
      return base::malformed("PK3: entry {} of the directory is unreadable", i);
    const std::string_view name = stat.name;
    if (name.ends_with('/')) continue;  // a folder
    TRY_STATUS(check_entry(stat, archive_bytes));
    total += stat.size;
    if (total > limits.unpacked_bytes)
      return base::error(ErrorCode::kTooLarge,
                         "PK3: unpacks to more than {} bytes; a damaged or hostile file",
                         limits.unpacked_bytes);
    entries.push_back({std::string(name), stat.size, i});
  }
  return entries;
}

// Adds one file to a new archive. libzip reads file.data only when the archive is closed.
base::Status add_file(zip_t* zip, const ArchiveFile& file) {
  if (!is_contained_name(file.name))
    return base::error(ErrorCode::kUsage, "PK3: \"{}\" is not a valid name for a file in an archive",
                       base::printable(file.name));
  const auto failed = [&] {
    return base::error(ErrorCode::kUsage, "PK3: \"{}\": {}", base::printable(file.name), zip_strerror(zip));
  };
  SourceHandle source(zip_source_buffer(zip, file.data.data(), file.data.size(), 0));
  if (!source) return failed();
  const zip_int64_t index = zip_file_add(zip, file.name.c_str(), source.get(), 0);
  if (index < 0) return failed();
  (void)source.release();  // now owned by the archive
  const auto position = static_cast<zip_uint64_t>(index);
  if (zip_set_file_compression(zip, position, ZIP_CM_DEFLATE, 0) != 0 ||
      zip_file_set_dostime(zip, position, 0, kDosDate1980, 0) != 0)
    return failed();
  return base::Ok{};
}

// Copies the archive that libzip has written to memory.
base::Result<base::ByteVector> read_source(zip_source_t* source) {
  const auto failed = [&] {
    return base::error(ErrorCode::kIo, "PK3: {}", zip_error_strerror(zip_source_error(source)));
  };
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) return failed();
  base::ByteVector bytes(stat.size);
  const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (got != static_cast<zip_int64_t>(bytes.size())) return failed();
  return bytes;
}

}  // namespace

struct Pk3::Zip {
  base::ByteVector bytes;  // outlives `handle`, which reads from it
  ZipHandle handle;
  std::mutex mutex;  // libzip's handle is not thread-safe, not even for reading
};

Pk3::Pk3(std::unique_ptr<Zip> zip, std::vector<Pk3Entry> entries)
    : zip_(std::move(zip)), entries_(std::move(entries)) {}
Pk3::Pk3(Pk3&&) noexcept = default;
Pk3& Pk3::operator=(Pk3&&) noexcept = default;
Pk3::~Pk3() = default;

base::Result<base::ByteVector> Pk3::read(std::size_t position) const {
  CHECK(position < entries_.size(), "{} of {}", position, entries_.size());
  const Pk3Entry& entry = entries_[position];
  const std::string name = base::printable(entry.name);
  const std::scoped_lock lock(zip_->mutex);
  const FileHandle file(zip_fopen_index(zip_->handle.get(), entry.zip_index, 0));
  if (!file) return base::malformed("PK3: \"{}\": {}", name, zip_strerror(zip_->handle.get()));
  // Request one byte more than declared: libzip verifies the checksum only at the end of the data.
  base::ByteVector bytes(entry.size + 1);
  std::size_t size = 0;
  while (size < bytes.size()) {
    const zip_int64_t got = zip_fread(file.get(), bytes.data() + size, bytes.size() - size);
    if (got < 0)
      return base::malformed("PK3: \"{}\": {}", name, zip_error_strerror(zip_file_get_error(file.get())));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size != entry.size)
    return base::malformed("PK3: \"{}\": does not unpack to the {} bytes that the directory declares", name,
                           entry.size);
  bytes.resize(size);
  return bytes;
}

base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits) {
  TRY_STATUS(check_directory_size(bytes));
  auto zip = std::make_unique<Pk3::Zip>();
  zip->bytes = std::move(bytes);
  ZipError error;
  SourceHandle source(zip_source_buffer_create(zip->bytes.data(), zip->bytes.size(), 0, error.get()));
  if (!source) return error.to_error(ErrorCode::kIo, "cannot be opened");
  zip->handle.reset(zip_open_from_source(source.get(), ZIP_RDONLY, error.get()));
  if (!zip->handle) return error.to_error(ErrorCode::kMalformed, "the zip directory is damaged");
  (void)source.release();  // now owned by the archive
  TRY(std::vector<Pk3Entry> entries, read_directory(zip->handle.get(), zip->bytes.size(), limits));
  return Pk3(std::move(zip), std::move(entries));
}

base::Result<base::ByteVector> write_pk3(std::span<const ArchiveFile> files) {
  if (files.empty()) return base::error(ErrorCode::kUsage, "PK3: no files to pack");
  ZipError error;
  const SourceHandle source(zip_source_buffer_create(nullptr, 0, 0, error.get()));
  if (!source) return error.to_error(ErrorCode::kIo, "cannot be created");
  zip_source_keep(
      source.get());  // one reference for the archive, released when it is closed; one to read the result
  ZipHandle zip(zip_open_from_source(source.get(), ZIP_TRUNCATE, error.get()));
  if (!zip) {
    zip_source_free(source.get());
    return error.to_error(ErrorCode::kIo, "cannot be created");
  }
  for (const ArchiveFile& file : files) TRY_STATUS(add_file(zip.get(), file));
  if (zip_close(zip.get()) != 0)
    return base::error(ErrorCode::kIo, "PK3: packing failed: {}", zip_strerror(zip.get()));
  (void)zip.release();  // closing freed it
  return read_source(source.get());
}

}  // namespace temblor::formats
