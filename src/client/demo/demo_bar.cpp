#include "client/demo/demo_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "client/hud/center_text.h"

namespace temblor::client {

namespace {

// Layout in the panel's 320 x 16 pixels.
constexpr int kHeight = 16, kBarLeft = 8, kWidth = kScreenWidth - 2 * kBarLeft, kBarTop = 10,
              kBarThickness = 3;
constexpr std::uint8_t kDark = 0, kBright = 12;

// Minutes and seconds: "1:05".
std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::max(0.0, seconds));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

// Describes the state for the viewer: the end, a pause, or an unusual speed.
std::string state_text(const DemoSession& session) {
  if (session.has_ended()) return "end";
  if (session.is_paused()) return "paused";
  return session.speed() == 1 ? "" : fmt::format("{:.3g}x", session.speed());
}

double length_s(const DemoSession& session) {
  return session.end_s() - session.begin_s();
}

}  // namespace

void draw_demo_bar(const DemoSession& session, const assets::Pictures& pictures, int width, int height,
                   HudSize size, render::DrawList& io_list) {
  const Panel panel = Panel(pictures, io_list, width, height, choose_scale(width, height, size))
                          .at_bottom(kHeight + kBarHeight + kInventoryHeight);
  const double elapsed_s = session.time_s() - session.begin_s();
  // A demo of a single packet has no length; its bar is full.
  const double part = length_s(session) > 0 ? std::clamp(elapsed_s / length_s(session), 0.0, 1.0) : 1;
  panel.draw_text(fmt::format("{} / {}", clock_text(elapsed_s), clock_text(length_s(session))), kBarLeft, 0);
  const std::string state = state_text(session);
  panel.draw_text(state, kBarLeft + kWidth - static_cast<int>(state.size()) * kCharacterSide, 0);
  panel.fill(kBarLeft - 1, kBarTop - 1, kWidth + 2, kBarThickness + 2, kDark);
  panel.fill(kBarLeft, kBarTop, static_cast<int>(std::lround(part * kWidth)), kBarThickness, kBright);
}

void draw_free_camera_hint(const assets::Pictures& pictures, int width, int height, HudSize size,
                           render::DrawList& io_list) {
  const Panel letters(pictures, io_list, width, height, choose_text_scale(width, height, size));
  const Panel place = letters.with_top(kCharacterSide * letters.scale());
  draw_text_lines(place, "Free camera: F returns to the player\nWASD, E and Q fly; Shift: faster", kTextLine);
}

double find_demo_time(const DemoSession& session, int x_px, int width, int height, HudSize size) {
  const int pixel = choose_scale(width, height, size);
  const int left_px = (width - kScreenWidth * pixel) / 2 + kBarLeft * pixel;
  const double part = std::clamp(static_cast<double>(x_px - left_px) / (kWidth * pixel), 0.0, 1.0);
  return session.begin_s() + part * length_s(session);
}

}  // namespace temblor::client
