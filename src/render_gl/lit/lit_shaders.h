// Shader parts for tiles that show a texture times its light, without a surface block.
//
// With FILTER 0, a texel is lit at its first corner, as the CPU lights it, and shown as it is. Otherwise, the
// card blends texels (DrawOptions), and light changes within them.
#pragma once

namespace temblor::render_gl {

// Reads a tile's record. Its mapping.w holds bits: the texture's layer | level << 16 | power of two of the
// texels between samples of light << 24 | 1 << 30. image.w: the texel of the texture that the tile begins
// with.
inline constexpr const char* kLitTilePart = R"(
struct LitTile {
  vec2 last;         // texel of the tile
  vec2 first;        // texel of the texture
  vec2 light_first;  // center of the grid's first sample, in samples
  float light_layer, texture_layer, level, samples_per_texel;
};

LitTile read_lit_tile(uvec4 image, vec4 mapping) {
  uint place = floatBitsToUint(mapping.w);
  LitTile tile;
  tile.last = vec2(image.y & 0xffffu, image.y >> 16) - 1.0;
  tile.first = vec2(image.w & 0xffffu, image.w >> 16);
  tile.light_first = vec2(image.x & 0xffffu, image.x >> 16) + 0.5;
  tile.light_layer = float(image.z & 0xffffu);
  tile.texture_layer = float(place & 0xffffu);
  tile.level = float(place >> 16 & 0xffu);
  tile.samples_per_texel = exp2(-float(place >> 24 & 0x3fu));
  return tile;
}
)";

// find_light(tile, texel): the light of a texel of the tile. This one is for LightGrids. Follows
// kLightScalePart and kLitTilePart.
inline constexpr const char* kGridLightPart = R"(
uniform sampler2DArray light_grids;

vec3 find_light(LitTile tile, vec2 texel) {
  vec2 at = tile.light_first + texel * tile.samples_per_texel;
  vec2 size = vec2(textureSize(light_grids, 0).xy);
  return textureLod(light_grids, vec3(at / size, tile.light_layer), 0.0).rgb * kLightScale;
}
)";

// Follows kLitTilePart and find_light(). With one of TEXTURE_PASS, LIGHT_PASS, and BRIGHT_PASS, the color is
// that of a pass (lit_passes.h).
inline constexpr const char* kLitColorPart = R"(
uniform sampler2DArray textures;

// `at`: texels of the mip level from the tile's first one. `step_x` and `step_y`: how it changes from pixel to
// pixel.
vec3 find_lit_color(LitTile tile, vec2 at, vec2 step_x, vec2 step_y) {
  int level = int(tile.level);
  vec2 size = vec2(textureSize(textures, level).xy);
#if FILTER == 0
  vec2 texel = clamp(floor(at), vec2(0), tile.last);
  vec2 source = tile.first + texel;
  source -= floor((source + 0.5) / size) * size;
  vec4 own = texelFetch(textures, ivec3(source, tile.texture_layer), level);
#else
  vec2 texel = clamp(at, vec2(0), tile.last + 1.0);
  vec2 source = at;
#ifdef SHARP
  // Texels blend only within a pixel of their edges.
  vec2 edge = floor(source + 0.5);
  vec2 texels_per_pixel = min(max(abs(step_x), abs(step_y)), 1.0);
  source = edge + clamp((source - edge) / max(texels_per_pixel, 1e-6), -0.5, 0.5);
#endif
  vec3 place = vec3((tile.first + source) / size, tile.texture_layer);
#if FILTER == 1
  vec4 own = textureLod(textures, place, tile.level);
#else
  vec4 own = textureGrad(textures, place, step_x / size, step_y / size);
#endif
#endif
  // Full-bright texels have alpha 0.
#if defined(TEXTURE_PASS)
  return own.rgb;
#elif defined(LIGHT_PASS)
  return 0.5 * find_light(tile, texel);
#elif defined(BRIGHT_PASS)
  if (own.a > 0.5) discard;
  return own.rgb;
#endif
  return min(own.rgb * mix(vec3(1), find_light(tile, texel), own.a), 1.0);
}
)";

// Faces with one tile. The vertex shader reads the record.
inline constexpr const char* kLitVertexShader = R"(
out vec2 tile_texel;
flat out vec4 texels;   // LitTile: last, first
flat out vec4 light;    // light_first, light_layer, samples_per_texel
flat out vec2 picture;  // texture_layer, level

void main() {
#ifdef VERTEX_LIGHT
  light_vertex();
#endif
  gl_Position = project_nearer(view_axes * find_ray(), nearer);
  ivec2 record = find_record();
  vec4 mapping = uintBitsToFloat(texelFetch(records, record + ivec2(1, 0), 0));
  LitTile tile = read_lit_tile(texelFetch(records, record, 0), mapping);
  tile_texel = (texel + mapping.xy) * mapping.z;
  texels = vec4(tile.last, tile.first);
  light = vec4(tile.light_first, tile.light_layer, tile.samples_per_texel);
  picture = vec2(tile.texture_layer, tile.level);
}
)";

inline constexpr const char* kLitFragmentShader = R"(
uniform float fog_density;
uniform vec3 fog_color;

in vec2 tile_texel;
flat in vec4 texels;
flat in vec4 light;
flat in vec2 picture;
out vec4 color;

void main() {
  LitTile tile = LitTile(texels.xy, texels.zw, light.xy, light.z, picture.x, picture.y, light.w);
  color = vec4(find_lit_color(tile, tile_texel, dFdx(tile_texel), dFdy(tile_texel)), 1.0);
#ifdef FOG
  float thickness = fog_density / (64.0 * gl_FragCoord.w);
  // In 256ths, and halves are rounded up, as on the CPU.
  float share = floor((1.0 - exp(-thickness * thickness)) * 256.0 + 0.5) / 256.0;
  color.rgb = mix(color.rgb, fog_color, share) + 0.001 / 255.0;
#ifdef FOG_PASS
  color = vec4(fog_color, share);
#endif
#endif
}
)";

}  // namespace temblor::render_gl
