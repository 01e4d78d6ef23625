#include "render_gl/particles/particle_pass.h"

#include <cstddef>

namespace temblor::render_gl {

namespace {

// An instance is a ParticleRect, whose color may be an index: then it is in the red channel. Its sides lie
// between pixels, so that rounding cannot move them.
constexpr const char* kParticleVertexShader = R"(
layout(location = 0) in float depth;
layout(location = 1) in uvec4 rect;  // left, top, width, height
layout(location = 2) in vec4 color;

flat out vec3 rect_color;
flat out float rect_depth;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = at_pixel(vec2(rect.xy) + corner * vec2(rect.zw) - 0.5, depth);
  rect_color = color.rgb;
  rect_depth = depth;
}
)";

constexpr const char* kParticleFragmentShader = R"(
flat in vec3 rect_color;
flat in float rect_depth;
out vec4 color;

void main() { color = vec4(add_fog(rect_color, rect_depth), 1.0); }
)";

}  // namespace

ParticlePass::ParticlePass(const Functions& gl, ScreenProgram program)
    : program_(std::move(program)), vertex_array_(make_vertex_array(gl)), buffer_(make_buffer(gl)) {
  using render::ParticleRect;
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  constexpr GLsizei kStride = sizeof(ParticleRect);
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  for (GLuint location = 0; location < 3; ++location) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribDivisor(location, 1);
  }
  gl.VertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ParticleRect, depth)));
  gl.VertexAttribIPointer(1, 4, GL_UNSIGNED_SHORT, kStride, at(offsetof(ParticleRect, x)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(ParticleRect, color)));
  gl.BindVertexArray(0);
}

base::Result<ParticlePass> ParticlePass::make(const Functions& gl, render::PixelFormat format) {
  TRY(ScreenProgram program,
      ScreenProgram::make(gl, kParticleVertexShader, kParticleFragmentShader, find_look(format)));
  return ParticlePass(gl, std::move(program));
}

base::Status ParticlePass::draw(const Functions& gl, const FrameInput& input) {
  if (!input.sources.fill_depth) return base::Ok{};
  rects_.clear();
  for (const std::span<render::ParticleRect> band :
       render::place_particles(input.context, input.record.view).rects)
    rects_.insert(rects_.end(), band.begin(), band.end());
  if (rects_.empty()) return base::Ok{};
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(rects_.size() * sizeof(render::ParticleRect)),
                rects_.data(), GL_STREAM_DRAW);
  program_.use(gl, input.record.view, input.scene().fog, input.index_tables);
  gl.BindVertexArray(vertex_array_.name());
  gl.DepthFunc(GL_GEQUAL);  // among particles of equal depth the later one stays
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(rects_.size()));
  gl.DepthFunc(GL_GREATER);
  gl.BindVertexArray(0);
  return gl.check("drawing particles");
}

}  // namespace temblor::render_gl
