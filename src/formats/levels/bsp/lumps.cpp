#include "formats/levels/bsp/lumps.h"

#include <cstring>
#include <utility>

namespace temblor::formats::bsp_file {
namespace {

constexpr std::int32_t kVersion29 = 29;
constexpr std::int32_t kVersionHalfLife = 30;

// Four characters as the i32 that they are in the file, so that versions can be compared as numbers.
constexpr std::int32_t four_characters(std::string_view text) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<std::uint8_t>(text[i])} << (8 * i);
  return static_cast<std::int32_t>(value);
}
constexpr std::int32_t kVersion2Psb = four_characters("2PSB");
constexpr std::int32_t kVersionBsp2 = four_characters("BSP2");
constexpr std::int32_t kVersionQuake64 = four_characters("Q64 ");

std::int32_t version_word(BspVersion version) {
  switch (version) {
    case BspVersion::k29:
      return kVersion29;
    case BspVersion::k2Psb:
      return kVersion2Psb;
    case BspVersion::kBsp2:
      return kVersionBsp2;
    case BspVersion::k30:
      return kVersionHalfLife;
  }
  return 0;
}

// Returns kUnsupported for other games' versions, with their names.
base::Result<BspVersion> parse_version(std::int32_t word) {
  using base::ErrorCode;
  switch (word) {
    case kVersion29:
      return BspVersion::k29;
    case kVersion2Psb:
      return BspVersion::k2Psb;
    case kVersionBsp2:
      return BspVersion::kBsp2;
    case kVersionHalfLife:
      return BspVersion::k30;
    case kVersionQuake64:
      return error(ErrorCode::kUnsupported, "version \"Q64 \": Quake 64 levels are not supported");
    default:
      return error(ErrorCode::kUnsupported,
                   "not a Quake level: unknown version {} (known: 29, 30, 2PSB, BSP2)", word);
  }
}

// A level plays without the rest of these lumps: other code checks each range in them.
bool may_be_cut(BspLump lump) {
  return lump == BspLump::kEntities || lump == BspLump::kTextures || lump == BspLump::kVisibility ||
         lump == BspLump::kLighting;
}

bool begins_with_entity(base::Bytes lump) {
  const std::string_view text = base::as_text(lump);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

// An expansion of Half-Life has planes in the first lump and entities in the second one, under the same
// version.
void swap_back_entities(base::Bytes file, Header& io_header) {
  LumpPlace& entities = io_header.lumps[static_cast<std::size_t>(BspLump::kEntities)];
  LumpPlace& planes = io_header.lumps[static_cast<std::size_t>(BspLump::kPlanes)];
  if (!begins_with_entity(lump_bytes(file, entities)) && begins_with_entity(lump_bytes(file, planes)))
    std::swap(entities, planes);
}

LumpPlace cut_to_file(LumpPlace place, std::size_t file_size) {
  if (place.offset >= file_size) return {};
  return {place.offset, static_cast<std::uint32_t>(file_size - place.offset)};
}

}  // namespace

base::Result<Header> read_header(base::Bytes file) {
  base::ByteReader reader(file);
  const std::int32_t word = reader.i32();
  if (!reader.ok())
    return base::malformed("not a Quake level: {} bytes are too few to hold a version", file.size());
  Header header;
  TRY(header.version, parse_version(word));
  if (file.size() < kHeaderBytes)
    return base::malformed("{} bytes are shorter than the header ({} bytes)", file.size(), kHeaderBytes);

  for (std::size_t i = 0; i < kBspLumpCount; ++i) {
    const std::uint32_t offset = reader.u32(), size = reader.u32();
    if (size == 0) continue;  // the offset of an empty lump is meaningless
    const auto lump = static_cast<BspLump>(i);
    header.lumps[i] = {offset, size};
    if (std::uint64_t{offset} + size <= file.size()) continue;
    const base::Error fault =
        base::malformed("lump {}: {} bytes at offset {:#x} extend past the end of the file ({} bytes)",
                        lump_name(lump), size, offset, file.size());
    if (!may_be_cut(lump)) return fault;
    header.lumps[i] = cut_to_file(header.lumps[i], file.size());
    if (header.repairs.empty()) header.repairs = fault.what + "; the rest is missing";
  }
  if (header.version == BspVersion::k30) swap_back_entities(file, header);
  return header;
}

void begin_header(base::ByteWriter& writer, BspVersion version) {
  writer.i32(version_word(version));
  writer.bytes(std::array<std::byte, kHeaderBytes - 4>{});
}

void set_lump(base::ByteWriter& writer, BspLump lump, LumpPlace place) {
  const std::size_t entry = 4 + 8 * static_cast<std::size_t>(lump);
  writer.patch(entry, place.offset);
  writer.patch(entry + 4, place.size);
}

}  // namespace temblor::formats::bsp_file
