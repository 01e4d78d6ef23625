#include "client/session/interpolation.h"

#include <algorithm>
#include <cmath>

namespace temblor::client {

namespace {

// The longest gap between packets that is interpolated, as in the original. After a longer one, motion starts
// late.
constexpr double kMaxUpdateGap_s = 0.1;
// Units.
constexpr float kTeleport_world = 100;

// Interpolates. Components that are equal stay exactly equal at any fraction.
math::Vec3 blend(const math::Vec3& from, const math::Vec3& to, double fraction) {
  return math::Vec3(math::Vec3d(from) + (math::Vec3d(to) - math::Vec3d(from)) * fraction);
}

}  // namespace

PacketWindow make_packet_window(double previous_time_s, double time_s) {
  return {std::max(previous_time_s, time_s - kMaxUpdateGap_s), time_s};
}

double compute_elapsed_fraction(double begin_s, double end_s, double time_s) {
  if (!(end_s > begin_s)) return 1;
  return std::clamp((time_s - begin_s) / (end_s - begin_s), 0.0, 1.0);
}

// std::remainder gives the shorter way, within half a turn.
math::Vec3 blend_angles_deg(const math::Vec3& from_deg, const math::Vec3& to_deg, double fraction) {
  if (fraction >= 1) return to_deg;
  math::Vec3 angles_deg;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = from_deg[axis];
    angles_deg[axis] = static_cast<float>(from + std::remainder(to_deg[axis] - from, 360.0) * fraction);
  }
  return angles_deg;
}

void Motion::put(const Place& place) {
  from_ = to_ = place;
  begin_s_ = end_s_ = 0;
}

// Starts where the entity is shown now, so motion is continuous even if the last one was not finished.
void Motion::fly_to(const Place& place, const PacketWindow& window) {
  from_ = at(window.begin_s);
  to_ = place;
  begin_s_ = window.begin_s;
  end_s_ = window.end_s;
}

void Motion::step_to(const Place& place, const PacketWindow& window, std::optional<float> step_s) {
  if (place == to_) return;
  const double since_last_s = window.begin_s - begin_s_;
  const bool steps_quickly = since_last_s > 0 && since_last_s < kThinkInterval_s;
  const double duration_s = step_s ? *step_s : steps_quickly ? since_last_s : kThinkInterval_s;
  // A step that interrupts another starts where that one has got to.
  from_ = at(window.begin_s);
  to_ = place;
  begin_s_ = window.begin_s;
  end_s_ = begin_s_ + duration_s;
}

Place Motion::at(double time_s) const {
  const double fraction = compute_elapsed_fraction(begin_s_, end_s_, time_s);
  if (fraction >= 1) return to_;
  return {blend(from_.origin_world, to_.origin_world, fraction),
          blend_angles_deg(from_.angles_deg, to_.angles_deg, fraction)};
}

// Any axis counts on its own, as in the original.
bool is_teleport(const math::Vec3& from_world, const math::Vec3& to_world) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(to_world[axis] - from_world[axis]) > kTeleport_world) return true;
  return false;
}

void FrameChanges::show(std::uint16_t frame) {
  from_ = to_ = frame;
  flash_shown_ = false;
}

void FrameChanges::update(std::uint16_t frame, double begin_s, double duration_s) {
  if (frame == to_) return;
  if (flash_shown_) return show(frame);
  from_ = to_;
  to_ = frame;
  begin_s_ = begin_s;
  end_s_ = begin_s + duration_s;
}

// Dropping the old frame shows the flash at once; show() ends it at once.
void FrameChanges::flash() {
  from_ = to_;
  flash_shown_ = true;
}

FrameBlend FrameChanges::at(double time_s) const {
  const double fraction = compute_elapsed_fraction(begin_s_, end_s_, time_s);
  if (from_ == to_ || fraction >= 1) return {to_, to_, 0};
  return {from_, to_, static_cast<float>(fraction)};
}

}  // namespace temblor::client
