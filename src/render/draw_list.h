// 2-D drawing over the finished view: pictures and filled rectangles, drawn in order, later commands over
// earlier ones. Text is drawn as pictures too: each character is a part of the console's character picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "formats/images/palette.h"
#include "formats/images/picture.h"

namespace temblor::render {

// In pixels of the frame. It may lie partly or wholly outside the frame; Renderer::draw_overlay clips it.
struct ScreenRect {
  int x = 0, y = 0, width = 0, height = 0;
};

// Maps a palette index to the palette index that is drawn, for example to show a player's own colors.
using ColorTranslation = std::array<std::uint8_t, 256>;

// Colors in place of those of the palette, by palette index: for `indexed` and for `rgb` frames (0xffRRGGBB).
struct ColorTint {
  ColorTranslation indices{};
  std::array<std::uint32_t, 256> rgb{};
  // Multiplies the channels of other colors, in 255ths: those of a picture's detail in `rgb` frames.
  formats::Rgb factor{255, 255, 255};
};

// How a color is combined with the one below.
enum class DrawMode : std::uint8_t {
  kBlend,          // covers it, as far as the opacity says
  kAdd,            // the sum; the opacity is 1 or 0
  kMultiply,       // the product of each channel, as far as the opacity says
  kMultiplyTwice,  // twice the product, up to 255; half gray changes nothing
};

struct DrawCommand {
  // The picture to draw from; not owned, must live until the list is drawn. Each of its pixels covers a
  // square of `scale` pixels, and pixels of index 255 are transparent. Its detail, if it has one, is shown
  // instead, unless there is a translation. Null: `area` is filled with `fill`.
  const formats::Picture* picture = nullptr;
  // With a picture, width and height are `scale` times those of the part that is drawn.
  ScreenRect area;
  // The upper left corner of the part, in pixels of the picture.
  int part_x = 0, part_y = 0;
  // Not 0: this part of the picture is stretched to `area`, whatever its size, and `scale` is ignored.
  int part_width = 0, part_height = 0;
  // A whole number, at least 1, so that pictures stay sharp.
  int scale = 1;
  std::uint8_t fill = 0;  // palette index
  float opacity = 1;      // 0 to 1
  DrawMode mode = DrawMode::kBlend;
  // Null: the picture's own colors.
  const ColorTranslation* translation = nullptr;
  // Null: the palette's colors. Applies to `fill` too, and replaces `translation`.
  const ColorTint* tint = nullptr;
  // Nothing is drawn outside of it.
  std::optional<ScreenRect> clip{};
};

struct DrawList {
  std::vector<DrawCommand> commands;
  void clear() { commands.clear(); }
};

}  // namespace temblor::render
