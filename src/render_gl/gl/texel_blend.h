// Blends the texels of skins and sprites, which are fetched one by one: skins are indices, and sprites have
// clear texels.
#pragma once

#include <string>

#include "render_gl/draw_options.h"

namespace temblor::render_gl {

struct TexelBlend {
  bool is_on = false, is_sharp = false;
  bool operator==(const TexelBlend&) const = default;
};

inline TexelBlend find_texel_blend(const DrawOptions& options) {
  const bool is_on = options.filter != render::TextureFilter::kNearest;
  return {is_on, is_on && options.sharp_texels};
}

// A function for a fragment shader that defines find_texel(ivec2) before it, for texels anywhere: a color,
// and its share. blend_texels(at) is the mean around the point.
inline constexpr const char* kTexelBlendPart = R"(
vec4 blend_texels(vec2 at) {
#ifdef SHARP_TEXELS
  // Texels blend only within a pixel of their edges.
  vec2 texels_per_pixel = clamp(max(abs(dFdx(at)), abs(dFdy(at))), 1e-6, 1.0);
  vec2 edge = floor(at + 0.5);
  at = edge + clamp((at - edge) / texels_per_pixel, -0.5, 0.5);
#endif
  vec2 first = floor(at - 0.5), share = at - 0.5 - first;
  ivec2 from = ivec2(first);
  return mix(mix(find_texel(from), find_texel(from + ivec2(1, 0)), share.x),
             mix(find_texel(from + ivec2(0, 1)), find_texel(from + ivec2(1, 1)), share.x), share.y);
}
)";

// Precedes the source of a fragment shader.
inline std::string texel_blend_defines(const TexelBlend& blend) {
  if (!blend.is_on) return {};
  return blend.is_sharp ? "#define BLENDED_TEXELS\n#define SHARP_TEXELS\n" : "#define BLENDED_TEXELS\n";
}

}  // namespace temblor::render_gl
