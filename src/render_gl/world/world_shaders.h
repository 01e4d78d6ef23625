// The shaders that draw faces of the level. Colors keep the byte order of the CPU's pictures: blue, green,
// red.
//
// A fragment reads the record of its tile (tile_table.h), and then one texel of the atlas. So it shows the
// texel that the CPU shows: mip levels, light, and marks are those of the CPU's surface blocks.
#pragma once

namespace temblor::render_gl {

inline constexpr const char* kWorldVertexShader = R"(
out vec2 face_texel;
out vec3 ray;
out float view_distance;  // along the view
flat out uvec2 face_tiles;

void main() {
#ifdef VERTEX_LIGHT
  light_vertex();
#endif
  ray = find_ray();
  vec3 at = view_axes * ray;
  view_distance = at.z;
  if (!is_perspective()) ray = vec3(view_axes[0][2], view_axes[1][2], view_axes[2][2]);
  gl_Position = project_nearer(at, nearer);
  face_texel = texel;
  face_tiles = uvec2(tiles.x + first_record, tiles.y);
}
)";

// KIND is defined as one of the kinds below, and FOG if there is fog. FILTER and SHARP: lit_shaders.h;
// textures without light and blocks are blended between four texels if FILTER is not 0. Follows look_part().
inline constexpr const char* kWorldFragmentShader = R"(
uniform usampler2D records;
uniform sampler2DArray atlas;
uniform bool has_color_key;  // the atlas has no alpha: texels of the first and last color only are clear
uniform sampler2DArray skybox;  // sides +x, +y, -x, -y, +z, -z with borders of one texel
uniform float liquid_phase;  // texels
uniform vec2 sky_scroll;     // texels of layers with 128 texels: the clouds', the background's
uniform float fog_density;
uniform vec3 fog_color;

in vec2 face_texel;
in vec3 ray;
in float view_distance;
flat in uvec2 face_tiles;
out vec4 color;

const uint kHidden = 0u, kBlock = 1u, kRepeat = 2u, kLiquid = 3u, kSky = 4u, kSkybox = 5u, kLit = 6u;
const float kTileTexels = 256.0;
const float kTurn = 6.28318530718 / 128.0;

ivec2 unpack(uint two) { return ivec2(two & 0xffffu, two >> 16); }

vec4 atlas_texel(ivec2 at, int layer) {
  vec4 texel = texelFetch(atlas, ivec3(at, layer), 0);
#ifdef INDEXED
  return vec4(texel.r, 0, 0, texel.r < 1.0);
#endif
  return has_color_key && texel.rgb == vec3(1, 0, 1) ? vec4(0) : texel;
}

vec4 one_repeated_texel(vec2 at, ivec2 first, ivec2 size, int layer) {
  ivec2 whole = ivec2(floor(at - floor(at / vec2(size)) * vec2(size)));
  return atlas_texel(first + clamp(whole, ivec2(0), size - 1), layer);
}

vec4 block_texel(vec2 at, ivec2 first, ivec2 size, int layer) {
  return atlas_texel(first + clamp(ivec2(floor(at)), ivec2(0), size - 1), layer);
}

#if FILTER == 0
vec4 repeated_texel(vec2 at, ivec2 first, ivec2 size, int layer) {
  return one_repeated_texel(at, first, size, layer);
}
vec4 block_color(vec2 at, ivec2 first, ivec2 size, int layer) { return block_texel(at, first, size, layer); }
#else
// Clear texels have a part in the opacity only.
vec4 blend(vec4 a, vec4 b, vec4 c, vec4 d, vec2 share) {
  vec4 shares = vec4((1.0 - share.x) * (1.0 - share.y), share.x * (1.0 - share.y), (1.0 - share.x) * share.y,
                     share.x * share.y) * vec4(a.a, b.a, c.a, d.a);
  float sum = dot(shares, vec4(1));
  return vec4((a.rgb * shares.x + b.rgb * shares.y + c.rgb * shares.z + d.rgb * shares.w) / max(sum, 1e-6), sum);
}

// The position between the centers of four texels; with SHARP, within a pixel of their edges only.
vec2 find_share(vec2 at) {
  vec2 share = fract(at - 0.5);
#ifdef SHARP
  vec2 texels_per_pixel = clamp(max(abs(dFdx(at)), abs(dFdy(at))), 1e-6, 1.0);
  share = clamp((share - 0.5) / texels_per_pixel + 0.5, 0.0, 1.0);
#endif
  return share;
}

vec4 repeated_texel(vec2 at, ivec2 first, ivec2 size, int layer) {
  vec2 corner = at - 0.5;
  return blend(one_repeated_texel(corner, first, size, layer),
               one_repeated_texel(corner + vec2(1, 0), first, size, layer),
               one_repeated_texel(corner + vec2(0, 1), first, size, layer),
               one_repeated_texel(corner + vec2(1, 1), first, size, layer), find_share(at));
}

vec4 block_color(vec2 at, ivec2 first, ivec2 size, int layer) {
  vec2 corner = at - 0.5;
  return blend(block_texel(corner, first, size, layer), block_texel(corner + vec2(1, 0), first, size, layer),
               block_texel(corner + vec2(0, 1), first, size, layer),
               block_texel(corner + vec2(1, 1), first, size, layer), find_share(at));
}
#endif

