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
  TRY(target.depth_, make_texture(gl, GL_DEPTH_COMPONENT32F, {width, height}));
  TRY(target.pictures_[0], target.make_picture(gl));
  return target;
}

base::Result<Target::Picture> Target::make_picture(const Functions& gl) const {
  Picture picture;
  TRY(picture.color, make_texture(gl, GL_RGBA8, {width_, height_}));
  picture.framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.color.name(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return base::error(base::ErrorCode::kUnsupported, "the graphics card cannot draw into a texture");
  return picture;
}

// Larger depth is nearer, as on the CPU.
void Target::begin(const Functions& gl, std::uint32_t background) {
  current_ = 0;
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
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  // Alpha is only for blending: in the picture, it stays 255.
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

base::Result<GLuint> Target::exchange(const Functions& gl) {
  const std::size_t before = current_;
  Picture& next = pictures_[1 - before];
  if (!next.framebuffer) {
    TRY(next, make_picture(gl));
  }
  current_ = 1 - before;
  gl.BindFramebuffer(GL_FRAMEBUFFER, next.framebuffer.name());
  return pictures_[before].color.name();
}

void Target::bind(const Functions& gl) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, pictures_[current_].framebuffer.name());
  gl.Viewport(0, 0, width_, height_);
}

base::Status Target::read(const Functions& gl, std::span<std::uint32_t> out_pixels) const {
  CHECK(out_pixels.size() == static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  gl.BindFramebuffer(GL_FRAMEBUFFER, pictures_[current_].framebuffer.name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, out_pixels.data());
  return gl.check("reading the picture");
}

}  // namespace temblor::render_gl
