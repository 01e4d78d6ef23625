// Textures in the form that repeating kernels need: sizes rounded up to powers of two, so that coordinates
// wrap with a bit mask; texels in the frame's pixel format; padding after the last texel.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_block.h"
#include "world/level.h"

namespace temblor::render {

// The columns [left, left + width) of a texture's mip level.
struct TexturePart {
  const world::Texture& texture;
  int mip;
  std::uint32_t left, width;
};

// The texels belong to the arena that they were allocated in. Null: not made yet.
struct RepeatingTexture {
  const void* texels = nullptr;
  std::int32_t width = 0, height = 0;
};

// A texture of another size is stretched to the next power of two, but never beyond this width or height.
constexpr std::uint32_t kMaxRepeatingTexels = 1024;

constexpr std::uint32_t repeating_size(std::uint32_t texels) {
  return std::bit_ceil(std::clamp(texels, 1u, kMaxRepeatingTexels));
}

// `convert` maps a texel's position in the mip level, row by row, to a Texel as it is drawn.
template <typename Texel, typename Convert>
RepeatingTexture copy_repeating(const TexturePart& part, Convert convert, base::Arena& arena) {
  const std::uint32_t full_width = std::max(1u, at_mip(part.texture.width, part.mip));
  const std::uint32_t full_height = std::max(1u, at_mip(part.texture.height, part.mip));
  const std::uint32_t width = repeating_size(part.width), height = repeating_size(full_height);
  const std::span<Texel> texels = arena.allocate<Texel>(std::size_t{width} * height + kTexelPadding);
  Texel* out = texels.data();
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::size_t row = std::uint64_t{y} * full_height / height * full_width + part.left;
    if (width == part.width) {  // nearly always; a division per texel would be noticeable in the frame's time
      for (std::uint32_t x = 0; x < width; ++x) *out++ = convert(row + x);
      continue;
    }
    for (std::uint32_t x = 0; x < width; ++x) *out++ = convert(row + std::uint64_t{x} * part.width / width);
  }
  std::fill(texels.end() - kTexelPadding, texels.end(), Texel{0});
  return {texels.data(), static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)};
}

}  // namespace temblor::render
