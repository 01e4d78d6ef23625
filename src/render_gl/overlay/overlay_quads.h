// A DrawList as the card reads it: a rectangle for each command, in order, and the colors that they have.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/screen/overlay_geometry.h"

namespace temblor::render_gl {

// Which texel shows at a pixel, counted from the rectangle's first one:
//   first + ((2 * pixel + 1) * factor + start) / divisor
// This is what render/screen/draw_overlay.cpp computes, in terms that 32 bits can hold.
struct TexelAxis {
  std::int32_t factor = 0, start = 0, divisor = 1, first = 0;
};

// A side of a command, in pixels of the frame, and what it shows.
struct OverlaySide {
  std::int64_t begin;                  // of the command's area
  std::int64_t size;                   // of the area
  std::int64_t first_pixel;            // that is drawn
  std::int64_t part_first, part_size;  // pixels of the picture
  std::int64_t picture_size;
  std::int64_t texels;  // of the picture's texture
};
TexelAxis make_texel_axis(const OverlaySide& side);

// An instance, as the shader reads it.
struct OverlayQuad {
  std::array<std::int32_t, 4> rect;  // x and y of the first pixel, and of the end
  TexelAxis columns, rows;
  std::int32_t color_row;  // of OverlayColors
  std::int32_t opacity_256;
  std::int32_t fill;    // an index
  std::int32_t factor;  // of a detail's colors: blue, green, red from the lowest byte
};

// Rows of 256 colors, 0xffRRGGBB, or of indices in the lowest byte. Row 0 is the palette.
class OverlayColors {
 public:
  // The rows that a texture surely has room for.
  static constexpr std::size_t kMaxRows = 1024;

  void begin(const render::ColorTables& tables, render::PixelFormat format);
  // The number of the row with the command's colors; commands that share a translation or tint share it.
  // -1: there is no room.
  std::int32_t find_row(const render::DrawCommand& command);
  std::span<const std::uint32_t> texels() const { return texels_; }

 private:
  struct Source {
    const render::ColorTranslation* translation;
    const render::ColorTint* tint;
    bool operator==(const Source&) const = default;
  };
  const render::ColorTables* tables_ = nullptr;
  bool is_indexed_ = false;
  std::vector<Source> sources_;  // of each row
  std::vector<std::uint32_t> texels_;
};

}  // namespace temblor::render_gl