// Two layers on a dome whose height is stretched threefold.
vec4 sky_texel(uvec4 image, ivec2 size, int layer) {
  float scale = float(size.x) / 128.0;
  vec3 direction = vec3(ray.xy, 3.0 * ray.z);
  vec2 at = direction.xy * (378.0 * scale / length(direction));
  vec4 clouds = repeated_texel(at + sky_scroll.x * scale, unpack(image.x), size, layer);
#ifdef INDEXED
  clouds.a = clouds.r;
  if (clouds.a > 0.0) return clouds;
#endif
#if FILTER == 0
  if (clouds.a > 0.5) return clouds;
#endif
  ivec2 back = ivec2(image.w & 0xffu, image.w >> 8 & 0xffu) * 8;
  vec4 background = repeated_texel(at + sky_scroll.y * scale, back, size, int(image.w >> 16));
#if FILTER == 0
  return background;
#else
  // A return before this would leave neighbors without derivatives. The edges of clouds blend, too.
  return vec4(mix(background.rgb, clouds.rgb, clouds.a), 1.0);
#endif
}

// The ray's largest component selects the side. Four texels are interpolated, in 256ths as on the CPU.
vec4 skybox_texel(int size) {
  vec3 extent = abs(ray);
  vec3 at;  // rightward, downward, and the side
  float largest;
  if (extent.x >= extent.y && extent.x >= extent.z) {
    at = ray.x > 0.0 ? vec3(-ray.y, -ray.z, 0) : vec3(ray.y, -ray.z, 2);
    largest = extent.x;
  } else if (extent.y >= extent.z) {
    at = ray.y > 0.0 ? vec3(ray.x, -ray.z, 1) : vec3(-ray.x, -ray.z, 3);
    largest = extent.y;
  } else {
    at = ray.z > 0.0 ? vec3(-ray.y, ray.x, 4) : vec3(-ray.y, -ray.x, 5);
    largest = extent.z;
  }
  float radius = 0.5 * float(size);
  vec2 place = at.xy / largest * radius + (radius + 0.5);
#ifdef INDEXED
  return texelFetch(skybox, ivec3(place + 0.5, at.z), 0);
#endif
  ivec3 first = ivec3(place, at.z);
  vec2 share = floor(fract(place) * 256.0) / 256.0;
  vec4 above = mix(texelFetch(skybox, first, 0), texelFetch(skybox, first + ivec3(1, 0, 0), 0), share.x);
  vec4 below = mix(texelFetch(skybox, first + ivec3(0, 1, 0), 0), texelFetch(skybox, first + ivec3(1, 1, 0), 0), share.x);
  return mix(above, below, share.y);
}

void main() {
  vec2 texel_step_x = dFdx(face_texel), texel_step_y = dFdy(face_texel);
  uint number = face_tiles.x;
  ivec2 grid = unpack(face_tiles.y);
  if (grid.x > 1 || grid.y > 1) {
    ivec2 tile = clamp(ivec2(floor(face_texel / kTileTexels)), ivec2(0), grid - 1);
    number += uint(tile.y * grid.x + tile.x);
  }
  ivec2 record = ivec2(number % 512u * 2u, number / 512u);
  uvec4 image = texelFetch(records, record, 0);
  vec4 mapping = uintBitsToFloat(texelFetch(records, record + ivec2(1, 0), 0));
  const uint kind = KIND;
  if ((image.z >> 16 & 0xfu) == kHidden) discard;
  ivec2 first = unpack(image.x), size = unpack(image.y);
  int layer = int(image.z & 0xffffu);
  vec2 at = face_texel + mapping.xy;
  if ((image.z >> 20 & 3u) == 2u) {
    color = vec4(1);  // one color replaces it
  } else if (kind == kBlock) {
    color = block_color(at * mapping.zw, first, size, layer);
  } else if (kind == kLit) {
    color = vec4(find_lit_color(read_lit_tile(image, mapping), at * mapping.z, texel_step_x * mapping.z,
                                texel_step_y * mapping.z), 1.0);
  } else if (kind == kSky) {
    color = sky_texel(image, size, layer);
  } else if (kind == kSkybox) {
    color = skybox_texel(textureSize(skybox, 0).x - 2);
  } else {
    if (kind == kLiquid) at += 8.0 * (1.0 + sin((at.yx + liquid_phase) * kTurn));
    color = repeated_texel(at * mapping.zw, first, size, layer);
  }
  if ((image.z >> 20 & 1u) != 0u && color.a < 0.5) discard;
  if (kind != kLit && (image.z >> 21 & 1u) != 0u)
    color = vec4(image.w & 0xffu, image.w >> 8 & 0xffu, image.w >> 16, 255) / 255.0;
#ifdef FOG
  if ((image.z >> 22 & 1u) == 0u) {
    float thickness = fog_density / 64.0 * max(view_distance, 0.0);
#ifdef INDEXED
    color.r = fog_index(color.r, kind == kSky || kind == kSkybox ? 0.5 : 1.0 - exp(-thickness * thickness));
#else
    // In 256ths, and halves are rounded up, as on the CPU.
    float share = kind == kSky || kind == kSkybox ? 0.5 : floor((1.0 - exp(-thickness * thickness)) * 256.0 + 0.5) / 256.0;
    color.rgb = mix(color.rgb, fog_color, share) + 0.001 / 255.0;
#ifdef FOG_PASS
    color = vec4(fog_color, share);
    return;
#endif
#endif
  }
#endif
#ifdef BLENDED
  color.r = blend_index(color.r);
#endif
  color.a = float(image.z >> 24) / 255.0;
}
)";

}  // namespace temblor::render_gl
