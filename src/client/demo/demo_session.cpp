// Seeking goes back to a place of the index, plays on quickly, without anything but the state, to some
// seconds before the moment that is wanted, and lives through these: by then, everything that fades and all
// particles from before have gone.
#include "client/demo/demo_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace temblor::client {

namespace {

// Particles of explosions live longest, for 5 seconds.
constexpr double kLeadIn_s = 6;

}  // namespace

base::Result<DemoSession> DemoSession::open(base::ByteVector bytes, std::string name,
                                            Presentation& io_presentation) {
  TRY(DemoPlayer opened, DemoPlayer::open(std::move(bytes), std::move(name)));
  auto player = std::make_unique<DemoPlayer>(std::move(opened));
  TRY(DemoIndex index, DemoIndex::make(*player));
  DemoSession session(std::move(player), std::move(index), io_presentation);
  session.time_s_ = session.begin_s();
  return session;
}

void DemoSession::set_speed(double speed) {
  speed_ = speed > kSlowest ? std::min(speed, kFastest) : kSlowest;
}

base::Result<bool> DemoSession::advance(double passed_s, const PresentationSettings& settings) {
  if (!has_begun_) return seek(begin_s(), settings);
  if (paused_ || has_ended_ || !(passed_s > 0)) {
    TRY_STATUS(present(settings));
    return !has_ended_;
  }
  return go_on_to(time_s_ + passed_s * speed_, settings);
}

base::Result<bool> DemoSession::seek(double time_s, const PresentationSettings& settings) {
  if (!(time_s > begin_s())) time_s = begin_s();
  seeks_ = true;
  const base::Status near = go_before(std::min(time_s, end_s()), settings);
  base::Result<bool> there = near.ok() ? go_on_to(time_s, settings) : base::Result<bool>(near.error());
  seeks_ = false;
  hear_level();
  return there;
}

// Packets of one time are one.
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
  return go_on_to(wanted < times_s.size() ? times_s[wanted] : end_s() + kPastTheEnd_s, settings);
}

base::Status DemoSession::go_before(double time_s, const PresentationSettings& settings) {
  const DemoIndex::Entry& from =
      settings.effects.marks ? index_.level_before(time_s) : index_.entry_before(time_s, kLeadIn_s);
  player_->return_to(from.place);
  EffectCounts effects = from.effects;
  static_sounds_ = from.static_sounds;
  has_begun_ = true;
  has_ended_ = false;
  time_s_ = from.time_s;
  const double lead_in_s = settings.effects.marks ? from.time_s : time_s - kLeadIn_s;
  while (player_->packet_time_s() < lead_in_s) {
    Events& events = player_->state().events();
    Effects::count(events, effects);
    collect_static_sounds(events, static_sounds_);
    events.clear();
    TRY(const bool goes_on, player_->read_packet());
    if (!goes_on) break;
  }
  // The level is named anew where the listener is told of it; here its sounds would be taken for further
  // ones.
  if (player_->state().events().new_level) static_sounds_.clear();
  return presentation_->resume(player_->state(), effects, settings);
}

// Behind the end, what the recording still says there is read, and its damage told.
base::Result<bool> DemoSession::go_on_to(double time_s, const PresentationSettings& settings) {
  base::Result<bool> lived = live_through(time_s, settings);
  time_s_ = std::min(time_s, end_s());
  has_ended_ = !lived.ok() || !*lived;
  const bool is_damage = !lived.ok() && length().damage && time_s > end_s();
  if (!is_damage) {
    if (lived.ok()) TRY_STATUS(present(settings));
    return lived;
  }
  TRY_STATUS(present(settings));
  if (std::exchange(damage_told_, true)) return false;
  return lived;
}

// Every packet on the way from its beginning to its end, however long the way is.
base::Result<bool> DemoSession::live_through(double time_s, const PresentationSettings& settings) {
  while (player_->packet_time_s() < time_s) {
    TRY_STATUS(player_->advance_to(player_->packet_time_s()));
    TRY_STATUS(pass(settings));
    TRY(const bool goes_on, player_->begin_packet());
    if (!goes_on) break;
    TRY_STATUS(pass(settings));
  }
  return player_->advance_to(time_s);
}

base::Status DemoSession::pass(const PresentationSettings& settings) {
  hear();
  return presentation_->pass(player_->state(), player_->server_time_s(), view_angles_deg(settings), settings);
}

base::Status DemoSession::present(const PresentationSettings& settings) {
  hear();
  return presentation_->advance(player_->state(), player_->server_time_s(), view_angles_deg(settings),
                                settings);
}

void DemoSession::hear() {
  const Events& events = player_->state().events();
  collect_static_sounds(events, static_sounds_);
  if (listener_ != nullptr && !seeks_) listener_(events, player_->state().game(), player_->server_time_s());
}

void DemoSession::hear_level() {
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
