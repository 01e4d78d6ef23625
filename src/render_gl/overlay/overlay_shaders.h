// Shaders of the overlay: instances are the rectangles of OverlayQuad (overlay_quads.h), without depth. Each
// pixel finds its texel in whole numbers, as the CPU does (render/screen/draw_overlay.cpp).
#pragma once

namespace temblor::render_gl {

inline constexpr const char* kOverlayVertexShader = R"(
layout(location = 0) in ivec4 rect;
layout(location = 1) in ivec4 column;
layout(location = 2) in ivec4 row;
layout(location = 3) in ivec4 paint;

uniform vec2 pixel_size;  // in clip space

flat out ivec2 first_pixel;
flat out ivec4 columns, rows, paints;

void main() {
  vec2 corner = vec2((gl_VertexID & 1) != 0 ? rect.z : rect.x, (gl_VertexID & 2) != 0 ? rect.w : rect.y);
  gl_Position = vec4(corner * pixel_size - 1.0, 0.5, 1.0);
  first_pixel = rect.xy;
  columns = column;
  rows = row;
  paints = paint;
}
)";

// Functions for the fragment shaders: find_paint() gives the pixel's color, and its opacity.
inline constexpr const char* kOverlayPart = R"(
flat in ivec2 first_pixel;
flat in ivec4 columns, rows, paints;

uniform sampler2D picture;  // indices, or the colors of a detail
uniform sampler2D colors;   // rows of 256

out vec4 color;

vec3 to_bytes(vec3 shares) { return floor(shares * 255.0 + 0.5); }

int find_texel(ivec4 axis, int pixel) { return axis.w + ((2 * pixel + 1) * axis.x + axis.y) / axis.z; }

vec4 find_own() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - first_pixel;
  return texelFetch(picture, ivec2(find_texel(columns, pixel.x), find_texel(rows, pixel.y)), 0);
}

vec4 find_paint() {
  float opacity = float(paints.y);
#ifdef DETAIL
  vec4 own = find_own();
  int alpha = int(own.a * 255.0 + 0.5);
  vec3 factor = vec3(paints.w & 255, paints.w >> 8 & 255, paints.w >> 16 & 255);
  vec3 tinted = floor((to_bytes(own.rgb) * factor + 127.5) / 255.0) / 255.0;
  return vec4(tinted, floor(float(alpha + (alpha >> 7)) * opacity / 256.0) / 256.0);
#else
#ifdef FILL
  int index = paints.z;
#else
  int index = int(find_own().r * 255.0 + 0.5);
  if (index == 255) discard;  // clear
#endif
  return vec4(texelFetch(colors, ivec2(index, paints.x), 0).rgb, opacity / 256.0);
#endif
}
)";

// The card combines the color with the picture.
inline constexpr const char* kOverlayFragmentShader = R"(
void main() { color = find_paint(); }
)";

// Combinations that cards do not offer: sums and products of colors, and whatever tables say of indices.
// `below` is a copy of the picture.
inline constexpr const char* kCombinedFragmentShader = R"(
#ifdef INDEXED
void main() { color = vec4(blend_index(find_paint().r), 0.0, 0.0, 1.0); }
#else
uniform sampler2D below;
uniform int product;  // the factor of products; 0: a sum

vec3 blend(vec3 over, vec3 under, float opacity) {
  return floor((over * opacity + under * (256.0 - opacity) + 128.0) / 256.0);
}

void main() {
  vec4 paint = find_paint();
  vec3 over = to_bytes(paint.rgb), under = to_bytes(texelFetch(below, ivec2(gl_FragCoord.xy), 0).rgb);
  float opacity = paint.a * 256.0;
  vec3 result = product == 0
      ? min(blend(over, vec3(0.0), opacity) + under, 255.0)
      : blend(min(floor((over * under * float(product) + 127.5) / 255.0), 255.0), under, opacity);
  color = vec4(result / 255.0, 1.0);
}
#endif
)";

}  // namespace temblor::render_gl
