#include "formats/levels/bsp/lumps.h"

#include <cstring>

namespace temblor::formats::bsp_file {
namespace {

constexpr std::int32_t kVersion29 = 29;
constexpr std::int32_t kVersionHalfLife = 30;

constexpr std::int32_t four_characters(std::string_view text) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<std::uint8_t>(text[i])} << (8 * i);
  return static_cast<std::int32_t>(value);
}
constexpr std::int32_t kVersion2Psb = four_characters("2PSB");
constexpr std::int32_t kVersionBsp2 = four_characters("BSP2");
constexpr std::int32_t kVersionQuake64 = four_characters("Q64 ");

std::int32_t word_of(BspVersion version) {
  switch (version) {
    case BspVersion::k29:
      return kVersion29;
    case BspVersion::k2Psb:
      return kVersion2Psb;
    case BspVersion::kBsp2:
      return kVersionBsp2;
  }
  return 0;
}

base::Result<BspVersion> version_of(std::int32_t word) {
  using base::ErrorCode;
  switch (word) {
    case kVersion29:
      return BspVersion::k29;
    case kVersion2Psb:
      return BspVersion::k2Psb;
    case kVersionBsp2:
      return BspVersion::kBsp2;
    case kVersionHalfLife:
      return error(ErrorCode::kUnsupported, "version 30: Half-Life's levels are not supported");
    case kVersionQuake64:
      return error(ErrorCode::kUnsupported, "version \"Q64 \": Quake 64's levels are not supported");
    default:
      return error(ErrorCode::kUnsupported, "not a Quake level: unknown version {} (known: 29, 2PSB, BSP2)",
                   word);
  }
}

}  // namespace

base::Result<Header> read_header(base::Bytes file) {
  base::ByteReader reader(file);
  const std::int32_t word = reader.i32();
  if (!reader.ok())
    return base::malformed("not a Quake level: {} bytes are too few to hold a version", file.size());
  Header header;
  TRY(header.version, version_of(word));
  if (file.size() < kHeaderBytes)
    return base::malformed("{} bytes are too few for the header ({} bytes)", file.size(), kHeaderBytes);

  std::uint64_t total = 0;
  for (std::size_t i = 0; i < kBspLumpCount; ++i) {
    const std::uint32_t offset = reader.u32(), size = reader.u32();
    if (size == 0) continue;  // where an empty lump lies says nothing
    if (std::uint64_t{offset} + size > file.size())
      return base::malformed("lump {}: {} bytes at offset {:#x} reach past the end of the file ({} bytes)",
                             name_of(static_cast<BspLump>(i)), size, offset, file.size());
    header.lumps[i] = {offset, size};
    total += size;
  }
  if (total > file.size())
    return base::malformed("lumps overlap: together they have {} bytes, the file {}", total, file.size());
  return header;
}

void begin_header(base::ByteWriter& writer, BspVersion version) {
  writer.i32(word_of(version));
  writer.bytes(std::array<std::byte, kHeaderBytes - 4>{});
}

void set_lump(base::ByteWriter& writer, BspLump lump, LumpPlace place) {
  const std::size_t entry = 4 + 8 * static_cast<std::size_t>(lump);
  writer.patch(entry, place.offset);
  writer.patch(entry + 4, place.size);
}

}  // namespace temblor::formats::bsp_file
