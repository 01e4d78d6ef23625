#include "client/hud/crosshair.h"

#include <algorithm>
#include <cmath>

namespace temblor::client {
namespace {

constexpr std::uint8_t kBlack = 0;

// A rectangle of the crosshair.
struct Bar {
  // Relative to the frame's center, in line widths.
  int x, y, width, height;
};

// Draws a bar with a dark edge half a line wide, so that it is visible on any background. Bars are shifted by
// half a line, so that a line is centered on the frame.
void draw_bar(const Panel& middle, const Bar& bar, int line_px, std::uint8_t color) {
  const int edge_px = std::max(1, line_px / 2), shift_px = line_px / 2;
  const int x = bar.x * line_px - shift_px, y = bar.y * line_px - shift_px;
  const int width = bar.width * line_px, height = bar.height * line_px;
  middle.fill(x - edge_px, y - edge_px, width + 2 * edge_px, height + 2 * edge_px, kBlack);
  middle.fill(x, y, width, height, color);
}

}  // namespace

void draw_crosshair(const Panel& panel, const CrosshairLook& look) {
  if (look.shape == Crosshair::kNone) return;
  if (look.shape == Crosshair::kCharacter) {
    const int scale =
        std::max(1, static_cast<int>(std::lround(static_cast<float>(panel.scale()) * look.scale)));
    return panel.with_scale(scale).centered().draw_character('+', -kCharacterSide / 2, -kCharacterSide / 2);
  }
  // In frame pixels: at the status bar's scale it would hide the target.
  constexpr int kLinesPerFrame = 540;
  const int line_px = std::max(1, static_cast<int>(panel.frame_height_px() * look.scale / kLinesPerFrame));
  const Panel middle = panel.with_scale(1).centered();
  if (look.shape == Crosshair::kDot) return draw_bar(middle, {0, 0, 1, 1}, 2 * line_px, look.color);
  // Four arms around a gap, so that the target itself stays visible.
  constexpr int kGap = 3, kArm = 5;
  for (const Bar& arm : {Bar{-kGap - kArm + 1, 0, kArm, 1}, Bar{kGap, 0, kArm, 1},
                         Bar{0, -kGap - kArm + 1, 1, kArm}, Bar{0, kGap, 1, kArm}})
    draw_bar(middle, arm, line_px, look.color);
}

}  // namespace temblor::client
