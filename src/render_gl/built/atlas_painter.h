// Draws into the atlas of surface blocks: rectangles, each from one vertex record per instance.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "render_gl/surfaces/block_atlas.h"

namespace temblor::render_gl {

class AtlasPainter {
 public:
  // Fails if the card cannot draw into the atlas.
  static base::Result<AtlasPainter> make(const Functions& gl, const BlockAtlas& atlas);

  // `count` jobs of `stride` bytes each. Binds another framebuffer and viewport, up to end().
  void begin(const Functions& gl, const BlockAtlas& atlas, const void* jobs, std::size_t count,
             std::size_t stride) const;
  // Whole numbers of a job, as the input of a shader.
  struct Input {
    GLuint location;
    GLint numbers;
    std::size_t offset;  // in the job
  };
  // Draws four vertices for each of the jobs from `first` on, in a layer of the atlas, with the program in
  // use.
  struct Jobs {
    std::size_t first, count, stride;
    int layer;
  };
  void draw(const Functions& gl, const BlockAtlas& atlas, const Jobs& jobs,
            std::initializer_list<Input> inputs) const;
  void end(const Functions& gl) const;

 private:
  AtlasPainter(const Functions& gl, Framebuffer framebuffer);

  Framebuffer framebuffer_;
  Buffer buffer_;
  VertexArray vertex_array_;
};

// For fragment shaders: rounds a color to 16 bits, as uploads are rounded, if the atlas has a color key. Some
// drivers cut colors off. One color stands for clear texels.
inline constexpr const char* kAtlasColorPart = R"(
uniform bool has_color_key;

vec4 round_color(vec4 color) {
  if (!has_color_key) return color;
  vec3 steps = floor(color.rgb * vec3(31, 63, 31) + 0.5);
  if (steps == vec3(31, 0, 31)) steps.r = 30.0;
  if (color.a == 0.0) steps = vec3(31, 0, 31);
  return vec4((steps + 0.01) / vec3(31, 63, 31), 1.0);
}
)";

}  // namespace temblor::render_gl
