// Shader parts for what the CPU places on the screen: sprites, particles, and lines. They turn pixels and
// ViewFrame::depth into the card's positions and depth, which agree with those of the level's faces, and
// apply fog.
#pragma once

#include <string>

#include "render/scene.h"
#include "render/view/view_frame.h"
#include "render_gl/frame/index_tables.h"
#include "render_gl/gl/objects.h"
#include "render_gl/gl/shader_look.h"

namespace temblor::render_gl {

// Functions for a vertex shader: at_pixel(pixel, depth), where pixel centers are at whole numbers.
inline constexpr const char* kScreenVertexPart = R"(
uniform vec2 pixel_size;   // in clip space
uniform vec2 depth_scale;  // the card's depth is x + y * depth
uniform bool full_range;   // depth of the clip space begins at -1, not at 0

vec4 at_pixel(vec2 pixel, float depth) {
  float card_depth = depth_scale.x + depth_scale.y * depth;
  return vec4((pixel + 0.5) * pixel_size - 1.0, full_range ? 2.0 * card_depth - 1.0 : card_depth, 1.0);
}
)";

// Functions for a fragment shader: add_fog(color, depth), and find_card_depth(depth) for gl_FragDepth.
inline constexpr const char* kScreenFragmentPart = R"(
uniform vec2 depth_scale;
uniform bool perspective;
uniform float fog_density;
uniform vec3 fog_color;

// Half of it, as glDepthRange halves the depth of vertices (kWorldDepthEnd).
float find_card_depth(float depth) { return 0.5 * (depth_scale.x + depth_scale.y * depth); }

// In 256ths, and halves are rounded up, as on the CPU.
vec3 add_fog(vec3 color, float depth) {
  if (fog_density <= 0.0) return color;
  float units = perspective ? 1.0 / max(depth, 1e-20) : max(-depth, 0.0);
  float thickness = fog_density / 64.0 * units;
#ifdef INDEXED
  return vec3(fog_index(color.r, 1.0 - exp(-thickness * thickness)), 0, 0);
#else
  float share = floor((1.0 - exp(-thickness * thickness)) * 256.0 + 0.5) / 256.0;
  return mix(color, fog_color, share) + 0.001 / 255.0;
#endif
}
)";

// The card's depth of a pixel is x + y * depth, before it is halved (kWorldDepthEnd).
math::Vec2 find_depth_scale(const render::ViewFrame& view);

// A program with these parts, and the locations of their variables.
class ScreenProgram {
 public:
  // The sources follow the parts above. Fails as make_program() does.
  static base::Result<ScreenProgram> make(const Functions& gl, const char* vertex_source,
                                          const char* fragment_source, ShaderLook look = ShaderLook::kColors);

  // Uses the program from now on, for a view and its fog. `tables`: null unless indices are drawn.
  void use(const Functions& gl, const render::ViewFrame& view, const render::Fog& fog,
           const IndexTables* tables) const;
  const IndexUniforms& index_uniforms() const { return index_; }
  GLuint name() const { return program_.name(); }

 private:
  explicit ScreenProgram(const Functions& gl, Program program);

  Program program_;
  GLint pixel_size_, depth_scale_, full_range_, perspective_, fog_density_, fog_color_;
  IndexUniforms index_;
};

}  // namespace temblor::render_gl
