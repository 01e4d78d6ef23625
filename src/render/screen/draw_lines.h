// Lines over the finished view: Scene::lines. They are one pixel wide, and those without a depth test are not
// hidden by anything.
#pragma once

#include <optional>
#include <span>

#include "formats/images/palette.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// A line is hidden only by what is nearer than this share of its own distance, so that lines on a wall are in
// front of it.
constexpr double kLineDepthSlack = 1.0 / 256;

// The part of a line that is on the screen: x, y, and ViewFrame::depth, which is linear there. Nothing if no
// part is, or if a position is not finite.
struct LinePiece {
  math::Vec3d from, to;
};
std::optional<LinePiece> project_line(const Line& line, const ViewFrame& view);

// A piece's pixels: one in each column from `first` to `last`, both inclusive, or in each row if it is steep.
// At column i, its row and depth are those of `start` plus i - start[along] times `slope`.
struct LineSteps {
  int along, across;  // 0: x, 1: y
  int first, last;
  math::Vec3d start, slope;

  math::Vec3d at(double i) const { return start + slope * (i - start[along]); }
};
LineSteps find_line_steps(const LinePiece& piece, const ViewFrame& view);

// Indexed frames show the nearest palette entry. Reads the frame's depth only for lines with a depth test.
void draw_lines(std::span<const Line> lines, const ViewFrame& view, const formats::Palette& palette,
                FrameBuffer& io_frame);

}  // namespace temblor::render
