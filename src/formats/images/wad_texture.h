// Textures of a WAD2 ("miptex"): a name and four mip levels of palette indices. The texture lump of a level
// has the same records (levels/bsp/textures.h).
//
//    0  name char[16]       zero-padded; prefixes such as '*' and '+' select effects (src/world)
//   16  width u32, height u32
//   24  offset u32 x4       of each mip level, from the start of the record
//   40  palette indices u8: width x height, then half, quarter, and an eighth of both sides
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMaxTextureSide = 1 << 14;  // texels

struct WadTexture {
  std::string name;                     // as stored, at most 16 characters
  std::uint32_t width = 0, height = 0;  // texels of mip 0, 1 to kMaxTextureSide
  // Mip level k: (width >> k) x (height >> k) palette indices, row by row (empty if a side is 0).
  std::array<std::vector<std::uint8_t>, 4> mips;
  bool operator==(const WadTexture&) const = default;
};

// Returns a smaller mip level, (width >> level) x (height >> level) texels of `mip0`, for files that lack it.
std::vector<std::uint8_t> sample_mip(std::span<const std::uint8_t> mip0, std::uint32_t width,
                                     std::uint32_t height, std::size_t level);

// Mip levels may be in any order. The largest must be inside of the lump; a smaller one that is not is
// sampled from it.
base::Result<WadTexture> read_wad_texture(base::Bytes lump);

// Returns kUsage for a side out of range, kTooLarge for a name over 16 characters. CHECKs the sizes of the
// mips.
base::Result<base::ByteVector> write_wad_texture(const WadTexture& texture);

}  // namespace temblor::formats
