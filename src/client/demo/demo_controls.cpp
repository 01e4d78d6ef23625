#include "client/demo/demo_controls.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace temblor::client {

using platform::Key;

namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 8};
constexpr double kSmallSeek_s = 5, kLargeSeek_s = 30;
constexpr float kFastFactor = 4;

}  // namespace

bool DemoControls::handle(const platform::InputEvent& event) {
  if (const auto* change = std::get_if<platform::KeyChange>(&event.what)) {
    if (const std::optional<Held> held = held_by(change->key)) held_[*held] = change->down;
    if (!change->down || !press(change->key)) return false;
    idle_s_ = 0;
    return true;
  }
  if (const auto* moved = std::get_if<platform::MouseMoved>(&event.what); moved != nullptr && flies_) {
    turned_right_ += moved->right;
    turned_down_ += moved->down;
    return true;
  }
  if (const auto* focus = std::get_if<platform::FocusChanged>(&event.what);
      focus != nullptr && !focus->focused)
    held_ = {};
  return false;
}

std::optional<DemoControls::Held> DemoControls::held_by(Key key) {
  constexpr std::pair<Key, Held> kKeys[] = {
      {Key{'w'}, kForward}, {Key{'s'}, kBack}, {Key{'a'}, kLeft},    {Key{'d'}, kRight},
      {Key{'e'}, kUp},      {Key{'q'}, kDown}, {Key::kShift, kFast},
  };
  for (const auto& [held_key, held] : kKeys)
    if (held_key == key) return held;
  return std::nullopt;
}

bool DemoControls::press(Key key) {
  const double seek_s = held_[kFast] ? kLargeSeek_s : kSmallSeek_s;
  if (key == Key::kSpace)
    turns_pause_ = !turns_pause_;
  else if (key == Key::kLeftArrow || key == Key::kRightArrow)
    seconds_ += key == Key::kLeftArrow ? -seek_s : seek_s;
  else if (key == Key::kUpArrow || key == Key::kDownArrow)
    faster_ += key == Key::kUpArrow ? 1 : -1;
  else if (key == Key::kBackspace)
    resets_speed_ = true;
  else if (key == Key{','} || key == Key{'.'})
    packets_ += key == Key{','} ? -1 : 1;
  else if (key == Key::kHome)
    seeks_begin_ = true;
  else if (key == Key::kEnd)
    seeks_end_ = true;
  else if (key == Key::kPageUp || key == Key::kPageDown)
    recordings_ += key == Key::kPageUp ? -1 : 1;
  else if (key == Key{'f'})
    flies_ = !flies_, has_place_ = false;
  else
    return flies_ && held_by(key);
  return true;
}

void DemoControls::set_speed(DemoSession& io_session) const {
  const auto last = static_cast<std::ptrdiff_t>(std::size(kSpeeds)) - 1;
  const double now = resets_speed_ ? 1 : io_session.speed();
  const std::ptrdiff_t here = std::lower_bound(std::begin(kSpeeds), std::end(kSpeeds), now) - kSpeeds;
  io_session.set_speed(kSpeeds[std::clamp<std::ptrdiff_t>(here + faster_, 0, last)]);
}

void DemoControls::fly(double passed_s, const Settings& settings, const Presentation& shown) {
  if (!has_place_ && shown.has_level()) {
    camera_.place(shown.scene().camera);
    has_place_ = true;
  }
  camera_.turn(turned_down_ * settings.turn_deg_per_count, -turned_right_ * settings.turn_deg_per_count);
  turned_right_ = turned_down_ = 0;
  const auto wish = [&](Held for_it, Held against) {
    return (held_[for_it] ? 1.0f : 0.0f) - (held_[against] ? 1.0f : 0.0f);
  };
  camera_.fly({wish(kForward, kBack), wish(kRight, kLeft), wish(kUp, kDown)},
              settings.fly_speed * (held_[kFast] ? kFastFactor : 1), passed_s);
}

base::Result<bool> DemoControls::go(double passed_s, const PresentationSettings& presentation,
                                    DemoSession& io_session) {
  std::optional<double> sought_s;
  if (seeks_begin_) sought_s = io_session.begin_s();
  if (seeks_end_) sought_s = io_session.end_s();
  if (seconds_ != 0) sought_s = sought_s.value_or(io_session.time_s()) + seconds_;
  if (packets_ != 0) {
    io_session.pause(true);
    return io_session.step(packets_, presentation);
  }
  // Somebody who seeks past the end is to see it.
  if (sought_s) return io_session.seek(std::min(*sought_s, io_session.end_s()), presentation);
  return io_session.advance(passed_s, presentation);
}

base::Result<bool> DemoControls::advance(double passed_s, PresentationSettings presentation,
                                         const Settings& settings, const Presentation& shown,
                                         DemoSession& io_session) {
  idle_s_ += passed_s;
  if (turns_pause_) io_session.pause(!io_session.is_paused());
  if (faster_ != 0 || resets_speed_) set_speed(io_session);
  if (flies_) {
    fly(passed_s, settings, shown);
    if (has_place_) presentation.camera = camera_.camera();
  }
  base::Result<bool> gone = go(passed_s, presentation, io_session);
  turns_pause_ = seeks_begin_ = seeks_end_ = resets_speed_ = false;
  faster_ = packets_ = 0;
  seconds_ = 0;
  return gone;
}

}  // namespace temblor::client
