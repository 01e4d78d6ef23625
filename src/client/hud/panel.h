// A place on the frame to lay out the original's 2-D parts in, in the original's pixels.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "assets/pictures.h"
#include "render/draw_list.h"

namespace temblor::client {

// The original's screen, its status bar, and a character.
constexpr int kScreenWidth = 320, kScreenHeight = 200;
constexpr int kBarHeight = 24, kInventoryHeight = 24;
constexpr int kCharacterSide = 8;

// Frame pixels for each of the original's: `wished`, or (0) what suits the size: 3 at 1920 x 1080. Never so
// many that the original's screen would not fit, where it can.
int choose_scale(int frame_width, int frame_height, int wished);

// Everything a panel draws is appended to its list. Coordinates are from its upper left corner, x right, y
// down; they may be negative and lead out of it.
class Panel {
 public:
  Panel(const assets::Pictures& pictures, render::DrawList& io_list, int frame_width, int frame_height,
        int scale)
      : pictures_(&pictures),
        list_(&io_list),
        frame_width_(frame_width),
        frame_height_(frame_height),
        scale_(scale) {}

  // The same with its corner elsewhere: 320 wide in the middle of the frame, `height` of the original's
  // pixels high, at its bottom or in its middle; `top_px`: so many pixels below the frame's top.
  Panel at_bottom(int height) const { return with_top(frame_height_ - height * scale_); }
  Panel in_middle(int height) const { return with_top((frame_height_ - height * scale_) / 2); }
  Panel with_top(int top_px) const;
  Panel at(int left_px, int top_px) const;
  Panel centered() const {
    return at(frame_width_ / 2, frame_height_ / 2);
  }                               // its corner in the frame's middle
  Panel in_frame_pixels() const;  // the same corner, a scale of 1

  int frame_height_px() const { return frame_height_; }

  // Nothing for a name that there is no picture of.
  void picture(std::string_view name, int x, int y, float opacity = 1) const;
  void picture_in_middle(std::string_view name, int y) const;  // of the panel's 320
  void fill(int x, int y, int width, int height, std::uint8_t index, float opacity = 1) const;
  void character(std::uint8_t character, int x, int y) const;
  void text(std::string_view text, int x, int y) const;
  // `digits` large digits, 24 apart, right-aligned; what has more is shown as the largest that fits, or the
  // smallest. `alarm`: in the color that warns.
  void number(int value, int digits, bool alarm, int x, int y) const;

 private:
  const assets::Pictures* pictures_;
  render::DrawList* list_;
  int frame_width_, frame_height_, scale_;
  int left_px_ = 0, top_px_ = 0;
};

// A whole number, right-aligned in `width` characters; cut off as Panel::number() does.
std::string right_aligned(int value, int width);

}  // namespace temblor::client
