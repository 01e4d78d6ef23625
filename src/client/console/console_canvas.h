// The console's drawing surface: converts rows of characters to draw commands.
//
// The frame is measured in character columns (x) and in the original's pixels (y, 8 per character). The
// canvas chooses how many frame pixels such a pixel takes, from the frame's size and from the player's text
// size, so that the text stays readable at any resolution. In high contrast all text is drawn white on black.
#pragma once

#include <string>
#include <string_view>

#include "assets/pictures.h"
#include "client/hud/panel.h"
#include "render/draw_list.h"

namespace temblor::client {

struct ConsoleSettings;

// A canvas lives for one frame.
class ConsoleCanvas {
 public:
  // For a frame of `width` x `height` pixels. Draw commands are appended to the list; list, pictures and
  // settings must outlive the canvas.
  ConsoleCanvas(const assets::Pictures& pictures, const ConsoleSettings& settings, int width, int height,
                render::DrawList& io_list);

  // Characters per row, without a margin on either side; at least 1.
  int columns() const;
  // The frame's height in the original's pixels (the unit of y below), rounded up.
  int height() const { return (frame_height_ + scale_ - 1) / scale_; }

  // Draws the console's background over the full width down to `bottom`: gfx/conback.lmp, or plain black if
  // the game has no such picture or high contrast is on.
  void draw_background(int bottom, float opacity) const;
  // Draws a background behind a row of text over the game, in high contrast only.
  void draw_row_background(int y) const;
  // Draws characters from `column` to the right, at pixel row `y`. Column 0 is the first one right of the
  // margin.
  void draw_text(std::string_view glyphs, int column, int y) const;
  // Draws text that ends at the last column. Draws nothing if it is too long for the row.
  void draw_right_aligned_text(std::string_view glyphs, int y) const;
  // Draws a cursor that blinks twice a second.
  void draw_cursor(int column, int y, double time_s) const;

 private:
  void fill_plain(int top, int bottom, float opacity) const;

  const assets::Pictures& pictures_;
  const ConsoleSettings& settings_;
  render::DrawList& list_;
  int frame_width_, frame_height_, scale_;
  Panel panel_;
};

// The visible part of an input line: it scrolls so that the cursor is visible.
struct InputLineView {
  std::string glyphs;  // including the prompt
  int cursor_column = 0;
};
// Computes the visible part. `cursor`: the number of glyphs before the cursor. `columns`: the row's width, at
// least 1; a prompt that takes more than half of it is cut.
InputLineView layout_input_line(std::string_view prompt, std::string_view glyphs, std::size_t cursor,
                                int columns);

}  // namespace temblor::client
