// The texture lump:
//
//    0  count i32
//    4  offset i32 of each texture, from the start of the lump; -1: the compiler did not find the texture
//   texture, 40 bytes and the texels:
//    0  name char[16]
//   16  width u32, height u32          texels of mip 0; multiples of 16 in stock levels
//   24  offset u32 of 4 mip levels     from the start of the texture; all 0: the texture is not in the level
//   40  palette indices u8, row by row: mip 0, then mips 1 to 3, each half as wide and high
//   version 30, after mip 3: color count u16, at most 256 | red, green, blue u8 for each color
#pragma once

#include <cstddef>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// A table that exceeds the lump ends with it. A texture whose header is outside of the lump is not present.
// One whose size is not 1..kBspMaxTextureSize, or whose mip 0 exceeds the lump, alone or together with the
// textures before it, keeps its name and has no mip levels. If only a smaller mip level is outside, it is
// sampled from mip 0, because other engines never read it. One whose palette exceeds the lump has none, which
// means the game's.
std::vector<BspMiptex> read_textures(base::Bytes lump, BspVersion version);

// Returns kTooLarge for a name over 15 characters.
// Palettes are written in version 30 only.
base::Status write_textures(base::ByteWriter& writer, const std::vector<BspMiptex>& textures,
                            BspVersion version);

}  // namespace temblor::formats::bsp_file
