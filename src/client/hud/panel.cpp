#include "client/hud/panel.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::client {

namespace {

// The smallest frame in which a scale of 2 is readable without hiding much of the game is twice this.
constexpr int kSuitableWidth = 480, kSuitableHeight = 300;
constexpr int kLargeDigit = 24;
constexpr int kCharactersARow = 16;

int bounded(int value, int digits) {
  int most = 1;
  for (int i = 0; i < digits; ++i) most *= 10;
  return std::clamp(value, -most / 10 + 1, most - 1);
}

}  // namespace

int choose_scale(int frame_width, int frame_height, int wished) {
  const int largest = std::min(frame_width / kScreenWidth, frame_height / kScreenHeight);
  const int suitable = std::min(frame_width / kSuitableWidth, frame_height / kSuitableHeight);
  return std::max(1, wished > 0 ? std::min(wished, largest) : suitable);
}

std::string right_aligned(int value, int width) {
  return fmt::format("{:{}}", bounded(value, width), width);
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

Panel Panel::in_frame_pixels() const {
  Panel unscaled = *this;
  unscaled.scale_ = 1;
  return unscaled;
}

void Panel::picture(std::string_view name, int x, int y, float opacity) const {
  const formats::Picture* const picture = pictures_->find(name);
  if (picture == nullptr) return;
  list_->commands.push_back(
      {.picture = picture,
       .area = {left_px_ + x * scale_, top_px_ + y * scale_, static_cast<int>(picture->width) * scale_,
                static_cast<int>(picture->height) * scale_},
       .scale = scale_,
       .opacity = opacity});
}

void Panel::picture_in_middle(std::string_view name, int y) const {
  if (const formats::Picture* const found = pictures_->find(name))
    picture(name, (kScreenWidth - static_cast<int>(found->width)) / 2, y);
}

void Panel::fill(int x, int y, int width, int height, std::uint8_t index, float opacity) const {
  list_->commands.push_back(
      {.area = {left_px_ + x * scale_, top_px_ + y * scale_, width * scale_, height * scale_},
       .fill = index,
       .opacity = opacity});
}

void Panel::character(std::uint8_t character, int x, int y) const {
  constexpr int kShape = 127;  // the upper half is the lower one in another color
  if ((character & kShape) == ' ') return;
  list_->commands.push_back({.picture = &pictures_->characters(),
                             .area = {left_px_ + x * scale_, top_px_ + y * scale_, kCharacterSide * scale_,
                                      kCharacterSide * scale_},
                             .part_x = character % kCharactersARow * kCharacterSide,
                             .part_y = character / kCharactersARow * kCharacterSide,
                             .scale = scale_});
}

void Panel::text(std::string_view text, int x, int y) const {
  for (const char c : text) {
    character(static_cast<std::uint8_t>(c), x, y);
    x += kCharacterSide;
  }
}

void Panel::number(int value, int digits, bool alarm, int x, int y) const {
  for (const char c : right_aligned(value, digits)) {
    if (c != ' ')
      picture(
          fmt::format("{}_{}", alarm ? "anum" : "num", c == '-' ? std::string("minus") : std::string(1, c)),
          x, y);
    x += kLargeDigit;
  }
}

}  // namespace temblor::client
