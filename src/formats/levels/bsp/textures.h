// The texture lump:
//
//    0  count i32
//    4  offset i32 of each texture, from the start of the lump; -1: the compiler did not find the texture
//   texture, 40 bytes and the texels:
//    0  name char[16]
//   16  width u32, height u32          texels of mip 0; multiples of 16 in stock levels
//   24  offset u32 of 4 mip levels     from the start of the texture; all 0: the texture is not in the level
//   40  palette indices u8, row by row: mip 0, then mips 1 to 3, each half as wide and high
#pragma once

#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// `lump_offset`: of the lump in the file, for error messages. Returns an error if a size is
// not 1..kBspMaxTextureSize, a mip level exceeds the lump, or textures share so many bytes that their total
// exceeds the lump.
base::Result<std::vector<BspMiptex>> read_textures(base::Bytes lump, std::size_t lump_offset);

// Returns kTooLarge for a name over 15 characters.
base::Status write_textures(base::ByteWriter& writer, const std::vector<BspMiptex>& textures);

}  // namespace temblor::formats::bsp_file
