#include "formats/archives/pk3.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "base/check.h"
#include "base/text.h"

namespace temblor::formats {

namespace {

using base::ErrorCode;

// Upper bound of deflate: a byte encodes at most four matches of 258 bytes.
constexpr std::uint64_t kMaxDeflateRatio = 1032;
// Negative for data without zlib's header, as zip has it.
constexpr int kWindowBits = -MAX_WBITS;
constexpr std::uint16_t kDosDate1980 = (1 << 5) | 1;  // January 1st
constexpr std::uint64_t kMaxFiles = std::numeric_limits<std::uint16_t>::max();
constexpr std::uint64_t kMaxBytes = std::numeric_limits<std::uint32_t>::max();

// zlib does not write to its input, although the type of the pointer allows it.
Bytef* zlib_input(base::Bytes bytes) {
  return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
}

std::uint32_t compute_crc(base::Bytes bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, zlib_input(bytes), bytes.size()));
}

// Returns nullopt unless the data unpacks to exactly `size` bytes.
std::optional<base::ByteVector> inflate_bytes(base::Bytes packed, std::uint64_t size) {
  if (packed.size() > kMaxBytes || size >= kMaxBytes) return std::nullopt;
  // One byte more shows that the data is longer.
  base::ByteVector bytes(size + 1);
  z_stream stream{};
  stream.next_in = zlib_input(packed);
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  if (inflateInit2(&stream, kWindowBits) != Z_OK) return std::nullopt;
  const bool has_ended = inflate(&stream, Z_FINISH) == Z_STREAM_END;
  inflateEnd(&stream);
  if (!has_ended || stream.total_out != size) return std::nullopt;
  bytes.resize(size);
  return bytes;
}

