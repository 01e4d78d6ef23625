// The picture on the graphics card that a frame is drawn into: colors and depth. Its first row is the top
// one, and its channels are in the order of the CPU's pictures: blue, green, red. Those of indexed pictures
// are index / 255, and nothing.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/frame_buffer.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

// Everything is drawn to depths from 0 to kWorldDepthEnd; the view weapon, which nothing hides, to larger
// ones.
constexpr float kWorldDepthEnd = 0.5f;

// A rectangle of the picture, in pixels from its first row and column.
struct PixelRect {
  int x, y, width, height;
};

class Target {
 public:
  Target() = default;  // 0 x 0 pixels
  // Fails if the card lacks the memory, or cannot draw into pictures of this size.
  static base::Result<Target> make(const Functions& gl, int width, int height, render::PixelFormat format);

  int width() const { return width_; }
  int height() const { return height_; }
  render::PixelFormat format() const { return format_; }
  bool has_layout(int width, int height, render::PixelFormat format) const {
    return width_ == width && height_ == height && format_ == format;
  }
  // Draws into this target from now on, over `background` (0xffRRGGBB, or an index), with nothing in
  // front of it.
  void begin(const Functions& gl, std::uint32_t background);
  // Draws into this target from now on, over what it shows.
  void bind(const Functions& gl) const;
  // Draws into another picture of this size from now on, tested against the same depth. Returns the texture
  // with what was drawn before. Fails if the card lacks the memory.
  base::Result<GLuint> exchange(const Functions& gl);
  // Draws into this target from now on. Returns a texture with a copy of what it shows in `rect`, which must
  // be inside. Fails if the card lacks the memory.
  base::Result<GLuint> copy(const Functions& gl, const PixelRect& rect);
  GLuint color_texture() const { return pictures_[current_].color.name(); }
  GLuint depth_texture() const { return depth_.name(); }
  // Waits for the card and copies the picture: width * height pixels, 0xffRRGGBB.
  base::Status read(const Functions& gl, std::span<std::uint32_t> out_pixels) const;
  // The same for indexed pictures.
  base::Status read(const Functions& gl, std::span<std::uint8_t> out_pixels) const;
  // Replaces the picture by pixels of its format and size.
  void write(const Functions& gl, const render::FrameBuffer& frame) const;

 private:
  struct Picture {
    Texture color;
    Framebuffer framebuffer;
  };
  base::Result<Picture> make_picture(const Functions& gl) const;
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  int width_ = 0, height_ = 0;
  render::PixelFormat format_ = render::PixelFormat::kRgb;
  Texture depth_;
  // The second one is made when it is needed.
  std::array<Picture, 2> pictures_;
  std::size_t current_ = 0;
};

}  // namespace temblor::render_gl
