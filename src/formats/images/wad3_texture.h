// Textures of a WAD3 (Half-Life). Each has its own palette, so the compiler converts them to the game's
// palette.
//
//   the record of a WAD2 texture (wad_texture.h)
//   after the last mip level:  color count u16, at most 256 | red, green, blue u8 for each color
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"
#include "formats/images/wad_texture.h"

namespace temblor::formats {

struct Wad3Texture {
  WadTexture texture;
  Palette palette{};  // entries that the file omits are black
};

// Returns kMalformed if the palette does not follow the last mip level.
base::Result<Wad3Texture> read_wad3_texture(base::Bytes lump);

// Writes the palette up to the last used index; otherwise as write_wad_texture().
base::Result<base::ByteVector> write_wad3_texture(const Wad3Texture& texture);

// Converts the texture to the game's palette: each color becomes the nearest one of `dull_colors`, the game's
// colors without the fullbright ones. Fullbright indices stay only if the texture's palette ends with the
// game's fullbright colors, which shows that it means them. Index 255 stays if the name starts with '{',
// because it is transparent.
WadTexture convert_to_palette(const Wad3Texture& texture, const Palette& game_palette,
                              const NearestColor& dull_colors);

}  // namespace temblor::formats
