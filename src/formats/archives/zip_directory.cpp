#include "formats/archives/zip_directory.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace temblor::formats {

namespace {

using base::ErrorCode;

// Limits the memory for the records, which is up to three times as much.
constexpr std::uint64_t kMaxDirectoryBytes = std::uint64_t{32} << 20;
constexpr std::string_view kEndRecordText = "PK\5\6", kDirectoryRecordText = "PK\1\2";
constexpr std::uint32_t kZip64Locator = 0x07064b50, kZip64EndRecord = 0x06064b50;
constexpr std::size_t kZip64LocatorBytes = 20, kZip64EndRecordBytes = 56;
// The end record and the longest possible comment after it.
constexpr std::size_t kTailBytes = 22 + 65535;
// A number that does not fit into its field of a directory record is in the record's zip64 field instead.
constexpr std::uint32_t kIsInZip64Field = 0xffffffff;
constexpr std::uint16_t kZip64FieldId = 1;

// The place of a directory, as an end record declares it.
struct DirectoryPlace {
  std::uint64_t entries = 0, size = 0, offset = 0;
  std::uint64_t end = 0;  // offset of the end record, or of the zip64 end record
};

//   end record: "PK\5\6" | disk numbers u16 x2 | 8: entries u16 x2 | 12: directory size u32 | offset u32 |
//   comment
std::optional<DirectoryPlace> read_end_record(base::Bytes archive, std::size_t at) {
  constexpr std::size_t kEntriesField = 10;
  base::ByteReader reader(archive);
  reader.seek(at + kEntriesField);
  DirectoryPlace place;
  place.entries = reader.u16();
  place.size = reader.u32();
  place.offset = reader.u32();
  place.end = at;
  reader.u16();  // bytes of the comment
  if (!reader.ok()) return std::nullopt;
  return place;
}

// Returns the place in the zip64 records before the end record, if there are any. The locator's offset does
// not count bytes before the archive, so a record directly before the locator counts too.
//
//   zip64 locator: "PK\6\7" | disk u32 | 8: offset of the zip64 end record u64 | ...
//   zip64 end record: "PK\6\6" | ... | 32: entries u64 | 40: directory size u64 | offset u64
std::optional<DirectoryPlace> read_zip64_end_record(base::Bytes archive, std::size_t end_record) {
  constexpr std::size_t kPlaceField = 8, kEntriesField = 32;
  if (end_record < kZip64LocatorBytes + kZip64EndRecordBytes) return std::nullopt;
  const std::size_t locator = end_record - kZip64LocatorBytes;
  base::ByteReader reader(archive.first(locator + kZip64LocatorBytes));
  reader.seek(locator);
  if (reader.u32() != kZip64Locator) return std::nullopt;
  reader.seek(locator + kPlaceField);
  const auto declared = reader.read<std::uint64_t>();
  for (const std::uint64_t at : {declared, std::uint64_t{locator - kZip64EndRecordBytes}}) {
    if (at > locator - kZip64EndRecordBytes) continue;
    reader.seek(at);
    if (reader.u32() != kZip64EndRecord) continue;
    reader.seek(at + kEntriesField);
    DirectoryPlace place;
    place.entries = reader.read<std::uint64_t>();
    place.size = reader.read<std::uint64_t>();
    place.offset = reader.read<std::uint64_t>();
    place.end = at;
    return place;
  }
  return std::nullopt;
}

base::Status check_sizes(const DirectoryPlace& place) {
  if (place.size > kMaxDirectoryBytes)
    return base::error(ErrorCode::kTooLarge, "PK3: directory of {} bytes exceeds the limit of {}", place.size,
                       kMaxDirectoryBytes);
  if (place.entries > place.size / zip::kDirectoryRecordBytes)
    return base::malformed("PK3: {} entries do not fit into a directory of {} bytes", place.entries,
                           place.size);
  if (place.size > place.end || place.offset > place.end - place.size)
    return base::malformed("PK3: the zip directory is damaged: it does not end before its end record");
  return base::Ok{};
}

// Reads the numbers of a zip64 field: those that the record itself lacks, in this order.
void read_zip64_field(base::Bytes extra, ZipRecord& io_record) {
  base::ByteReader reader(extra);
  while (reader.remaining() > 0) {
    const std::uint16_t id = reader.u16(), size = reader.u16();
    base::ByteReader field(reader.take(size));
    if (id != kZip64FieldId) continue;
    for (std::uint64_t* number : {&io_record.size, &io_record.packed_size, &io_record.header_offset}) {
      if (*number != kIsInZip64Field) continue;
      const auto value = field.read<std::uint64_t>();
      if (field.ok()) *number = value;
    }
    return;
  }
}

//   directory record: "PK\1\2" | versions u16 x2 | 8: flags u16 | method u16 | time u16 | date u16 | 16: crc
//   u32 | packed size u32 | size u32 | 28: bytes of name u16, extra field u16, comment u16 | disk u16 |
//   attributes u16, u32 | 42: offset of the local header u32 | 46: name | extra field | comment
std::optional<ZipRecord> read_record(base::ByteReader& io_reader) {
  ZipRecord record;
  if (io_reader.u32() != zip::kDirectoryRecord) return std::nullopt;
  io_reader.take(2 * 2);
  record.flags = io_reader.u16();
  record.method = io_reader.u16();
  io_reader.take(2 * 2);
  record.crc = io_reader.u32();
  record.packed_size = io_reader.u32();
  record.size = io_reader.u32();
  const std::uint16_t name_bytes = io_reader.u16(), extra_bytes = io_reader.u16(),
                      comment_bytes = io_reader.u16();
  io_reader.take(2 + 2 + 4);
  record.header_offset = io_reader.u32();
  record.name = base::as_text(io_reader.take(name_bytes));
  read_zip64_field(io_reader.take(extra_bytes), record);
  io_reader.take(comment_bytes);
  if (!io_reader.ok()) return std::nullopt;
  return record;
}

// Reads the records of one directory. An end record whose directory does not begin with a record is not one:
// its mark also occurs in comments.
base::Result<ZipDirectory> read_directory_at(base::Bytes archive, const DirectoryPlace& place) {
  TRY_STATUS(check_sizes(place));
  ZipDirectory directory;
  if (place.size == 0) return directory;
  const std::string_view text = base::as_text(archive);
  std::uint64_t begin = place.offset;
  if (!text.substr(begin).starts_with(kDirectoryRecordText)) begin = place.end - place.size;
  if (!text.substr(begin).starts_with(kDirectoryRecordText))
    return base::malformed("PK3: the zip directory is damaged: it does not begin with a file");
  const std::uint64_t bytes_before = begin - place.offset;
  base::ByteReader reader(archive.subspan(begin, place.size));
  // Old programs wrote more than 65,535 records and only the low bits of their number.
  while (reader.remaining() >= zip::kDirectoryRecordBytes) {
    std::optional<ZipRecord> record = read_record(reader);
    if (!record) break;
    record->header_offset += bytes_before;
    directory.records.push_back(std::move(*record));
  }
  directory.unreadable = place.entries - std::min<std::uint64_t>(place.entries, directory.records.size());
  return directory;
}

}  // namespace

