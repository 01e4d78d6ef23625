// A surface: the part of a face's texture that it shows, lit, as plain rows of pixels.
#pragma once

#include <cstddef>
#include <cstdint>

#include "world/level.h"

namespace temblor::render {

// Texels of one tile at one mip level; rows follow one another without gaps.
struct SurfaceShape {
  std::int32_t width = 0, height = 0;
  std::size_t texels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// Bytes that may be read past the last texel, so that a wide load there stays inside.
constexpr std::size_t kBlockPadding = 64;

// Not owned; starts at a cache line. kIndexed: one byte a texel; kRgb: four, 0xffRRGGBB.
struct SurfaceBlock {
  std::byte* texels = nullptr;
  SurfaceShape shape;
};

}  // namespace temblor::render
