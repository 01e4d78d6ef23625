#include "render_gl/frame/target.h"

#include <string_view>
#include <vector>

#include "base/check.h"

namespace temblor::render_gl {

namespace {

// Whether the bound picture can be read as single bytes: always in OpenGL. OpenGL ES promises four channels,
// and names one other layout.
bool can_read_bytes(const Functions& gl) {
  const GLubyte* const version = gl.GetString(GL_VERSION);
  const std::string_view text = version == nullptr ? "" : reinterpret_cast<const char*>(version);
  if (!text.starts_with("OpenGL ES")) return true;
  GLint format = 0, type = 0;
  gl.GetIntegerv(GL_IMPLEMENTATION_COLOR_READ_FORMAT, &format);
  gl.GetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE, &type);
  return format == GL_RED && type == GL_UNSIGNED_BYTE;
}

}  // namespace

base::Result<Target> Target::make(const Functions& gl, int width, int height, render::PixelFormat format) {
  GLint limit = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width > limit || height > limit)
    return base::error(base::ErrorCode::kTooLarge,
                       "the graphics card draws pictures of up to {0}x{0} pixels, not {1}x{2}", limit, width,
                       height);
  Target target;
  target.width_ = width;
  target.height_ = height;
  target.format_ = format;
  TRY(target.depth_, make_texture(gl, GL_DEPTH_COMPONENT32F, {width, height}));
  TRY(target.pictures_[0], target.make_picture(gl));
  return target;
}

base::Result<Target::Picture> Target::make_picture(const Functions& gl) const {
  Picture picture;
  TRY(picture.color,
      make_texture(gl, format_ == render::PixelFormat::kIndexed ? GL_R8 : GL_RGBA8, {width_, height_}));
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
  gl.Disable(GL_SCISSOR_TEST);
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

base::Result<GLuint> Target::copy(const Functions& gl, const PixelRect& rect) {
  Picture& other = pictures_[1 - current_];
  if (!other.framebuffer) {
    TRY(other, make_picture(gl));
  }
  bind(gl);
  gl.BindTexture(GL_TEXTURE_2D, other.color.name());
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, rect.x, rect.y, rect.x, rect.y, rect.width, rect.height);
  return other.color.name();
}

void Target::bind(const Functions& gl) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, pictures_[current_].framebuffer.name());
  gl.Viewport(0, 0, width_, height_);
}

base::Status Target::read(const Functions& gl, std::span<std::uint32_t> out_pixels) const {
  CHECK(out_pixels.size() == pixel_count() && format_ == render::PixelFormat::kRgb);
  gl.BindFramebuffer(GL_FRAMEBUFFER, pictures_[current_].framebuffer.name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, out_pixels.data());
  return gl.check("reading the picture");
}

base::Status Target::read(const Functions& gl, std::span<std::uint8_t> out_pixels) const {
  CHECK(out_pixels.size() == pixel_count() && format_ == render::PixelFormat::kIndexed);
  gl.BindFramebuffer(GL_FRAMEBUFFER, pictures_[current_].framebuffer.name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  if (can_read_bytes(gl)) {
    gl.ReadPixels(0, 0, width_, height_, GL_RED, GL_UNSIGNED_BYTE, out_pixels.data());
  } else {
    constexpr std::size_t kChannels = 4;
    std::vector<std::uint8_t> channels(pixel_count() * kChannels);
    gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, channels.data());
    for (std::size_t i = 0; i < out_pixels.size(); ++i) out_pixels[i] = channels[i * kChannels];
  }
  return gl.check("reading the picture");
}

void Target::write(const Functions& gl, const render::FrameBuffer& frame) const {
  CHECK(has_layout(frame.width(), frame.height(), frame.format()));
  const bool is_indexed = format_ == render::PixelFormat::kIndexed;
  const void* const pixels =
      is_indexed ? static_cast<const void*>(frame.indexed().data()) : frame.rgb().data();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, color_texture());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, is_indexed ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE,
                   pixels);
}

}  // namespace temblor::render_gl
