#include "formats/archives/wad.h"

#include <algorithm>
#include <limits>

#include "base/text.h"

namespace temblor::formats {
namespace {

constexpr std::string_view kWadMagic = "WAD2";
constexpr std::string_view kWad3Magic = "WAD3";
constexpr std::size_t kWadHeaderBytes = 12;
constexpr std::size_t kRecordBytes = 32;

// Returns the part of `wad` that begins at `offset` and has the larger of the two sizes. If that is not
// inside, tries the smaller one, then takes what there is. Other engines do not look at sizes.
base::Bytes find_data(base::Bytes wad, std::int32_t offset, std::int32_t stored_size, std::int32_t size) {
  if (offset < 0 || std::size_t(offset) >= wad.size()) return {};
  const base::Bytes rest = wad.subspan(std::size_t(offset));
  const auto [smaller, larger] = std::minmax(stored_size, size);
  for (const std::int32_t bytes : {larger, smaller})
    if (bytes >= 0 && std::size_t(bytes) <= rest.size()) return rest.first(std::size_t(bytes));
  return rest;
}

WadLump read_record(base::ByteReader& io_reader, base::Bytes wad) {
  const std::int32_t offset = io_reader.i32();
  const std::int32_t stored_size = io_reader.i32();
  const std::int32_t size = io_reader.i32();
  const std::uint8_t type = io_reader.u8();
  io_reader.take(3);  // the compression, which no known tool uses, and padding
  std::string name = io_reader.fixed_text(kWadNameChars);
  return {std::move(name), type, find_data(wad, offset, stored_size, size)};
}

}  // namespace

base::Result<std::vector<WadLump>> read_wad(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  const std::string_view magic = base::as_text(reader.take(kWadMagic.size()));
  const std::int32_t count = reader.i32();
  const std::int32_t table_offset = reader.i32();
  if (!reader.ok())
    return base::malformed("WAD header needs {} bytes, the file has {}", kWadHeaderBytes, bytes.size());
  if (magic != kWadMagic && magic != kWad3Magic)
    return base::malformed("not a WAD file: it starts with neither \"WAD2\" nor \"WAD3\"");
  if (count < 0 || table_offset < 0 ||
      std::uint64_t(table_offset) + std::uint64_t(count) * kRecordBytes > bytes.size())
    return base::malformed("WAD table: {} lumps at offset {} are outside of the file ({} bytes)", count,
                           table_offset, bytes.size());
  reader.seek(std::size_t(table_offset));
  std::vector<WadLump> lumps;
  lumps.reserve(std::size_t(count));
  for (std::size_t i = 0; i < std::size_t(count); ++i) lumps.push_back(read_record(reader, bytes));
  return lumps;
}

bool is_wad3(base::Bytes bytes) {
  return base::as_text(bytes).starts_with(kWad3Magic);
}

base::Result<base::ByteVector> write_wad(std::span<const WadLump> lumps) {
  std::uint64_t table_offset = kWadHeaderBytes;
  for (const WadLump& lump : lumps) {
    if (lump.name.size() > kWadNameChars)
      return base::error(base::ErrorCode::kTooLarge, "\"{}\": WAD names have at most {} characters",
                         lump.name, kWadNameChars);
    table_offset += lump.data.size();
  }
  if (table_offset + lumps.size() * kRecordBytes > std::numeric_limits<std::int32_t>::max())
    return base::error(base::ErrorCode::kTooLarge, "{} bytes of lumps exceed the size limit of a WAD",
                       table_offset);

  base::ByteWriter writer;
  writer.bytes(base::as_bytes(kWadMagic));
  writer.i32(static_cast<std::int32_t>(lumps.size()));
  writer.i32(static_cast<std::int32_t>(table_offset));
  for (const WadLump& lump : lumps) writer.bytes(lump.data);
  std::size_t offset = kWadHeaderBytes;
  for (const WadLump& lump : lumps) {
    const auto size = static_cast<std::int32_t>(lump.data.size());
    writer.i32(static_cast<std::int32_t>(offset));
    writer.i32(size);
    writer.i32(size);
    writer.u8(lump.type);
    writer.u8(0);  // not compressed
    writer.u16(0);
    writer.fixed_text(lump.name, kWadNameChars);
    offset += lump.data.size();
  }
  return std::move(writer).take();
}

const WadLump* find_lump(std::span<const WadLump> lumps, std::string_view name) {
  for (const WadLump& lump : lumps)
    if (base::equal_ignoring_case(lump.name, name)) return &lump;
  return nullptr;
}

}  // namespace temblor::formats
