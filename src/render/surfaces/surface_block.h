// A surface block: the part of a face's texture that one tile shows, already lit, as plain rows of texels at
// one mip level. Abrash calls it a surface ("Quake's Lighting Model: Surface Caching").
#pragma once

#include <cstddef>
#include <cstdint>

#include "world/level.h"

namespace temblor::render {

// The size of one tile at one mip level, in texels. Rows follow one another without gaps.
struct SurfaceShape {
  std::int32_t width = 0, height = 0;
  std::size_t texels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// A size or position in texels of mip 0, in texels of `mip` (-3 to 3), rounded down.
template <typename Integer>
constexpr Integer at_mip(Integer texels, int mip) {
  return mip < 0 ? texels << -mip : texels >> mip;
}

// One tile of a face at one mip level.
struct BlockPlace {
  int tile_s, tile_t, mip;
  SurfaceShape shape;
};

// Kernels may read this many bytes past the last texel, so every block is followed by as many readable bytes.
constexpr std::size_t kBlockPadding = 64;

// A view of a block's texels; not owned. Texels start at a cache line. kIndexed: one byte per texel; kRgb:
// four bytes, 0xffRRGGBB.
struct SurfaceBlock {
  std::byte* texels = nullptr;
  SurfaceShape shape;
};

}  // namespace temblor::render
