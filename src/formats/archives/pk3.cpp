// libzip reads the archive in memory. It does not limit everything itself, so this file also checks the size
// of the central directory before libzip parses it, and the declared sizes of entries before they are
// unpacked.
#include "formats/archives/pk3.h"

#include <fmt/format.h>
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
constexpr std::string_view kZip64Locator = "PK\6\7", kZip64EndRecord = "PK\6\6";
constexpr std::string_view kDirectoryRecord = "PK\1\2";
constexpr std::size_t kDirectoryRecordBytes = 46;
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

// The place of a directory, as an end record declares it.
struct DirectoryPlace {
  std::uint64_t size = 0, offset = 0;
  std::size_t end_record = 0;  // offset of the end record
};

// Returns all places of directories, the last one last. The mark of an end record may also occur in the
// comment after it, so places that do not fit before their record are left out.
//
//   end record: "PK\5\6" | disk numbers u16 x2 | entries u16 x2 | 12: directory size u32 | offset u32 |
//   comment
std::vector<DirectoryPlace> find_directories(base::Bytes bytes) {
  constexpr std::size_t kSizeField = 12;
  const std::string_view text = base::as_text(bytes);
  std::vector<DirectoryPlace> places;
  for (std::size_t at = text.find(kEndRecord, bytes.size() - std::min(bytes.size(), kTailBytes));
       at != std::string_view::npos; at = text.find(kEndRecord, at + 1)) {
    base::ByteReader reader(bytes);
    reader.seek(at + kSizeField);
    DirectoryPlace place{reader.u32(), reader.u32(), at};
    if (reader.ok() && place.size + place.offset <= at) places.push_back(place);
  }
  return places;
}

// libzip parses the whole directory at once, so first check all sizes that it may read.
//
//   zip64 locator: "PK\6\7" | disk u32 | 8: offset of the zip64 end record u64 | ...
//   zip64 end record: "PK\6\6" | ... | 32: entries u64 | 40: directory size u64 | offset u64
base::Status check_directory_sizes(base::Bytes bytes, std::span<const DirectoryPlace> places) {
  constexpr std::size_t kPlaceField = 8, kEntriesField = 32;
  const auto too_large = [](std::uint64_t size) {
    return base::error(ErrorCode::kTooLarge, "PK3: directory of {} bytes exceeds the limit of {}", size,
                       kMaxDirectoryBytes);
  };
  for (const DirectoryPlace& place : places)
    if (place.size > kMaxDirectoryBytes) return too_large(place.size);
  const std::string_view text = base::as_text(bytes);
  for (std::size_t at = text.find(kZip64Locator, bytes.size() - std::min(bytes.size(), kTailBytes));
       at != std::string_view::npos; at = text.find(kZip64Locator, at + 1)) {
    base::ByteReader reader(bytes);
    reader.seek(at + kPlaceField);
    const std::uint64_t record = reader.read<std::uint64_t>();
    if (!reader.ok() || record > bytes.size() || !text.substr(record).starts_with(kZip64EndRecord)) continue;
    reader.seek(record + kEntriesField);
    const std::uint64_t entries = reader.read<std::uint64_t>(), size = reader.read<std::uint64_t>();
    if (size > kMaxDirectoryBytes) return too_large(size);
    if (entries > size / kDirectoryRecordBytes)
      return base::malformed("PK3: {} entries do not fit into a directory of {} bytes", entries, size);
  }
  return base::Ok{};
}

// Returns the number of bytes before the archive if the offsets in it do not count them: the directory ends
// where the end record begins.
std::size_t find_prefix_bytes(base::Bytes bytes, std::span<const DirectoryPlace> places) {
  if (places.empty() || places.back().size == 0) return 0;
  const DirectoryPlace& place = places.back();
  const std::string_view text = base::as_text(bytes);
  const bool is_at_offset = text.substr(place.offset).starts_with(kDirectoryRecord);
  const std::size_t directory = place.end_record - place.size;
  return !is_at_offset && text.substr(directory).starts_with(kDirectoryRecord) ? directory - place.offset : 0;
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
                                                   const Pk3Limits& limits,
                                                   std::vector<std::string>& out_left_out) {
  constexpr zip_uint64_t kNeeded =
      ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
  const auto count = static_cast<std::uint64_t>(std::max<zip_int64_t>(0, zip_get_num_entries(zip, 0)));
  std::vector<Pk3Entry> entries;
  std::uint64_t total = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(zip, i, ZIP_FL_ENC_RAW, &stat) != 0 || (stat.valid & kNeeded) != kNeeded) {
      out_left_out.push_back(fmt::format("PK3: entry {} of the directory is unreadable", i));
      continue;
    }
    const std::string_view name = stat.name;
    if (name.ends_with('/')) continue;  // a folder
    if (const base::Status usable = check_entry(stat, archive_bytes); !usable.ok()) {
      out_left_out.push_back(usable.error().what);
      continue;
    }
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

Pk3::Pk3(std::unique_ptr<Zip> zip, std::vector<Pk3Entry> entries, std::vector<std::string> left_out)
    : zip_(std::move(zip)), entries_(std::move(entries)), left_out_(std::move(left_out)) {}
Pk3::Pk3(Pk3&&) noexcept = default;
Pk3& Pk3::operator=(Pk3&&) noexcept = default;
Pk3::~Pk3() = default;

base::Result<base::ByteVector> Pk3::read(std::size_t position, Checksum checksum) const {
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
    if (got < 0) {
      zip_error_t* const fault = zip_file_get_error(file.get());
      const bool is_only_the_checksum = size == entry.size && zip_error_code_zip(fault) == ZIP_ER_CRC;
      if (is_only_the_checksum && checksum == Checksum::kIgnore) break;
      return base::malformed("PK3: \"{}\": {}", name, zip_error_strerror(fault));
    }
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
  const std::vector<DirectoryPlace> places = find_directories(bytes);
  if (places.empty() && base::as_text(bytes).find(kZip64Locator) == std::string_view::npos)
    return base::malformed("PK3: no zip directory: not a zip file, or truncated");
  TRY_STATUS(check_directory_sizes(bytes, places));
  const auto prefix_bytes = static_cast<std::ptrdiff_t>(find_prefix_bytes(bytes, places));
  bytes.erase(bytes.begin(), bytes.begin() + prefix_bytes);
  auto zip = std::make_unique<Pk3::Zip>();
  zip->bytes = std::move(bytes);
  ZipError error;
  SourceHandle source(zip_source_buffer_create(zip->bytes.data(), zip->bytes.size(), 0, error.get()));
  if (!source) return error.to_error(ErrorCode::kIo, "cannot be opened");
  zip->handle.reset(zip_open_from_source(source.get(), ZIP_RDONLY, error.get()));
  if (!zip->handle) return error.to_error(ErrorCode::kMalformed, "the zip directory is damaged");
  (void)source.release();  // now owned by the archive
  std::vector<std::string> left_out;
  TRY(std::vector<Pk3Entry> entries, read_directory(zip->handle.get(), zip->bytes.size(), limits, left_out));
  return Pk3(std::move(zip), std::move(entries), std::move(left_out));
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
