// The shaders that draw most of a level: faces with one tile, which show its surface block. Graphics cards
// without hardware (llvmpipe) run all branches of a shader, so these have none; the other faces are drawn by
// those of world_shaders.h.
#pragma once

namespace temblor::render_gl {

inline constexpr const char* kBlockVertexShader = R"(
out vec2 block_texel;
flat out ivec4 place;  // x, y in the atlas; the last texel of the block
flat out int layer;

void main() {
  gl_Position = project_nearer(view_axes * find_ray(), nearer);
  ivec2 record = find_record();
  uvec4 image = texelFetch(records, record, 0);
  vec4 mapping = uintBitsToFloat(texelFetch(records, record + ivec2(1, 0), 0));
  block_texel = (texel + mapping.xy) * mapping.zw;
  place = ivec4(image.x & 0xffffu, image.x >> 16, (image.y & 0xffffu) - 1u, (image.y >> 16) - 1u);
  layer = int(image.z & 0xffffu);
}
)";

// With FOG defined, it adds fog. FILTER is 0: with a filter, the program of several blocks is used.
inline constexpr const char* kBlockFragmentShader = R"(
uniform sampler2DArray atlas;
uniform float fog_density;
uniform vec3 fog_color;

in vec2 block_texel;
flat in ivec4 place;
flat in int layer;
out vec4 color;

void main() {
  ivec2 at = clamp(ivec2(floor(block_texel)), ivec2(0), place.zw);
  color = vec4(texelFetch(atlas, ivec3(place.xy + at, layer), 0).rgb, 1.0);
#ifdef FOG
  float thickness = fog_density / (64.0 * gl_FragCoord.w);
#ifdef INDEXED
  color.r = fog_index(color.r, 1.0 - exp(-thickness * thickness));
#else
  // In 256ths, and halves are rounded up, as on the CPU.
  float share = floor((1.0 - exp(-thickness * thickness)) * 256.0 + 0.5) / 256.0;
  color.rgb = mix(color.rgb, fog_color, share) + 0.001 / 255.0;
#endif
#endif
}
)";

}  // namespace temblor::render_gl
