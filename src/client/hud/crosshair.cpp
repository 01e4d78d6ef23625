#include "client/hud/crosshair.h"

#include <algorithm>

namespace temblor::client {
namespace {

constexpr std::uint8_t kBlack = 0;

struct Bar {
  int x, y, width, height;  // from the frame's middle, in widths of a line
};

// With a dark edge, half a line wide, so that it is seen in front of anything.
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
  if (look.shape == Crosshair::kCharacter)
    return panel.centered().character('+', -kCharacterSide / 2, -kCharacterSide / 2);
  // In the frame's own pixels: as wide as the status bar's it would hide what it points at.
  constexpr int kLinesAFrame = 540;
  const int line_px = std::max(1, panel.frame_height_px() / kLinesAFrame);
  const Panel middle = panel.in_frame_pixels().centered();
  if (look.shape == Crosshair::kDot) return draw_bar(middle, {0, 0, 1, 1}, 2 * line_px, look.color);
  constexpr int kGap = 3, kArm = 5;
  for (const Bar& arm : {Bar{-kGap - kArm + 1, 0, kArm, 1}, Bar{kGap, 0, kArm, 1},
                         Bar{0, -kGap - kArm + 1, 1, kArm}, Bar{0, kGap, 1, kArm}})
    draw_bar(middle, arm, line_px, look.color);
}

}  // namespace temblor::client
