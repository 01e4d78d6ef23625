#include "client/console/console_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/console/console_ui.h"

namespace temblor::client {

namespace {

constexpr std::uint8_t kBlack = 0, kWhite = 254;
constexpr int kMargin = 1;  // columns

// The white characters' letters are bright, the shadows at their edges of the palette's dark grays.
constexpr render::ColorTranslation kBlackAndWhite = [] {
  constexpr std::size_t kDarkGrays = 6;
  render::ColorTranslation colors{};
  colors.fill(kWhite);
  for (std::size_t i = 0; i < kDarkGrays; ++i) colors[i] = kBlack;
  return colors;
}();

// Text may be as large as it likes while a few rows of it still fit.
int text_scale(int width, int height, const ConsoleSettings& settings) {
  constexpr int kMinColumns = 20, kMinRows = 8;
  const int most =
      std::max(1, std::min(width / (kMinColumns * kCharacterSide), height / (kMinRows * kCharacterSide)));
  const auto scale = static_cast<float>(choose_scale(width, height, settings.scale));
  return std::clamp(static_cast<int>(std::lround(scale * settings.text_size)), 1, most);
}

int divided_up(int value, int by) {
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
      scale_(text_scale(width, height, settings)),
      panel_(pictures, io_list, width, height, scale_) {}

int ConsoleCanvas::columns() const {
  return std::max(1, frame_width_ / (scale_ * kCharacterSide) - 2 * kMargin);
}

void ConsoleCanvas::plain_fill(int top, int bottom, float opacity) const {
  list_.commands.push_back(
      {.area = {0, top * scale_, frame_width_, (bottom - top) * scale_}, .fill = kBlack, .opacity = opacity});
}

// The picture hangs from its lower edge, in the middle, large enough to leave nothing free.
void ConsoleCanvas::background(int bottom, float opacity) const {
  const formats::Picture* const picture =
      settings_.high_contrast ? nullptr : pictures_.find_real("gfx/conback.lmp");
  if (picture == nullptr) return plain_fill(0, bottom, settings_.high_contrast ? 1 : opacity);
  const auto width = static_cast<int>(picture->width), height = static_cast<int>(picture->height);
  const int scale = std::max(divided_up(frame_width_, width), divided_up(frame_height_, height));
  list_.commands.push_back({.picture = picture,
                            .area = {(frame_width_ - width * scale) / 2, bottom * scale_ - height * scale,
                                     width * scale, height * scale},
                            .scale = scale,
                            .opacity = opacity});
}

void ConsoleCanvas::row_background(int y) const {
  if (settings_.high_contrast) plain_fill(y, y + kCharacterSide, 1);
}

void ConsoleCanvas::text(std::string_view glyphs, int column, int y) const {
  const std::size_t first = list_.commands.size();
  panel_.text(glyphs, (column + kMargin) * kCharacterSide, y);
  if (!settings_.high_contrast) return;
  constexpr int kBronzeRow = 64;  // of the characters' picture: the lower half is the upper one in bronze
  for (std::size_t i = first; i < list_.commands.size(); ++i) {
    list_.commands[i].part_y %= kBronzeRow;
    list_.commands[i].translation = &kBlackAndWhite;
  }
}

void ConsoleCanvas::text_at_right(std::string_view glyphs, int y) const {
  const int column = columns() - static_cast<int>(glyphs.size());
  if (column > 0) text(glyphs, column, y);
}

void ConsoleCanvas::cursor(int column, int y, double time_s) const {
  constexpr double kBlinksPerSecond = 2;
  constexpr char kBlock = 11;
  const double blinks = time_s * kBlinksPerSecond;
  if (blinks - std::floor(blinks) < 0.5) text({&kBlock, 1}, column, y);
}

ShownInput show_input(std::string_view prompt, std::string_view glyphs, std::size_t cursor, int columns) {
  const auto width = static_cast<std::size_t>(columns);
  // A prompt that leaves no room for the text is cut off.
  prompt = prompt.substr(0, width / 2);
  const std::size_t room = width - prompt.size();
  const std::size_t first = cursor >= room ? cursor - room + 1 : 0;
  return {std::string(prompt) + std::string(glyphs.substr(first, room)),
          static_cast<int>(prompt.size() + cursor - first)};
}

}  // namespace temblor::client
