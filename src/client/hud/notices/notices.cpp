#include "client/hud/notices/notices.h"

#include <algorithm>
#include <utility>

namespace temblor::client {

namespace {

// The pickups of a low frame must not reach the short messages in its middle, which end here.
constexpr double kMessagesEnd = 0.52;  // share of the frame's height

int count_fitting_pickups(const Panel& panel, int bottom) {
  const double room = panel.frame_height_px() * (1 - kMessagesEnd) / panel.scale() - bottom;
  return std::clamp(static_cast<int>(room / kPickupHeight), 1, kMaxPickups);
}

}  // namespace

void Notices::begin_level() {
  pickups_.begin_level();
  weapons_.begin_level();
  timers_.begin_level();
  arcs_.begin_level();
  was_in_game_ = false;
}

void Notices::advance(const Game& game, const Events& events, double time_s) {
  const bool is_in_game = game.signon == kPlaying && game.stat(Stat::kHealth) > 0;
  const bool is_watched = std::exchange(was_in_game_, is_in_game) && is_in_game;
  pickups_.advance(game, events, pack_, time_s, is_watched);
  weapons_.advance(game, pack_, time_s, is_watched);
  timers_.advance(game, time_s, is_watched);
  arcs_.advance(events, time_s);
}

void Notices::draw(const Panel& panel, const Game& game, double time_s, const NoticeSettings& settings,
                   const LayoutHeights& heights, const std::optional<render::Camera>& camera) const {
  const int scale = panel.scale(), width = panel.frame_width_px(), height = panel.frame_height_px();
  const auto above = [&](int layout_height) { return height - (layout_height + kNoticeGap) * scale; };
  if (settings.damage && camera) arcs_.draw(panel, *camera, time_s);
  if (settings.pickups)
    pickups_.draw(panel.at(kNoticeMargin * scale, above(heights.left)),
                  count_fitting_pickups(panel, heights.left + kNoticeGap), time_s);
  if (settings.weapons)
    weapons_.draw(panel.at(width / 2, above(heights.middle)), game, pack_,
                  width / scale - 2 * (kNoticeMargin + kPickupWidth), time_s);
  if (settings.power_timers)
    timers_.draw(panel.at(width - kNoticeMargin * scale, above(heights.right)), game, pack_, time_s);
}

}  // namespace temblor::client
