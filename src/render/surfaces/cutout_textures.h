// Textures with holes (fences: texels of index 255 are clear), with mip levels made for being seen through.
//
// Compilers average the clear texels' color in, and edges come out in its tint; or they keep few texels of a
// thin wire, and fences vanish far away. Here a texel of a mip level is the mean of the opaque texels of mip
// 0 under it, and whether it is opaque itself is dithered, so that as much of every part of the texture is
// opaque as in mip 0.
#pragma once

#include <cstdint>
#include <vector>

#include "render/color/color_tables.h"
#include "world/level.h"

namespace temblor::render {

constexpr std::uint8_t kClearIndex = 255;

class CutoutTextures {
 public:
  CutoutTextures() = default;
  CutoutTextures(const world::Level& level, const ColorTables& tables);

  // As it is drawn; the level's own when it has no holes. `level` is that of the constructor.
  const world::Texture& drawn(const world::Level& level, world::TextureIndex texture) const;

 private:
  static constexpr std::uint32_t kAsItIs = 0xffffffff;
  std::vector<world::Texture> remade_;
  std::vector<std::uint32_t> remade_of_;  // by texture
};

}  // namespace temblor::render
