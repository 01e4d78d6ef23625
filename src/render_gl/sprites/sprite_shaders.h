// The shaders that draw sprites, after the parts of screen_space.h. A fragment computes depth and texel from
// the planes of the CPU's SpriteQuad, as the CPU's kernels do.
#pragma once

namespace temblor::render_gl {

inline constexpr const char* kSpriteVertexShader = R"(
layout(location = 0) in vec2 pixel;
// The same at all corners of a sprite.
layout(location = 1) in vec2 origin;       // the pixel that the planes begin at
layout(location = 2) in vec3 depth_plane;  // there, and its growth rightward and downward
layout(location = 3) in vec3 s_plane;      // texels, divided by z unless the sprite is affine
layout(location = 4) in vec3 t_plane;
layout(location = 5) in vec2 kind;         // opacity; 1 if affine, or 0

flat out vec2 plane_origin;
flat out vec3 plane_depth, plane_s, plane_t;
flat out vec2 sprite_kind;

void main() {
  plane_origin = origin;
  plane_depth = depth_plane;
  plane_s = s_plane;
  plane_t = t_plane;
  sprite_kind = kind;
  // The fragments have depth. Here it only must not be cut off.
  gl_Position = vec4(at_pixel(pixel, 0.0).xy, 0.5, 1.0);
}
)";

inline constexpr const char* kSpriteTexelPart = R"(
uniform sampler2D picture;

flat in vec2 plane_origin;
flat in vec3 plane_depth, plane_s, plane_t;
flat in vec2 sprite_kind;
out vec4 color;

// Clear texels have no color to blend with: their neighbors' shares are larger.
vec4 find_texel(ivec2 texel) {
  vec4 own = texelFetch(picture, clamp(texel, ivec2(0), textureSize(picture, 0) - 1), 0);
#ifdef BLENDED_TEXELS
  own.rgb *= own.a;
#endif
  return own;
}
)";

inline constexpr const char* kSpriteFragmentShader = R"(
void main() {
  vec3 at = vec3(1.0, gl_FragCoord.xy - 0.5 - plane_origin);
  float depth = dot(plane_depth, at);
  float z = sprite_kind.y > 0.5 ? 1.0 : 1.0 / max(depth, 1e-20);
  vec2 texel = vec2(dot(plane_s, at), dot(plane_t, at)) * z;
#ifdef BLENDED_TEXELS
  color = blend_texels(texel);
  color.rgb /= max(color.a, 1e-6);
#else
  color = find_texel(ivec2(max(texel, vec2(0))));
#endif
#ifdef INDEXED
  if (color.r == 1.0) discard;
#else
  if (color.a < 0.5) discard;
#endif
  color = vec4(add_fog(color.rgb, depth), sprite_kind.x);
#ifdef BLENDED
  color.r = blend_index(color.r);
#endif
  gl_FragDepth = find_card_depth(depth);
}
)";

}  // namespace temblor::render_gl
