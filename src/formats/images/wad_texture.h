// A texture of a WAD: a name and four mip levels of palette indices.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMaxTextureSide = 1 << 14;  // texels

struct WadTexture {
  std::string name;                     // as stored, at most 16 characters
  std::uint32_t width = 0, height = 0;  // texels of mip 0, 1 to kMaxTextureSide
  // Mip level k: (width >> k) x (height >> k) palette indices, row by row (empty where a side shifts to 0).
  std::array<std::vector<std::uint8_t>, 4> mips;
  bool operator==(const WadTexture&) const = default;
};

base::Result<WadTexture> read_wad_texture(base::Bytes lump);

// kUsage for a side outside its range, kTooLarge for a name over 16 characters. CHECKs the mips' sizes.
base::Result<base::ByteVector> write_wad_texture(const WadTexture& texture);

}  // namespace temblor::formats
