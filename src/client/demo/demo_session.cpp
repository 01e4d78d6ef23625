// Seeking restores an entry of the index, plays on quickly with only the client state up to a few seconds
// before the target, and replays those seconds with effects but unseen. By then everything that fades, and
// all particles from before, have gone.
#include "client/demo/demo_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace temblor::client {

namespace {

// Explosion particles live longest: 5 seconds. Tints, kicks and dynamic lights are shorter.
constexpr double kLeadIn_s = 6;

}  // namespace

base::Result<DemoSession> DemoSession::open(base::ByteVector bytes, std::string name,
                                            Presentation& io_presentation,
                                            std::shared_ptr<const formats::Localization> texts) {
  TRY(DemoPlayer opened, DemoPlayer::open(std::move(bytes), std::move(name)));
  auto player = std::make_unique<DemoPlayer>(std::move(opened));
  player->state().set_texts(std::move(texts));
  TRY(DemoIndex index, DemoIndex::make(*player));
  DemoSession session(std::move(player), std::move(index), io_presentation);
  session.time_s_ = session.begin_s();
  return session;
}

void DemoSession::set_speed(double speed) {
  speed_ = speed > kMinSpeed ? std::min(speed, kMaxSpeed) : kMinSpeed;
}

base::Result<bool> DemoSession::advance(double elapsed_s, const PresentationSettings& settings) {
  if (!has_begun_) return seek(begin_s(), settings);
  if (paused_ || has_ended_ || !(elapsed_s > 0)) {
    TRY_STATUS(present(settings));
    return !has_ended_;
  }
  return play_to(time_s_ + elapsed_s * speed_, settings);
}

base::Result<bool> DemoSession::seek(double time_s, const PresentationSettings& settings) {
  if (!(time_s > begin_s())) time_s = begin_s();
  seeks_ = true;
  const base::Status near = restore_before(std::min(time_s, end_s()), settings);
  base::Result<bool> result = near.ok() ? play_to(time_s, settings) : base::Result<bool>(near.error());
  seeks_ = false;
  notify_level_start();
  return result;
}

// Packets with the same time count as one. A step back is a seek; a step forward plays on, so that effects
// continue.
base::Result<bool> DemoSession::step(int packets, const PresentationSettings& settings) {
  if (!has_begun_) return seek(begin_s(), settings);
  const std::vector<double>& times_s = index_.packet_times_s();
  if (packets <= 0) {
    const auto here = std::lower_bound(times_s.begin(), times_s.end(), time_s_) - times_s.begin();
    const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(times_s.size()) - 1;
    const std::ptrdiff_t wanted = std::clamp<std::ptrdiff_t>(here + packets, 0, last);
    return seek(times_s[static_cast<std::size_t>(wanted)], settings);
  }
  const auto next = std::upper_bound(times_s.begin(), times_s.end(), time_s_) - times_s.begin();
  const auto wanted = static_cast<std::size_t>(next + packets - 1);
  constexpr double kPastTheEnd_s = 1;
  return play_to(wanted < times_s.size() ? times_s[wanted] : end_s() + kPastTheEnd_s, settings);
}

// With marks, the whole level must be replayed with effects, as they stay until the level ends.
base::Status DemoSession::restore_before(double time_s, const PresentationSettings& settings) {
  const bool has_marks = settings.effects.marks || index_.has_marks_before(time_s);
  const DemoIndex::Entry& from =
      has_marks ? index_.find_level_start(time_s) : index_.find_entry_before(time_s, kLeadIn_s);
  player_->restore(from.place);
  EffectCounts effects = from.effects;
  static_sounds_ = from.static_sounds;
  has_begun_ = true;
  has_ended_ = false;
  time_s_ = from.time_s;
  const double lead_in_s = has_marks ? from.time_s : time_s - kLeadIn_s;
  while (player_->packet_time_s() < lead_in_s) {
    Events& events = player_->state().events();
    Effects::count(events, effects);
    append_static_sounds(events, static_sounds_);
    events.clear();
    TRY(const bool goes_on, player_->read_packet());
    if (!goes_on) break;
  }
  // notify_level_start() reports static sounds itself; here they would be reported twice.
  if (player_->state().events().new_level) static_sounds_.clear();
  return presentation_->resume(player_->state(), effects, settings);
}

// Past the end, the rest of the demo is read so that damage is reported.
base::Result<bool> DemoSession::play_to(double time_s, const PresentationSettings& settings) {
  base::Result<bool> played = replay_unseen(time_s, settings);
  time_s_ = std::min(time_s, end_s());
  has_ended_ = !played.ok() || !*played;
  const bool is_damage = !played.ok() && length().damage && time_s > end_s();
  if (!is_damage) {
    if (played.ok()) TRY_STATUS(present(settings));
    return played;
  }
  TRY_STATUS(present(settings));
  if (std::exchange(damage_reported_, true)) return false;
  return played;
}

// Replays every packet of the interval, however long it is.
base::Result<bool> DemoSession::replay_unseen(double time_s, const PresentationSettings& settings) {
  while (player_->packet_time_s() < time_s) {
    TRY_STATUS(player_->advance_to(player_->packet_time_s()));
    TRY_STATUS(advance_unseen(settings));
    TRY(const bool goes_on, player_->begin_packet());
    if (!goes_on) break;
    TRY_STATUS(advance_unseen(settings));
  }
  return player_->advance_to(time_s);
}

base::Status DemoSession::advance_unseen(const PresentationSettings& settings) {
  notify_listener();
  return presentation_->advance_unseen(player_->state(), player_->server_time_s(), view_angles_deg(settings),
                                       settings);
}

// Makes the scene of the current time.
base::Status DemoSession::present(const PresentationSettings& settings) {
  notify_listener();
  return presentation_->advance(player_->state(), player_->server_time_s(), view_angles_deg(settings),
                                settings);
}

void DemoSession::notify_listener() {
  const Events& events = player_->state().events();
  append_static_sounds(events, static_sounds_);
  if (listener_ != nullptr && !seeks_) listener_(events, player_->state().game(), player_->server_time_s());
}

// Presents the level to the listener as newly begun, with the static sounds so far.
void DemoSession::notify_level_start() {
  presentation_->audio_scene().resume(static_sounds_);
  if (listener_ == nullptr) return;
  Events level;
  level.new_level = true;
  level.static_sounds = static_sounds_;
  listener_(level, player_->state().game(), player_->server_time_s());
}

math::Vec3 DemoSession::view_angles_deg(const PresentationSettings& settings) const {
  return player_->view_angles_at(player_->server_time_s(),
                                 {.interpolate = settings.interpolate, .no_lerp_models = {}});
}

}  // namespace temblor::client
