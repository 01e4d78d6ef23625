#include "client/hud/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace temblor::client {

namespace {

// The frame size that each step of the automatic scale needs: at 2 the status bar is readable and hides
// little.
constexpr int kSuitableWidth = 480, kSuitableHeight = 300;
constexpr int kMinColumns = 20, kMinLines = 8;  // of text
constexpr int kLargeDigitWidth = 24;
constexpr int kCharactersPerRow = 16;

// Limits a number to what fits in `digits` characters: 3 digits hold -99 to 999.
int clamp_to_digits(int value, int digits) {
  int limit = 1;
  for (int i = 0; i < digits; ++i) limit *= 10;
  return std::clamp(value, -limit / 10 + 1, limit - 1);
}

// The scale without its upper limit.
int compute_wanted_scale(int frame_width, int frame_height, HudSize size) {
  const int suitable = std::min(frame_width / kSuitableWidth, frame_height / kSuitableHeight);
  const int scale = size.scale > 0 ? size.scale : std::max(1, suitable);
  return static_cast<int>(std::lround(static_cast<float>(scale) * size.text));
}

}  // namespace

int choose_scale(int frame_width, int frame_height, HudSize size) {
  const int largest = std::max(1, std::min(frame_width / kScreenWidth, frame_height / kScreenHeight));
  return std::clamp(compute_wanted_scale(frame_width, frame_height, size), 1, largest);
}

int choose_text_scale(int frame_width, int frame_height, HudSize size) {
  const int largest = std::max(
      1, std::min(frame_width / (kMinColumns * kCharacterSide), frame_height / (kMinLines * kTextLine)));
  return std::clamp(compute_wanted_scale(frame_width, frame_height, size), 1, largest);
}

std::string align_right(int value, int width) {
  return fmt::format("{:{}}", clamp_to_digits(value, width), width);
}

Panel Panel::with_top(int top_px) const {
  return at((frame_width_ - kScreenWidth * scale_) / 2, top_px);
}

Panel Panel::at(int left_px, int top_px) const {
  Panel moved = *this;
  moved.left_px_ = left_px;
  moved.top_px_ = top_px;
  return moved;
}

Panel Panel::with_scale(int scale) const {
  Panel scaled = *this;
  scaled.scale_ = scale;
  return scaled;
}

void Panel::draw_picture(std::string_view name, int x, int y, float opacity) const {
  const formats::Picture* const picture = pictures_->find(name);
  if (picture == nullptr) return;
  list_->commands.push_back(
      {.picture = picture,
       .area = {left_px_ + x * scale_, top_px_ + y * scale_, static_cast<int>(picture->width) * scale_,
                static_cast<int>(picture->height) * scale_},
       .scale = scale_,
       .opacity = opacity});
}

PictureSize Panel::picture_size(std::string_view name) const {
  const formats::Picture* const picture = pictures_->find(name);
  if (picture == nullptr) return {};
  return {static_cast<int>(picture->width), static_cast<int>(picture->height)};
}

void Panel::draw_centered_picture(std::string_view name, int y) const {
  if (const formats::Picture* const found = pictures_->find(name))
    draw_picture(name, (kScreenWidth - static_cast<int>(found->width)) / 2, y);
}

void Panel::fill(int x, int y, int width, int height, std::uint8_t index, float opacity) const {
  list_->commands.push_back(
      {.area = {left_px_ + x * scale_, top_px_ + y * scale_, width * scale_, height * scale_},
       .fill = index,
       .opacity = opacity});
}

// Characters are parts of one picture of 16 x 16 characters. Spaces draw nothing.
void Panel::draw_character(std::uint8_t character, int x, int y, float opacity) const {
  constexpr int kShape = 127;  // codes from 128 on are the same shapes in another color
  if ((character & kShape) == ' ') return;
  list_->commands.push_back({.picture = &pictures_->characters(),
                             .area = {left_px_ + x * scale_, top_px_ + y * scale_, kCharacterSide * scale_,
                                      kCharacterSide * scale_},
                             .part_x = character % kCharactersPerRow * kCharacterSide,
                             .part_y = character / kCharactersPerRow * kCharacterSide,
                             .scale = scale_,
                             .opacity = opacity});
}

void Panel::draw_text(std::string_view text, int x, int y, float opacity) const {
  for (const char c : text) {
    draw_character(static_cast<std::uint8_t>(c), x, y, opacity);
    x += kCharacterSide;
  }
}

// The pictures are num_0 to num_9 and num_minus, and anum_... in the warning color.
void Panel::draw_number(int value, int digits, bool alarm, int x, int y) const {
  for (const char c : align_right(value, digits)) {
    if (c != ' ')
      draw_picture(
          fmt::format("{}_{}", alarm ? "anum" : "num", c == '-' ? std::string("minus") : std::string(1, c)),
          x, y);
    x += kLargeDigitWidth;
  }
}

}  // namespace temblor::client
