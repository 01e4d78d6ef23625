// The menu's part of the frame: a box in its middle, laid out in pixels of the original.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "assets/pictures.h"
#include "client/hud/panel.h"
#include "render/draw_list.h"

namespace temblor::client {

struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  int right() const { return x + width; }
  int bottom() const { return y + height; }
  bool contains(int at_x, int at_y) const {
    return at_x >= x && at_x < right() && at_y >= y && at_y < bottom();
  }
};

// Frame pixels for each of the original's: three quarters of what would fill the frame with its screen, times
// `text_size`, but never so many that it would not fit. Only at 2 it may stand out a little.
int choose_menu_scale(int frame_width, int frame_height, double text_size);

// Opacities. In indexed color each one that is drawn with costs a table: two do for all.
constexpr float kFaint = 0.1875f, kStrong = 0.75f;

struct CanvasLook {
  double text_size = 1;
  bool high_contrast = false;  // text in one color on black
};

class Canvas {
 public:
  // Nothing for a frame too small for a word.
  static std::optional<Canvas> fit(const assets::Pictures& pictures, int frame_width, int frame_height,
                                   const CanvasLook& look, render::DrawList& io_list);

  int width() const { return area_.width / scale_; }
  int height() const { return area_.height / scale_; }
  int scale() const { return scale_; }
  // In pixels of the frame.
  Box to_frame(const Box& box) const;

  // What is behind it: all of the frame, as strips beside it would draw the eye.
  void dim() const;
  // Behind a row that is selected.
  void highlight(const Box& box) const;
  void fill(const Box& box, std::uint8_t index, float opacity = 1) const;
  // `size`: 1, or 2 for characters of 16 x 16.
  void text(std::string_view text, int x, int y, int size = 1) const;
  void text_in_middle(std::string_view text, int y, int size = 1) const;
  void character(char c, int x, int y) const;
  // Only where the game has it, no larger than menus can do with; the latter returns its height, or 0.
  void plaque(std::string_view name, int x, int y) const;
  int title_picture(std::string_view name, int y) const;
  // `picture` has the frame's own pixels; in the middle of `box`.
  void own_pixels(const formats::Picture& picture, const Box& box) const;

 private:
  Canvas(const assets::Pictures& pictures, int frame_width, int frame_height, int scale, const Box& area,
         render::DrawList& io_list);

  const assets::Pictures* pictures_;
  Panel panel_, large_;
  render::DrawList* list_;
  Box area_;  // of the frame
  int frame_width_, frame_height_, scale_;
  bool high_contrast_ = false;
};

}  // namespace temblor::client
