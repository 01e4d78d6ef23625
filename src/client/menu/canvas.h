// The menu's drawing surface: a box in the middle of the frame, measured in the original's pixels.
//
// Pages lay themselves out in canvas pixels; the canvas scales them by a whole number and appends draw
// commands to a render::DrawList. A large frame gets a larger scale, never a box wider than pages can use:
//
//   frame +---------------------------+
//         |     +---------------+     |   width()  = box width  / scale, 40 to 424
//         |     |    canvas     |     |   height() = box height / scale, 10 to 300
//         |     +---------------+     |
//         +---------------------------+
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "assets/pictures.h"
#include "client/hud/panel.h"
#include "render/draw_list.h"

namespace temblor::client {

// A rectangle, in pixels of the canvas or of the frame. The right and bottom edges are outside it.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  int right() const { return x + width; }
  int bottom() const { return y + height; }
  bool contains(int at_x, int at_y) const {
    return at_x >= x && at_x < right() && at_y >= y && at_y < bottom();
  }
};

// Frame pixels per canvas pixel, at least 1: three quarters of the largest scale at which a 320 x 200 screen
// still fits, times `text_size`, rounded. The screen may be as small as 160 x 100 if `text_size` is above 1.
// A frame with room for it uses 2 rather than 1, as letters of 8 pixels are small.
int choose_menu_scale(int frame_width, int frame_height, double text_size);

// The only two opacities that menus draw with. In indexed color each opacity costs a lookup table.
constexpr float kFaintOpacity = 0.1875f, kStrongOpacity = 0.75f;

// The player's settings for all menus.
struct CanvasLook {
  // A factor on the scale: the variable scr_textsize.
  double text_size = 1;
  // Text in one color on black: the variable con_highcontrast.
  bool high_contrast = false;
};

// Refers to the pictures and the list, which must outlive it. Cheap to make: one for each frame.
class Canvas {
 public:
  // Makes a canvas for a frame. Returns nothing for a frame too small for a word.
  static std::optional<Canvas> fit(const assets::Pictures& pictures, int frame_width, int frame_height,
                                   const CanvasLook& look, render::DrawList& io_list);

  // In canvas pixels, as all coordinates below.
  int width() const { return area_.width / scale_; }
  int height() const { return area_.height / scale_; }
  int scale() const { return scale_; }
  // Converts canvas pixels to frame pixels.
  Box to_frame(const Box& box) const;

  // Darkens the whole frame behind the menu. Darkening only the canvas would leave distracting strips.
  void dim() const;
  // Lightens the background of the selected row.
  void highlight(const Box& box) const;
  // Fills with a palette color.
  void fill(const Box& box, std::uint8_t index, float opacity = 1) const;
  // `size`: 1 for characters of 8 x 8 pixels, 2 for 16 x 16.
  void draw_text(std::string_view text, int x, int y, int size = 1) const;
  void draw_centered_text(std::string_view text, int y, int size = 1) const;
  void draw_character(char c, int x, int y) const;
  // Draws the picture if the game has it and it is at most 48 pixels wide.
  void draw_plaque(std::string_view name, int x, int y) const;
  // Draws the picture centered and returns its height. Returns 0 and draws nothing if the game does not have
  // it or it is too large for a title.
  int draw_title_picture(std::string_view name, int y) const;
  // Draws a picture that is already in frame pixels in the middle of `box`. The list refers to the picture.
  void draw_unscaled(const formats::Picture& picture, const Box& box) const;

 private:
  Canvas(const assets::Pictures& pictures, int frame_width, int frame_height, int scale, const Box& area,
         render::DrawList& io_list);

  const assets::Pictures* pictures_;
  Panel panel_, large_;
  render::DrawList* list_;
  Box area_;  // frame pixels
  int frame_width_, frame_height_, scale_;
  bool high_contrast_ = false;
};

}  // namespace temblor::client
