#include "client/console/console_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/console/console_ui.h"

namespace temblor::client {

namespace {

// Palette indices.
constexpr std::uint8_t kConsoleBlack = 0, kConsoleWhite = 254;
constexpr int kConsoleMargin = 1;  // columns

// A palette translation for high contrast. The character pictures draw bright glyphs with shadows in the
// palette's six darkest grays: those become black, everything else white.
constexpr render::ColorTranslation kBlackAndWhite = [] {
  constexpr std::size_t kDarkGrays = 6;
  render::ColorTranslation colors{};
  colors.fill(kConsoleWhite);
  for (std::size_t i = 0; i < kDarkGrays; ++i) colors[i] = kConsoleBlack;
  return colors;
}();

int divide_rounding_up(int value, int by) {
  return (value + by - 1) / by;
}

}  // namespace

ConsoleCanvas::ConsoleCanvas(const assets::Pictures& pictures, const ConsoleSettings& settings, int width,
                             int height, render::DrawList& io_list)
    : pictures_(pictures),
      settings_(settings),
      list_(io_list),
      frame_width_(width),
      frame_height_(height),
      scale_(choose_text_scale(width, height, {settings.scale, settings.text_size})),
      panel_(pictures, io_list, width, height, scale_) {}

int ConsoleCanvas::columns() const {
  return std::max(1, frame_width_ / (scale_ * kCharacterSide) - 2 * kConsoleMargin);
}

void ConsoleCanvas::fill_plain(int top, int bottom, float opacity) const {
  list_.commands.push_back({.area = {0, top * scale_, frame_width_, (bottom - top) * scale_},
                            .fill = kConsoleBlack,
                            .opacity = opacity});
}

// The picture's lower edge stays at the console's lower edge while the console slides, as in stock Quake. It
// is centered and scaled by a whole number so that it covers the width.
void ConsoleCanvas::draw_background(int bottom, float opacity) const {
  const formats::Picture* const picture =
      settings_.high_contrast ? nullptr : pictures_.find_real("gfx/conback.lmp");
  if (picture == nullptr) return fill_plain(0, bottom, settings_.high_contrast ? 1 : opacity);
  const auto width = static_cast<int>(picture->width), height = static_cast<int>(picture->height);
  const int scale =
      std::max(divide_rounding_up(frame_width_, width), divide_rounding_up(frame_height_, height));
  list_.commands.push_back({.picture = picture,
                            .area = {(frame_width_ - width * scale) / 2, bottom * scale_ - height * scale,
                                     width * scale, height * scale},
                            .scale = scale,
                            .opacity = opacity});
}

void ConsoleCanvas::draw_row_background(int y) const {
  if (settings_.high_contrast) fill_plain(y, y + kTextLine, 1);
}

// For high contrast, moves the commands that the panel has just appended to the white half of the character
// picture and replaces their colors.
void ConsoleCanvas::draw_text(std::string_view glyphs, int column, int y) const {
  const std::size_t first = list_.commands.size();
  panel_.draw_text(glyphs, (column + kConsoleMargin) * kCharacterSide, y);
  if (!settings_.high_contrast) return;
  // Rows of the character picture, in pixels: the lower half (codes 128 to 255) repeats the upper one in
  // bronze.
  constexpr int kBronzeRow = 64;
  for (std::size_t i = first; i < list_.commands.size(); ++i) {
    list_.commands[i].part_y %= kBronzeRow;
    list_.commands[i].translation = &kBlackAndWhite;
  }
}

void ConsoleCanvas::draw_right_aligned_text(std::string_view glyphs, int y) const {
  const int column = columns() - static_cast<int>(glyphs.size());
  if (column > 0) draw_text(glyphs, column, y);
}

void ConsoleCanvas::draw_cursor(int column, int y, double time_s) const {
  constexpr double kBlinksPerSecond = 2;
  constexpr char kBlock = 11;
  const double blinks = time_s * kBlinksPerSecond;
  if (blinks - std::floor(blinks) < 0.5) draw_text({&kBlock, 1}, column, y);
}

// Scrolls sideways by the smallest amount that keeps the cursor's column inside the row.
InputLineView layout_input_line(std::string_view prompt, std::string_view glyphs, std::size_t cursor,
                                int columns) {
  const auto width = static_cast<std::size_t>(columns);
  // A prompt that leaves no room for the text is shortened.
  prompt = prompt.substr(0, width / 2);
  const std::size_t room = width - prompt.size();
  const std::size_t first = cursor >= room ? cursor - room + 1 : 0;
  return {std::string(prompt) + std::string(glyphs.substr(first, room)),
          static_cast<int>(prompt.size() + cursor - first)};
}

}  // namespace temblor::client
