#include "render_gl/built/atlas_painter.h"

namespace temblor::render_gl {

AtlasPainter::AtlasPainter(const Functions& gl, Framebuffer framebuffer)
    : framebuffer_(std::move(framebuffer)), buffer_(make_buffer(gl)), vertex_array_(make_vertex_array(gl)) {}

base::Result<AtlasPainter> AtlasPainter::make(const Functions& gl, const BlockAtlas& atlas) {
  Framebuffer framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, atlas.texture(), 0, 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return base::error(base::ErrorCode::kUnsupported, "the graphics card cannot draw into a texture");
  return AtlasPainter(gl, std::move(framebuffer));
}

void AtlasPainter::begin(const Functions& gl, const BlockAtlas& atlas, const void* jobs, std::size_t count,
                         std::size_t stride) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.Viewport(0, 0, atlas.side(), atlas.side());
  gl.Disable(GL_DITHER);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_CULL_FACE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * stride), jobs, GL_STREAM_DRAW);
}

void AtlasPainter::draw(const Functions& gl, const BlockAtlas& atlas, const Jobs& jobs,
                        std::initializer_list<Input> inputs) const {
  for (const Input& input : inputs) {
    gl.EnableVertexAttribArray(input.location);
    gl.VertexAttribIPointer(input.location, input.numbers, GL_UNSIGNED_INT, static_cast<GLsizei>(jobs.stride),
                            reinterpret_cast<const void*>(jobs.first * jobs.stride + input.offset));
    gl.VertexAttribDivisor(input.location, 1);
  }
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, atlas.texture(), 0, jobs.layer);
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(jobs.count));
}

void AtlasPainter::end(const Functions& gl) const {
  gl.BindVertexArray(0);
  // Target leaves it so: alpha is only for blending.
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  gl.ActiveTexture(GL_TEXTURE0);
}

}  // namespace temblor::render_gl
