#include "client/hud/connection_warning.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/hud/center_text.h"

namespace temblor::client {
namespace {

constexpr double kIconAfter_s = 0.3, kTextAfter_s = 2;
// Below the lines of messages, on the original's screen.
constexpr int kTop = 40, kIconSide = 32;

}  // namespace

void draw_connection_warning(const assets::Pictures& pictures, const net::ServerSilence& silence,
                             HudSize size, int width, int height, render::DrawList& io_list) {
  if (silence.lasts_s < kIconAfter_s) return;
  const Panel panel = Panel(pictures, io_list, width, height, choose_scale(width, height, size)).with_top(0);
  if (panel.has_picture("net")) panel.draw_picture("net", (kScreenWidth - kIconSide) / 2, kTop);
  if (silence.lasts_s < kTextAfter_s) return;
  const Panel letters = panel.with_scale(choose_text_scale(width, height, size));
  draw_text_lines(letters.with_top((kTop + kIconSide + kCharacterSide / 2) * panel.scale()),
                  fmt::format("No word from the server for {:.0f} s\nLeaving the game in {:.0f} s",
                              silence.lasts_s, std::max(0.0, silence.ends_in_s)),
                  kTextLine);
}

}  // namespace temblor::client
