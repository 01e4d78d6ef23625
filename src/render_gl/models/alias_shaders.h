// The shaders that draw alias models, and the one that blends a translucent model into the picture. Colors
// keep the byte order of the CPU's pictures: blue, green, red.
//
// A vertex is a blend of two poses, and is lit by the table of the instance's lights by normal. Texels are
// interpolated in perspective, but light is linear on the screen, as on the CPU: the value times w is
// interpolated and then divided by w. Only triangles that reach behind the near plane, where that has no
// bounds, interpolate light in perspective. The fragment's color is that of lit_color() in affine_triangle.h.
// Indexed: by the colormap, then as colored light shows it; `palettes` has the player's colors. Fragment
// shaders follow look_part().
#pragma once

namespace temblor::render_gl {

inline constexpr const char* kAliasVertexShader = R"(
layout(location = 0) in uvec4 from_vertex;  // x, y, z, number of the normal
layout(location = 1) in uvec4 to_vertex;
layout(location = 2) in vec2 texel;

uniform vec4 to_view[3];  // rows: from elements of a pose to right, up, forward
uniform float pose_blend;
uniform vec4 lights[64];  // by number of the normal, four each

out vec2 skin_texel;
out vec3 light;      // the light, the light times w, and 1 at vertices behind the near plane
out float view_z;

float find_light(uint normal) {
  uint number = min(normal, 255u);
  return lights[number >> 2][number & 3u];
}

void main() {
  vec4 element = vec4(mix(vec3(from_vertex.xyz), vec3(to_vertex.xyz), pose_blend), 1.0);
  vec3 at = vec3(dot(to_view[0], element), dot(to_view[1], element), dot(to_view[2], element));
  gl_Position = project(at);
  skin_texel = texel;
  float blended = mix(find_light(from_vertex.w), find_light(to_vertex.w), pose_blend);
  light = vec3(blended, blended * gl_Position.w, is_perspective() && at.z < projection.z ? 1.0 : 0.0);
  view_z = at.z;
}
)";

// Ends before the function that finds a pixel's color, so that kTexelBlendPart can follow it.
inline constexpr const char* kAliasTexelPart = R"(
uniform usampler2DArray skins;
uniform sampler2D palettes;
uniform ivec4 skin;    // first row, layer, width, height
uniform int palette;   // row
uniform vec3 tint;     // color of the light
uniform float fog_density;
uniform vec3 fog_color;
#ifdef INDEXED
uniform sampler2D colormap;  // rows of light
uniform sampler2D tints;     // rows of colored light
uniform int tint_row;
#endif

in vec2 skin_texel;
in vec3 light;
in float view_z;
out vec4 color;

const float kBrightestLight = 32640.0, kLightAsStored = 16384.0, kDarkestRow = 16383.0;

vec4 find_texel(ivec2 texel) {
  ivec2 at = clamp(texel, ivec2(0), skin.zw - 1);
  uint index = texelFetch(skins, ivec3(at.x, at.y + skin.x, skin.y), 0).r;
  vec4 own = texelFetch(palettes, ivec2(int(index), palette), 0);
  float steps = light.z > 0.0 ? light.x : light.y * gl_FragCoord.w;
#ifdef INDEXED
  int row = int(clamp(steps, 0.0, kDarkestRow)) >> 8;
  own.r = texelFetch(colormap, ivec2(to_index(own.r), row), 0).r;
  own.r = texelFetch(tints, ivec2(to_index(own.r), tint_row), 0).r;
#else
  if (own.a > 0.5) {
    own.rgb = min(own.rgb * tint * (clamp(steps, 0.0, kBrightestLight) / kLightAsStored), 1.0);
  }
#endif
  return own;
}
)";

inline constexpr const char* kAliasFragmentShader = R"(
void main() {
#ifdef BLENDED_TEXELS
  color = blend_texels(skin_texel);
#else
  color = find_texel(ivec2(floor(skin_texel)));
#endif
  if (fog_density > 0.0) {
    float thickness = fog_density * view_z / 64.0;
#ifdef INDEXED
    color.r = fog_index(color.r, 1.0 - exp(-thickness * thickness));
#else
    color.rgb = mix(color.rgb, fog_color, 1.0 - exp(-thickness * thickness));
#endif
  }
  color.a = 1.0;
}
)";

// One triangle that covers the picture.
inline constexpr const char* kLayerVertexShader = R"(
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";

inline constexpr const char* kLayerFragmentShader = R"(
uniform sampler2D colors;
uniform sampler2D depths;
uniform float opacity;

out vec4 color;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depths, at, 0).r;
  if (depth == 0.0) discard;  // no model
  color = vec4(texelFetch(colors, at, 0).rgb, opacity);
#ifdef BLENDED
  color.r = blend_index(color.r);
#endif
  gl_FragDepth = depth;
}
)";

}  // namespace temblor::render_gl
