#include "render_gl/frame/target.h"

#include "base/check.h"

namespace temblor::render_gl {

base::Result<Target> Target::make(const Functions& gl, int width, int height) {
  GLint limit = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width > limit || height > limit)
    return base::error(base::ErrorCode::kTooLarge,
                       "the graphics card draws pictures of up to {0}x{0} pixels, not {1}x{2}", limit, width,
                       height);
  Target target;
  target.width_ = width;
  target.height_ = height;
  TRY(target.color_, make_texture(gl, GL_RGBA8, {width, height}));
  TRY(target.depth_, make_texture(gl, GL_DEPTH_COMPONENT32F, {width, height}));
  target.framebuffer_ = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.color_.name(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth_.name(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return base::error(base::ErrorCode::kUnsupported, "the graphics card cannot draw into a texture");
  return target;
}

// Larger depth is nearer, as on the CPU.
void Target::begin(const Functions& gl, std::uint32_t background) const {
  const auto channel = [&](int shift) { return static_cast<float>(background >> shift & 255) / 255.0f; };
  bind(gl);
  gl.ClearColor(channel(0), channel(8), channel(16), 1);
  gl.ClearDepthf(0);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_TRUE);
  gl.DepthFunc(GL_GREATER);
  gl.DepthRangef(0, kWorldDepthEnd);
  if (gl.ClipControl != nullptr) gl.ClipControl(GL_LOWER_LEFT_EXT, GL_ZERO_TO_ONE_EXT);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Target::bind(const Functions& gl) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.Viewport(0, 0, width_, height_);
}

base::Status Target::read(const Functions& gl, std::span<std::uint32_t> out_pixels) const {
  CHECK(out_pixels.size() == static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, out_pixels.data());
  return gl.check("reading the picture");
}

}  // namespace temblor::render_gl
