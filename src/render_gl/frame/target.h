// The picture on the graphics card that a frame is drawn into: colors and depth. Its first row is the top
// one, and its channels are in the order of the CPU's pictures: blue, green, red.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

// Everything is drawn to depths from 0 to kWorldDepthEnd; the view weapon, which nothing hides, to larger
// ones.
constexpr float kWorldDepthEnd = 0.5f;

class Target {
 public:
  Target() = default;  // 0 x 0 pixels
  // Fails if the card lacks the memory, or cannot draw into pictures of this size.
  static base::Result<Target> make(const Functions& gl, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  // Draws into this target from now on, over `background` (0xffRRGGBB), with nothing in front of it.
  void begin(const Functions& gl, std::uint32_t background);
  // Draws into this target from now on, over what it shows.
  void bind(const Functions& gl) const;
  // Draws into another picture of this size from now on, tested against the same depth. Returns the texture
  // with what was drawn before. Fails if the card lacks the memory.
  base::Result<GLuint> exchange(const Functions& gl);
  GLuint color_texture() const { return pictures_[current_].color.name(); }
  GLuint depth_texture() const { return depth_.name(); }
  // Waits for the card and copies the picture: width * height pixels, 0xffRRGGBB.
  base::Status read(const Functions& gl, std::span<std::uint32_t> out_pixels) const;

 private:
  struct Picture {
    Texture color;
    Framebuffer framebuffer;
  };
  base::Result<Picture> make_picture(const Functions& gl) const;

  int width_ = 0, height_ = 0;
  Texture depth_;
  // The second one is made when it is needed.
  std::array<Picture, 2> pictures_;
  std::size_t current_ = 0;
};

}  // namespace temblor::render_gl
