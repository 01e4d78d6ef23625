#include "client/menu/canvas.h"

#include <algorithm>
#include <cmath>

namespace temblor::client {
namespace {

// The share of the frame that a 320 x 200 screen would fill.
constexpr double kFilled = 0.75;
// Limits of the canvas in its own pixels. On a larger one the eye has to travel too far from a title to its
// rows; a smaller one has no room for a word.
constexpr int kMaxWidth = 424, kMaxHeight = 300;
constexpr int kMinWidth = 5 * kCharacterSide, kMinHeight = kCharacterSide + 2;
// The smallest canvas of a player who wants large text: 20 columns, which pages still fit in.
constexpr int kMinLargeWidth = 160, kMinLargeHeight = 100;
// Characters of 8 pixels are small on today's displays, so a frame with this much room uses scale 2.
constexpr int kMinWidthAtTwo = 288, kMinHeightAtTwo = 180;
// Both ends of the palette's first row, which is gray.
constexpr std::uint8_t kMenuBlack = 0, kLight = 15;

}  // namespace

int choose_menu_scale(int frame_width, int frame_height, double text_size) {
  const double fitting = std::min(static_cast<double>(frame_width) / kScreenWidth,
                                  static_cast<double>(frame_height) / kScreenHeight);
  const int largest = text_size > 1 ? std::min(frame_width / kMinLargeWidth, frame_height / kMinLargeHeight)
                                    : static_cast<int>(fitting);
  const int scale =
      std::clamp(static_cast<int>(std::lround(fitting * kFilled * text_size)), 1, std::max(largest, 1));
  const bool has_room_for_two = frame_width >= 2 * kMinWidthAtTwo && frame_height >= 2 * kMinHeightAtTwo;
  return scale == 1 && text_size >= 1 && has_room_for_two ? 2 : scale;
}

std::optional<Canvas> Canvas::fit(const assets::Pictures& pictures, int frame_width, int frame_height,
                                  const CanvasLook& look, render::DrawList& io_list) {
  if (frame_width < kMinWidth || frame_height < kMinHeight) return std::nullopt;
  const int scale = choose_menu_scale(frame_width, frame_height, look.text_size);
  Box area;
  area.width = std::min(frame_width / scale, kMaxWidth) * scale;
  area.height = std::min(frame_height / scale, kMaxHeight) * scale;
  area.x = (frame_width - area.width) / 2;
  area.y = (frame_height - area.height) / 2;
  Canvas canvas(pictures, frame_width, frame_height, scale, area, io_list);
  canvas.high_contrast_ = look.high_contrast;
  return canvas;
}

Canvas::Canvas(const assets::Pictures& pictures, int frame_width, int frame_height, int scale,
               const Box& area, render::DrawList& io_list)
    : pictures_(&pictures),
      panel_(Panel(pictures, io_list, frame_width, frame_height, scale).at(area.x, area.y)),
      large_(Panel(pictures, io_list, frame_width, frame_height, scale * 2)),
      list_(&io_list),
      area_(area),
      frame_width_(frame_width),
      frame_height_(frame_height),
      scale_(scale) {}

Box Canvas::to_frame(const Box& box) const {
  return {area_.x + box.x * scale_, area_.y + box.y * scale_, box.width * scale_, box.height * scale_};
}

void Canvas::dim() const {
  list_->commands.push_back({.area = {0, 0, frame_width_, frame_height_},
                             .fill = kMenuBlack,
                             .opacity = high_contrast_ ? 1.0f : kStrongOpacity});
}

void Canvas::highlight(const Box& box) const {
  constexpr float kHighContrast = 0.4375f;
  fill(box, kLight, high_contrast_ ? kHighContrast : kFaintOpacity);
}

void Canvas::fill(const Box& box, std::uint8_t index, float opacity) const {
  panel_.fill(box.x, box.y, box.width, box.height, index, opacity);
}

// High contrast draws the white half of the character set only. Large text comes from a panel with twice the
// scale, at the same place.
void Canvas::draw_text(std::string_view text, int x, int y, int size) const {
  const Box place = to_frame({x, y, 0, 0});
  const Panel panel = (size == 1 ? panel_ : large_).at(place.x, place.y);
  constexpr unsigned char kFirstColor = 127;
  int right = 0;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    panel.draw_character(high_contrast_ ? letter & kFirstColor : letter, right, 0);
    right += kCharacterSide;
  }
}

void Canvas::draw_centered_text(std::string_view words, int y, int size) const {
  draw_text(words, (width() - static_cast<int>(words.size()) * kCharacterSide * size) / 2, y, size);
}

void Canvas::draw_character(char c, int x, int y) const {
  panel_.draw_character(static_cast<std::uint8_t>(c), x, y);
}

// Only the game's own pictures count: a placeholder would be worse than no picture.
void Canvas::draw_plaque(std::string_view name, int x, int y) const {
  constexpr std::uint32_t kMaxPlaque = 48;
  const formats::Picture* const picture = pictures_->find_real(name);
  if (picture != nullptr && picture->width <= kMaxPlaque) panel_.draw_picture(name, x, y);
}

int Canvas::draw_title_picture(std::string_view name, int y) const {
  constexpr std::uint32_t kMaxTitle = 32;
  const formats::Picture* const picture = pictures_->find_real(name);
  if (picture == nullptr || picture->height > kMaxTitle || static_cast<int>(picture->width) > width())
    return 0;
  panel_.draw_picture(name, (width() - static_cast<int>(picture->width)) / 2, y);
  return static_cast<int>(picture->height);
}

void Canvas::draw_unscaled(const formats::Picture& picture, const Box& box) const {
  const Box place = to_frame(box);
  const auto picture_width = static_cast<int>(picture.width),
             picture_height = static_cast<int>(picture.height);
  list_->commands.push_back(
      {.picture = &picture,
       .area = {place.x + (place.width - picture_width) / 2, place.y + (place.height - picture_height) / 2,
                picture_width, picture_height}});
}

}  // namespace temblor::client
