// 2-D drawing over the finished view: pictures and plain rectangles, in order. Text is pictures too: parts of
// the console's characters.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "formats/images/palette.h"
#include "formats/images/picture.h"

namespace temblor::render {

// Pixels of the frame; may lie outside it, in part or whole.
struct ScreenRect {
  int x = 0, y = 0, width = 0, height = 0;
};

// Palette index -> palette index.
using ColorTranslation = std::array<std::uint8_t, 256>;

struct DrawCommand {
  // Part of a picture, each of its pixels a square of `scale` pixels; index 255 is transparent. Null: `area`
  // is filled with `fill`.
  const formats::Picture* picture = nullptr;
  ScreenRect area;                                // `picture` given: width and height are scale x the part's
  int part_x = 0, part_y = 0;                     // the part's corner in the picture
  int scale = 1;                                  // whole numbers, so that pictures stay sharp
  std::uint8_t fill = 0;                          // palette index
  float opacity = 1;                              // 0 to 1
  const ColorTranslation* translation = nullptr;  // null: as they are
};

struct DrawList {
  std::vector<DrawCommand> commands;
  void clear() { commands.clear(); }
};

}  // namespace temblor::render
