// The shader part that computes light from stored light maps and dynamic lights (style_method.h).
#pragma once

namespace temblor::render_gl {

// For fragment shaders, in place of kGridLightPart. Follows kLightScalePart and kLitTilePart. A tile's record
// has the number of its face in image.x, and its column | row << 8 in the low half of image.z. Formulas and
// their order are those of render/surfaces/light; 1 is full light.
inline constexpr const char* kStyleLightPart = R"(
uniform sampler2D style_samples;
uniform usampler2D style_faces;
uniform vec4 style_values[16];
uniform bool has_colored_light;
uniform sampler2D dynamic_lights;
uniform int light_count;
uniform mat3 model_axes;
uniform vec3 model_origin;

// The samples at the corners of a cell: left and right ones above, and below.
struct Cell { vec3 a, b, c, d; };

vec3 read_sample(uint number) {
  vec4 stored = texelFetch(style_samples, ivec2(number & 2047u, number >> 11), 0);
  return has_colored_light ? stored.rgb : stored.aaa;
}

// Colored light that exceeds full light keeps its hue.
vec3 limit_light(vec3 light) {
  float brightest = max(max(light.r, light.g), light.b);
  return has_colored_light && brightest > 1.0 ? light / brightest : light;
}

Cell add_styles(uvec4 face, ivec2 cell, ivec2 next) {
  ivec2 size = ivec2(face.y & 0xffffu, face.y >> 16);
  uvec4 at = uvec4(ivec4(cell.x, next.x, cell.x, next.x) + ivec4(cell.yy, next.yy) * size.x) + face.x;
  Cell sum = Cell(vec3(0), vec3(0), vec3(0), vec3(0));
  uint styles = face.z;
  for (uint i = 0u; i < face.w; ++i, styles >>= 8, at += uint(size.x * size.y)) {
    float value = style_values[styles >> 2 & 15u][styles & 3u];
    sum.a += read_sample(at.x) * value;
    sum.b += read_sample(at.y) * value;
    sum.c += read_sample(at.z) * value;
    sum.d += read_sample(at.w) * value;
  }
  return Cell(limit_light(sum.a), limit_light(sum.b), limit_light(sum.c), limit_light(sum.d));
}

vec4 read_face(ivec2 place, int number) { return uintBitsToFloat(texelFetch(style_faces, place + ivec2(number, 0), 0)); }

// Distances on the face, in units, from a light to the cell's corners: the longer offset and half of the shorter one.
vec4 find_distances(vec4 along_s, vec4 along_t) { return max(along_s, along_t) + 0.5 * min(along_s, along_t); }

Cell add_light(int number, ivec2 place, ivec2 cell, Cell sum) {
  vec4 light = texelFetch(dynamic_lights, ivec2(0, number), 0), color = texelFetch(dynamic_lights, ivec2(1, number), 0);
  vec4 plane = read_face(place, 1), s_axis = read_face(place, 2), t_axis = read_face(place, 3);
  vec2 units = read_face(place, 4).xy;
  vec3 origin = (light.xyz - model_origin) * model_axes;
  float height = dot(plane.xyz, origin) - plane.w;
  float at_nearest = light.w - abs(height), reach = at_nearest - color.a;
  vec3 nearest = origin - plane.xyz * height;
  vec2 middle = vec2(dot(s_axis.xyz, nearest) + s_axis.w, dot(t_axis.xyz, nearest) + t_axis.w);
  vec4 corners = vec4(cell, cell + 1) * 16.0;
  vec4 distances = find_distances(abs(corners.xzxz - middle.x) * units.x, abs(corners.yyww - middle.y) * units.y);
  vec4 amounts = mix(vec4(0), (at_nearest - distances) / 255.0, lessThan(distances, vec4(reach)));
  return Cell(sum.a + amounts.x * color.rgb, sum.b + amounts.y * color.rgb, sum.c + amounts.z * color.rgb,
              sum.d + amounts.w * color.rgb);
}

vec3 find_light(LitTile tile, vec2 texel) {
  uvec2 halves = uvec2(tile.light_first);
  uint number = halves.x | halves.y << 16, tile_number = uint(tile.light_layer);
  ivec2 place = ivec2(number % 400u * 5u, number / 400u);
  uvec4 face = texelFetch(style_faces, place, 0);
  vec2 at = texel * tile.samples_per_texel;
  ivec2 cell = ivec2(tile_number & 0xffu, tile_number >> 8) * 16 + ivec2(at);
  // There may be no sample after the last one, whose share is 0 then.
  Cell sum = add_styles(face, cell, min(cell + 1, ivec2(face.y & 0xffffu, face.y >> 16) - 1));
  for (int i = 0; i < light_count; ++i) sum = add_light(i, place, cell, sum);
  vec2 share = fract(at);
  vec3 above = mix(min(sum.a, 1.0), min(sum.b, 1.0), share.x);
  vec3 below = mix(min(sum.c, 1.0), min(sum.d, 1.0), share.x);
  return mix(above, below, share.y) * kLightScale;
}
)";

}  // namespace temblor::render_gl
