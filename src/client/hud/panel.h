// A drawing area in the original's pixels, for the parts of its 320 x 200 screen.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "assets/pictures.h"
#include "render/draw_list.h"

namespace temblor::client {

// Sizes of the original's screen, status bar and characters, in its pixels.
constexpr int kScreenWidth = 320, kScreenHeight = 200;
constexpr int kBarHeight = 24, kInventoryHeight = 24;
constexpr int kCharacterSide = 8;
// From a line of text to the next one: letters that hang down must not touch those below them.
constexpr int kTextLine = kCharacterSide + 2;

// The player's choice of sizes.
struct HudSize {
  // Frame pixels per original pixel; 0: a scale that suits the frame (3 at 1920 x 1080).
  int scale = 0;
  // A factor on the scale: the variable scr_textsize.
  float text = 1;
};

// Frame pixels per original pixel, at least 1, and at most as many as let the original's screen fit.
int choose_scale(int frame_width, int frame_height, HudSize size);
// The same for text that is broken into lines, which may grow until 20 columns or 8 lines fit.
int choose_text_scale(int frame_width, int frame_height, HudSize size);

struct PictureSize {
  int width = 0, height = 0;
};

// Appends what it draws to a list. Coordinates are relative to the panel's upper left corner, x right and y
// down; they may be outside it. Pictures and list must outlive the panel, which is cheap to copy.
class Panel {
 public:
  Panel(const assets::Pictures& pictures, render::DrawList& io_list, int frame_width, int frame_height,
        int scale)
      : pictures_(&pictures),
        list_(&io_list),
        frame_width_(frame_width),
        frame_height_(frame_height),
        scale_(scale) {}

  // Panels at other places of the same frame: 320 wide and `height` high, horizontally centered, at the
  // bottom or in the middle of the frame. `left_px` and `top_px` are in frame pixels.
  Panel at_bottom(int height) const { return with_top(frame_height_ - height * scale_); }
  Panel in_middle(int height) const { return with_top((frame_height_ - height * scale_) / 2); }
  Panel with_top(int top_px) const;
  Panel at(int left_px, int top_px) const;
  // A panel whose corner is the center of the frame.
  Panel centered() const { return at(frame_width_ / 2, frame_height_ / 2); }
  // A panel with the same corner and another scale.
  Panel with_scale(int scale) const;

  int scale() const { return scale_; }
  int frame_width_px() const { return frame_width_; }
  int frame_height_px() const { return frame_height_; }

  // Whether the game has this picture itself.
  bool has_picture(std::string_view name) const { return pictures_->find_real(name) != nullptr; }
  // Draws a picture of the game (assets/pictures.h). Draws nothing if there is no picture of that name.
  void draw_picture(std::string_view name, int x, int y, float opacity = 1) const;
  // The size of that picture in its own pixels; 0 if there is none.
  PictureSize picture_size(std::string_view name) const;
  // Draws it centered on the panel's 320 pixels.
  void draw_centered_picture(std::string_view name, int y) const;
  // Fills with the palette color `index`.
  void fill(int x, int y, int width, int height, std::uint8_t index, float opacity = 1) const;
  // Draw characters of the console's character set, 8 pixels apart.
  void draw_character(std::uint8_t character, int x, int y, float opacity = 1) const;
  void draw_text(std::string_view text, int x, int y, float opacity = 1) const;
  // Draws large digits, 24 pixels apart, right-aligned in `digits` places. A number that does not fit is
  // shown as the largest or smallest that does. `alarm`: in the warning color.
  void draw_number(int value, int digits, bool alarm, int x, int y) const;

 private:
  const assets::Pictures* pictures_;
  render::DrawList* list_;
  int frame_width_, frame_height_, scale_;
  int left_px_ = 0, top_px_ = 0;
};

// A number right-aligned in `width` characters, limited like Panel::draw_number().
std::string align_right(int value, int width);

}  // namespace temblor::client
