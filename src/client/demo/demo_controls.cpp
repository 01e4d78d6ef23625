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
    if (const std::optional<Held> held = find_held_key(change->key)) held_[*held] = change->down;
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

std::optional<DemoControls::Held> DemoControls::find_held_key(Key key) {
  constexpr std::pair<Key, Held> kKeys[] = {
      {Key{'w'}, kForward}, {Key{'s'}, kBack}, {Key{'a'}, kLeft},    {Key{'d'}, kRight},
      {Key{'e'}, kUp},      {Key{'q'}, kDown}, {Key::kShift, kFast},
  };
  for (const auto& [held_key, held] : kKeys)
    if (held_key == key) return held;
  return std::nullopt;
}

// Requests are only stored here; advance() carries them out. So any number of key presses between two frames
// costs one seek.
bool DemoControls::press(Key key) {
  const double seek_s = held_[kFast] ? kLargeSeek_s : kSmallSeek_s;
  if (key == Key::kSpace)
    toggles_pause_ = !toggles_pause_;
  else if (key == Key::kLeftArrow || key == Key::kRightArrow)
    seek_offset_s_ += key == Key::kLeftArrow ? -seek_s : seek_s;
  else if (key == Key::kUpArrow || key == Key::kDownArrow)
    speed_steps_ += key == Key::kUpArrow ? 1 : -1;
  else if (key == Key::kBackspace)
    resets_speed_ = true;
  else if (key == Key{','} || key == Key{'.'})
    packet_steps_ += key == Key{','} ? -1 : 1;
  else if (key == Key::kHome)
    seeks_begin_ = true;
  else if (key == Key::kEnd)
    seeks_end_ = true;
  else if (key == Key::kPageUp || key == Key::kPageDown)
    demo_steps_ += key == Key::kPageUp ? -1 : 1;
  else if (key == Key{'f'})
    flies_ = !flies_, has_camera_ = false;
  else
    return flies_ && find_held_key(key);
  return true;
}

// Moves along kSpeeds. A speed between two entries counts as the higher one.
void DemoControls::change_speed(DemoSession& io_session) const {
  const auto last = static_cast<std::ptrdiff_t>(std::size(kSpeeds)) - 1;
  const double now = resets_speed_ ? 1 : io_session.speed();
  const std::ptrdiff_t here = std::lower_bound(std::begin(kSpeeds), std::end(kSpeeds), now) - kSpeeds;
  io_session.set_speed(kSpeeds[std::clamp<std::ptrdiff_t>(here + speed_steps_, 0, last)]);
}

// The first flight starts at the player's eyes. Later ones start there again, as press() forgets the camera.
void DemoControls::fly(double elapsed_s, const Settings& settings, const Presentation& shown) {
  if (!has_camera_ && shown.has_level()) {
    camera_.place(shown.scene().camera);
    camera_level_ = shown.scene().level;
    has_camera_ = true;
  }
  camera_.turn(turned_down_ * settings.turn_deg_per_count, -turned_right_ * settings.turn_deg_per_count);
  turned_right_ = turned_down_ = 0;
  const auto axis = [&](Held positive, Held negative) {
    return (held_[positive] ? 1.0f : 0.0f) - (held_[negative] ? 1.0f : 0.0f);
  };
  camera_.fly({axis(kForward, kBack), axis(kRight, kLeft), axis(kUp, kDown)},
              settings.fly_speed * (held_[kFast] ? kFastFactor : 1), elapsed_s, shown.scene().level);
}

bool DemoControls::is_seeking() const {
  return seeks_begin_ || seeks_end_ || seek_offset_s_ != 0 || packet_steps_ < 0;
}

// After a seek the player's view is made first, so that a camera that is no longer in the level finds the
// player.
base::Result<bool> DemoControls::advance_with_camera(double elapsed_s, PresentationSettings& io_presentation,
                                                     const Presentation& shown, DemoSession& io_session) {
  if (!is_seeking() && shown.scene().level == camera_level_) {
    io_presentation.camera = camera_.camera();
    return advance_session(elapsed_s, io_presentation, io_session);
  }
  TRY(const bool continues, advance_session(elapsed_s, io_presentation, io_session));
  const world::Level* const level = shown.scene().level;
  if (level == nullptr) return continues;
  if (level != camera_level_ || !camera_.is_inside(*level)) camera_.place(shown.scene().camera);
  camera_level_ = level;
  io_presentation.camera = camera_.camera();
  TRY_STATUS(io_session.show(io_presentation));
  return continues;
}

base::Result<bool> DemoControls::advance_session(double elapsed_s, const PresentationSettings& presentation,
                                                 DemoSession& io_session) {
  std::optional<double> target_s;
  if (seeks_begin_) target_s = io_session.begin_s();
  if (seeks_end_) target_s = io_session.end_s();
  if (seek_offset_s_ != 0) target_s = target_s.value_or(io_session.time_s()) + seek_offset_s_;
  if (packet_steps_ != 0) {
    io_session.pause(true);
    return io_session.step(packet_steps_, presentation);
  }
  // Seeking past the end shows the end.
  if (target_s) return io_session.seek(std::min(*target_s, io_session.end_s()), presentation);
  return io_session.advance(elapsed_s, presentation);
}

base::Result<bool> DemoControls::advance(double elapsed_s, PresentationSettings presentation,
                                         const Settings& settings, const Presentation& shown,
                                         DemoSession& io_session) {
  idle_s_ += elapsed_s;
  if (toggles_pause_) io_session.pause(!io_session.is_paused());
  if (speed_steps_ != 0 || resets_speed_) change_speed(io_session);
  if (flies_) fly(elapsed_s, settings, shown);
  const double passed_s = elapsed_s * settings.time_scale;
  base::Result<bool> result = flies_ && has_camera_
                                  ? advance_with_camera(passed_s, presentation, shown, io_session)
                                  : advance_session(passed_s, presentation, io_session);
  toggles_pause_ = seeks_begin_ = seeks_end_ = resets_speed_ = false;
  speed_steps_ = packet_steps_ = 0;
  seek_offset_s_ = 0;
  return result;
}

}  // namespace temblor::client
