// Shows the finished picture in the window: its colors with the player's tone, stretched between four pixels
// if the window has another size.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "formats/images/palette.h"
#include "render_gl/frame/target.h"

namespace temblor::render_gl {

// How the picture looks in the window.
struct Shown {
  GLuint framebuffer = 0;     // 0: the window's
  int width = 1, height = 1;  // of the window, in pixels
  // For an indexed picture: with the frame's tint and the player's tone.
  formats::Palette palette{};
  // The new value of each channel of a true-color picture; null: it stays.
  const std::array<std::uint8_t, 256>* tone = nullptr;
};

class PresentPass {
 public:
  static base::Result<PresentPass> make(const Functions& gl, render::PixelFormat format);

  // Draws the target's picture into all of the window.
  base::Status draw(const Functions& gl, const Target& target, const Shown& shown);

 private:
  struct PresentProgram {
    PresentProgram(const Functions& gl, Program program);
    Program program;
    GLint picture, colors, picture_size, window_size;
  };
  PresentPass(const Functions& gl, Texture colors);

  // By whether the picture is stretched, and whether it has a tone. Indexed pictures have it in the palette.
  std::array<std::array<std::optional<PresentProgram>, 2>, 2> programs_;
  VertexArray no_vertices_;
  // The palette, or the tone of each channel.
  Texture color_texture_;
};

}  // namespace temblor::render_gl
