#include "formats/archives/pak.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace temblor::formats {
namespace {

constexpr std::string_view kPakMagic = "PACK";
constexpr std::size_t kPakNameBytes = kPakNameChars + 1;

}  // namespace

base::Result<PakHeader> read_pak_header(base::Bytes header, std::uint64_t archive_bytes) {
  base::ByteReader reader(header);
  const std::string_view magic = base::as_text(reader.take(kPakMagic.size()));
  const std::int32_t offset = reader.i32();
  const std::int32_t bytes = reader.i32();
  if (!reader.ok())
    return base::malformed("PAK header needs {} bytes, the file has {}", kPakHeaderBytes, header.size());
  if (magic != kPakMagic) return base::malformed("not a PAK file: it does not start with \"PACK\"");
  // Bytes after the last whole record do not matter.
  const std::uint64_t record_bytes = bytes < 0 ? 0 : std::uint64_t(bytes) / kPakRecordBytes * kPakRecordBytes;
  if (offset < 0 || bytes < 0 || std::uint64_t(offset) + record_bytes > archive_bytes)
    return base::malformed("PAK directory: offset {} and {} bytes are outside of the file ({} bytes)", offset,
                           bytes, archive_bytes);
  if (std::size_t(bytes) / kPakRecordBytes > kMaxPakEntries)
    return base::error(base::ErrorCode::kTooLarge, "PAK directory: {} entries, the limit is {}",
                       std::size_t(bytes) / kPakRecordBytes, kMaxPakEntries);
  return PakHeader{std::uint64_t(offset), record_bytes};
}

// Offsets and sizes are signed in the file; negative ones are like those past the end. The sum is computed in
// 64 bits, so it cannot wrap around.
std::vector<PakEntry> read_pak_directory(base::Bytes directory, std::uint64_t archive_bytes) {
  base::ByteReader reader(directory);
  std::vector<PakEntry> entries;
  entries.reserve(directory.size() / kPakRecordBytes);
  while (reader.remaining() >= kPakRecordBytes) {
    const std::string_view field = base::as_text(reader.take(kPakNameBytes));
    const std::int32_t offset = reader.i32();
    const std::int32_t size = reader.i32();
    if (offset < 0 || size < 0 || std::uint64_t(offset) + std::uint64_t(size) > archive_bytes) continue;
    entries.push_back(
        {std::string(field.substr(0, field.find('\0'))), std::uint64_t(offset), std::uint64_t(size)});
  }
  return entries;
}

base::Result<std::vector<PakEntry>> read_pak(base::Bytes archive) {
  TRY(const PakHeader header,
      read_pak_header(archive.first(std::min(archive.size(), kPakHeaderBytes)), archive.size()));
  return read_pak_directory(archive.subspan(header.directory_offset, header.directory_bytes), archive.size());
}

// Layout: header, data in the given order, directory. Checks all limits before it writes anything.
base::Result<base::ByteVector> write_pak(std::span<const ArchiveFile> files) {
  if (files.size() > kMaxPakEntries)
    return base::error(base::ErrorCode::kTooLarge, "{} files exceed the PAK limit of {}", files.size(),
                       kMaxPakEntries);
  std::uint64_t directory_offset = kPakHeaderBytes;
  for (const ArchiveFile& file : files) {
    if (file.name.size() > kPakNameChars)
      return base::error(base::ErrorCode::kTooLarge, "\"{}\": PAK names have at most {} characters",
                         file.name, kPakNameChars);
    directory_offset += file.data.size();
  }
  if (directory_offset + files.size() * kPakRecordBytes > std::numeric_limits<std::int32_t>::max())
    return base::error(base::ErrorCode::kTooLarge, "{} bytes of files exceed the size limit of a PAK",
                       directory_offset);

  base::ByteWriter writer;
  writer.bytes(base::as_bytes(kPakMagic));
  writer.i32(static_cast<std::int32_t>(directory_offset));
  writer.i32(static_cast<std::int32_t>(files.size() * kPakRecordBytes));
  for (const ArchiveFile& file : files) writer.bytes(file.data);
  std::size_t offset = kPakHeaderBytes;
  for (const ArchiveFile& file : files) {
    writer.fixed_text(file.name, kPakNameBytes);
    writer.i32(static_cast<std::int32_t>(offset));
    writer.i32(static_cast<std::int32_t>(file.data.size()));
    offset += file.data.size();
  }
  return std::move(writer).take();
}

}  // namespace temblor::formats
