// A texture of a WAD3 (Half-Life's): as in a WAD2, with a palette of its own behind the mip levels.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"
#include "formats/images/wad_texture.h"

namespace temblor::formats {

struct Wad3Texture {
  WadTexture texture;
  Palette palette{};  // entries that the file lacks are black
};

base::Result<Wad3Texture> read_wad3_texture(base::Bytes lump);

// Its own palette is cut behind the last index that is in use; otherwise as write_wad_texture.
base::Result<base::ByteVector> write_wad3_texture(const Wad3Texture& texture);

// The texture in the game's palette: each color becomes the nearest one of `dull_colors`, which are the
// game's without the full-bright ones. Full-bright
// indices stay only where the texture's palette ends with the same full-bright colors as the game's, and so
// means them. Index 255 of a texture named {... stays, being transparent.
WadTexture recolored(const Wad3Texture& texture, const Palette& game_palette,
                     const NearestColor& dull_colors);

}  // namespace temblor::formats