// Returns nullopt only if there is no memory. `bytes` has at most kMaxBytes.
std::optional<base::ByteVector> deflate_bytes(base::Bytes bytes) {
  constexpr int kMemoryLevel = 8;  // zlib's default
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindowBits, kMemoryLevel, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    return std::nullopt;
  base::ByteVector packed(deflateBound(&stream, bytes.size()));
  stream.next_in = zlib_input(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(std::min<std::uint64_t>(packed.size(), kMaxBytes));
  const bool has_ended = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  deflateEnd(&stream);
  if (!has_ended) return std::nullopt;
  packed.resize(stream.total_out);
  return packed;
}

// Checks name, encryption, compression, and size of one entry before anything is unpacked.
base::Status check_entry(const ZipRecord& entry, std::size_t archive_bytes) {
  const std::string name = base::printable(entry.name);
  if (!is_contained_name(entry.name))
    return base::malformed("PK3: \"{}\": the name leads outside of the game folder", name);
  if ((entry.flags & zip::kIsEncrypted) != 0)
    return base::error(ErrorCode::kUnsupported, "PK3: \"{}\" is encrypted; pack it without a password", name);
  if (entry.method != zip::kStored && entry.method != zip::kDeflated)
    return base::error(ErrorCode::kUnsupported,
                       "PK3: \"{}\": compression method {} is not supported; use deflate", name,
                       entry.method);
  const std::uint64_t ratio = entry.method == zip::kStored ? 1 : kMaxDeflateRatio;
  if (entry.packed_size > archive_bytes || entry.size > entry.packed_size * ratio)
    return base::malformed("PK3: \"{}\": {} bytes cannot come out of {} packed in {}", name, entry.size,
                           entry.packed_size, archive_bytes);
  return base::Ok{};
}

// Writes the fields that the local header and the directory record share.
void write_common_fields(base::ByteWriter& io_writer, const ZipRecord& entry) {
  constexpr std::uint16_t kVersion = 20;  // the first with deflate
  io_writer.u16(kVersion);
  io_writer.u16(entry.flags);
  io_writer.u16(entry.method);
  io_writer.u16(0);  // time
  io_writer.u16(kDosDate1980);
  io_writer.u32(entry.crc);
  io_writer.u32(static_cast<std::uint32_t>(entry.packed_size));
  io_writer.u32(static_cast<std::uint32_t>(entry.size));
  io_writer.u16(static_cast<std::uint16_t>(entry.name.size()));
  io_writer.u16(0);  // extra field
}

// Appends one file, deflated if that makes it smaller, and returns its record for the directory.
base::Result<ZipRecord> write_file(base::ByteWriter& io_writer, const ArchiveFile& file) {
  const auto too_large = [] { return base::error(ErrorCode::kTooLarge, "PK3: more than 4 GiB to pack"); };
  if (file.data.size() > kMaxBytes) return too_large();
  ZipRecord entry;
  entry.name = file.name;
  const bool is_ascii = std::all_of(file.name.begin(), file.name.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  entry.flags = is_ascii ? 0 : zip::kHasUtf8Name;
  entry.crc = compute_crc(file.data);
  entry.size = file.data.size();
  entry.header_offset = io_writer.size();
  const std::optional<base::ByteVector> deflated = deflate_bytes(file.data);
  const bool is_smaller = deflated && deflated->size() < file.data.size();
  const base::Bytes packed = is_smaller ? base::Bytes(*deflated) : file.data;
  entry.method = is_smaller ? zip::kDeflated : zip::kStored;
  entry.packed_size = packed.size();
  io_writer.u32(zip::kLocalHeader);
  write_common_fields(io_writer, entry);
  io_writer.bytes(base::as_bytes(entry.name));
  io_writer.bytes(packed);
  if (io_writer.size() > kMaxBytes) return too_large();
  return entry;
}

void write_directory_record(base::ByteWriter& io_writer, const ZipRecord& entry) {
  io_writer.u32(zip::kDirectoryRecord);
  io_writer.u16(20);  // version made by, on DOS
  write_common_fields(io_writer, entry);
  io_writer.u16(0);  // comment
  io_writer.u16(0);  // disk
  io_writer.u16(0);  // internal attributes
  io_writer.u32(0);  // external attributes
  io_writer.u32(static_cast<std::uint32_t>(entry.header_offset));
  io_writer.bytes(base::as_bytes(entry.name));
}

base::Status check_names(std::span<const ArchiveFile> files) {
  std::unordered_set<std::string_view> names;
  for (const ArchiveFile& file : files) {
    const std::string name = base::quotable(file.name);
    if (!is_contained_name(file.name) || file.name.size() > std::numeric_limits<std::uint16_t>::max())
      return base::error(ErrorCode::kUsage, "PK3: \"{}\" is not a valid name for a file in an archive", name);
    if (!names.insert(file.name).second)
      return base::error(ErrorCode::kUsage, "PK3: \"{}\": two files have this name", name);
  }
  return base::Ok{};
}

}  // namespace

base::Result<base::ByteVector> Pk3::read(std::size_t position, Checksum checksum) const {
  CHECK(position < entries_.size(), "{} of {}", position, entries_.size());
  const ZipRecord& entry = entries_[position];
  const std::string name = base::printable(entry.name);
  const base::Result<base::Bytes> packed = find_packed_data(bytes_, entry);
  if (!packed.ok()) return base::malformed("PK3: \"{}\": {}", name, packed.error().what);
  std::optional<base::ByteVector> bytes;
  if (entry.method == zip::kDeflated)
    bytes = inflate_bytes(*packed, entry.size);
  else if (packed->size() == entry.size)
    bytes.emplace(packed->begin(), packed->end());
  if (!bytes)
    return base::malformed("PK3: \"{}\": does not unpack to the {} bytes that the directory declares", name,
                           entry.size);
  if (checksum == Checksum::kVerify && compute_crc(*bytes) != entry.crc)
    return base::malformed("PK3: \"{}\": the checksum is wrong", name);
  return std::move(*bytes);
}

base::Result<Pk3> read_pk3(base::ByteVector bytes, const Pk3Limits& limits) {
  TRY(ZipDirectory directory, read_zip_directory(bytes));
  Pk3 pk3;
  std::uint64_t total = 0;
  for (ZipRecord& record : directory.records) {
    if (record.name.ends_with('/')) continue;  // a folder
    if (const base::Status usable = check_entry(record, bytes.size()); !usable.ok()) {
      pk3.left_out_.push_back(usable.error().what);
      continue;
    }
    total += record.size;
    if (total > limits.unpacked_bytes)
      return base::error(ErrorCode::kTooLarge,
                         "PK3: unpacks to more than {} bytes; a damaged or hostile file",
                         limits.unpacked_bytes);
    pk3.entries_.push_back(std::move(record));
  }
  if (directory.unreadable > 0)
    pk3.left_out_.push_back(
        fmt::format("PK3: {} of the directory unreadable", base::counted(directory.unreadable, "record")));
  pk3.bytes_ = std::move(bytes);
  return pk3;
}

base::Result<base::ByteVector> write_pk3(std::span<const ArchiveFile> files) {
  if (files.empty()) return base::error(ErrorCode::kUsage, "PK3: no files to pack");
  if (files.size() > kMaxFiles)
    return base::error(ErrorCode::kTooLarge, "PK3: {} files to pack, the limit is {}", files.size(),
                       kMaxFiles);
  TRY_STATUS(check_names(files));
  base::ByteWriter writer;
  std::vector<ZipRecord> entries;
  entries.reserve(files.size());
  for (const ArchiveFile& file : files) {
    TRY(ZipRecord entry, write_file(writer, file));
    entries.push_back(std::move(entry));
  }
  const std::size_t directory = writer.size();
  for (const ZipRecord& entry : entries) write_directory_record(writer, entry);
  const std::size_t directory_bytes = writer.size() - directory;
  if (writer.size() > kMaxBytes) return base::error(ErrorCode::kTooLarge, "PK3: more than 4 GiB to pack");
  writer.u32(zip::kEndRecord);
  writer.u32(0);  // disks
  writer.u16(static_cast<std::uint16_t>(entries.size()));
  writer.u16(static_cast<std::uint16_t>(entries.size()));
  writer.u32(static_cast<std::uint32_t>(directory_bytes));
  writer.u32(static_cast<std::uint32_t>(directory));
  writer.u16(0);  // comment
  return std::move(writer).take();
}

}  // namespace temblor::formats
