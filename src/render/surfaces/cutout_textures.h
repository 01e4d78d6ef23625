// Alpha-tested textures (fences: texels of index 255 are clear) with mip levels made for being looked
// through.
//
// Level compilers average the clear texels' color into the mip levels, so edges are tinted; or few texels of
// a thin wire survive, so fences vanish in the distance. Here a texel of a mip level is the mean of the
// opaque texels of mip 0 under it, and its own opacity is dithered so that every part of the texture stays as
// opaque as in mip 0. Stock Quake has no such textures. Textures with colors of their own are made like this
// when they are loaded.
//
// Method of the dithering: error diffusion (Floyd and Steinberg, 1976). Abrash reports box filtering with
// error diffusion for stock Quake's mip levels too ("Quake's Lighting Model: Surface Caching").
#pragma once

#include <cstdint>
#include <vector>

#include "render/color/color_tables.h"
#include "world/level.h"

namespace temblor::render {

// The palette index of clear texels.
constexpr std::uint8_t kClearIndex = 255;

class CutoutTextures {
 public:
  CutoutTextures() = default;
  CutoutTextures(const world::Level& level, const ColorTables& tables);

  // The texture to draw; the level's own if it has no holes, or colors of its own. `level` must be the
  // constructor's.
  const world::Texture& drawn(const world::Level& level, world::TextureIndex texture) const;

 private:
  static constexpr std::uint32_t kAsItIs = 0xffffffff;
  std::vector<world::Texture> remade_;
  std::vector<std::uint32_t> remade_index_;  // by texture: index into remade_, or kAsItIs
};

}  // namespace temblor::render
