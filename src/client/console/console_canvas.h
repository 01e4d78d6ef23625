// A frame as the console sees it: in characters, from its upper left corner.
#pragma once

#include <string>
#include <string_view>

#include "assets/pictures.h"
#include "client/hud/panel.h"
#include "render/draw_list.h"

namespace temblor::client {

struct ConsoleSettings;

class ConsoleCanvas {
 public:
  // For a frame of `width` x `height` pixels. What is drawn is appended to the list, which with the pictures
  // and settings must outlive it.
  ConsoleCanvas(const assets::Pictures& pictures, const ConsoleSettings& settings, int width, int height,
                render::DrawList& io_list);

  // Characters that a row holds, without a margin at either side; 1 or more.
  int columns() const;
  // Of the frame, in the original's pixels (the unit of y below), rounded up.
  int height() const { return (frame_height_ + scale_ - 1) / scale_; }

  // Over all of the width, down to `bottom`.
  void background(int bottom, float opacity) const;
  // Behind a row of text over the game: nothing, but in high contrast.
  void row_background(int y) const;
  // Column 0 is the one behind the margin.
  void text(std::string_view glyphs, int column, int y) const;
  void text_at_right(std::string_view glyphs, int y) const;
  // A place for the next character: there half of the time.
  void cursor(int column, int y, double time_s) const;

 private:
  void plain_fill(int top, int bottom, float opacity) const;

  const assets::Pictures& pictures_;
  const ConsoleSettings& settings_;
  render::DrawList& list_;
  int frame_width_, frame_height_, scale_;
  Panel panel_;
};

// What of a line that is typed fits in a row: the text moves so that the cursor is in it.
struct ShownInput {
  std::string glyphs;  // with the prompt
  int cursor_column = 0;
};
// `cursor`: how many of the glyphs stand before it.
ShownInput show_input(std::string_view prompt, std::string_view glyphs, std::size_t cursor, int columns);

}  // namespace temblor::client
