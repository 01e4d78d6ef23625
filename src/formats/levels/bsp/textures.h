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

#include <cstddef>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// A texture whose size is not 1..kBspMaxTextureSize, or whose data exceed the lump, alone or together with
// those of the textures before it.
struct DamagedTexture {
  std::size_t index = 0;
  base::Error error;
};

struct Textures {
  std::vector<BspMiptex> textures;  // damaged ones are not present
  std::vector<DamagedTexture> damaged;
};

// `lump_offset`: of the lump in the file, for error messages. Returns an error if the table exceeds the lump,
// or if more than kMaxDamagedTextures are damaged.
constexpr std::size_t kMaxDamagedTextures = 64;
base::Result<Textures> read_textures(base::Bytes lump, std::size_t lump_offset);

// Returns kTooLarge for a name over 15 characters.
base::Status write_textures(base::ByteWriter& writer, const std::vector<BspMiptex>& textures);

}  // namespace temblor::formats::bsp_file