base::Result<ZipDirectory> read_zip_directory(base::Bytes archive) {
  const std::size_t tail_offset = archive.size() - std::min(archive.size(), kTailBytes);
  std::string_view tail = base::as_text(archive.subspan(tail_offset));
  std::optional<base::Error> fault;  // of the last end record
  for (std::size_t at = tail.rfind(kEndRecordText); at != std::string_view::npos;
       tail = tail.substr(0, at), at = tail.rfind(kEndRecordText)) {
    std::optional<DirectoryPlace> place = read_zip64_end_record(archive, tail_offset + at);
    if (!place) place = read_end_record(archive, tail_offset + at);
    if (!place) continue;
    base::Result<ZipDirectory> directory = read_directory_at(archive, *place);
    if (directory.ok()) return directory;
    if (!fault) fault = directory.error();
  }
  if (fault) return *fault;
  return base::malformed("PK3: no zip directory: not a zip file, or truncated");
}

//   local header: "PK\3\4" | ... | 26: bytes of name u16, extra field u16 | 30: name | extra field | packed
//   data
base::Result<base::Bytes> find_packed_data(base::Bytes archive, const ZipRecord& record) {
  constexpr std::size_t kLengthsField = 26;
  const auto damaged = [] { return base::malformed("its data is not in the archive"); };
  if (record.header_offset > archive.size() || record.packed_size > archive.size()) return damaged();
  base::ByteReader reader(archive.subspan(record.header_offset));
  if (reader.u32() != zip::kLocalHeader) return damaged();
  reader.seek(kLengthsField);
  const std::uint16_t name_bytes = reader.u16(), extra_bytes = reader.u16();
  reader.take(std::size_t{name_bytes} + extra_bytes);
  const base::Bytes packed = reader.take(record.packed_size);
  if (!reader.ok()) return damaged();
  return packed;
}

}  // namespace temblor::formats
