// The true colors of textures that have their own (formats/images/colored_texture.h), as rgb frames show
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "world/level.h"

namespace temblor::render {

// One mip level, row by row. Null: the texture has only the palette's colors, or does not glow.
struct OwnColors {
  const std::uint32_t* colors = nullptr;  // 0xffRRGGBB, or 0 where clear
  const std::uint32_t* glow = nullptr;    // 0x00RRGGBB
};

inline OwnColors own_colors(const world::Texture& texture, int mip) {
  if (!texture.colors) return {};
  const auto level = static_cast<std::size_t>(mip - texture.finest_mip());
  const formats::TextureColors& own = *texture.colors;
  return {own.colors[level].data(), own.glow.empty() ? nullptr : own.glow[level].data()};
}

// Adds the four bytes of two colors, each up to 255.
inline std::uint32_t add_saturated(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t kHigh = 0x80808080u;  // the highest bit of each byte
  const std::uint32_t low = (a & ~kHigh) + (b & ~kHigh);
  const std::uint32_t carry = ((a & b) | ((a | b) & low)) & kHigh;  // out of each byte
  return ((low ^ a ^ b) & kHigh) | (low & ~kHigh) | ((carry >> 7) * 255);
}

// A texel without light maps: full-bright, or black except for its glow.
inline std::uint32_t unlit_color(const OwnColors& own, std::size_t texel, bool is_black) {
  const std::uint32_t color = own.colors[texel];
  if (color == 0) return 0;
  const std::uint32_t base = is_black ? 0xff000000u : color;
  return own.glow == nullptr ? base : add_saturated(base, own.glow[texel]);
}

}  // namespace temblor::render
