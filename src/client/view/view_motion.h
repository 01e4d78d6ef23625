// Motion of the eyes within the body, from walking, strafing, stairs, damage and idling. The amounts are
// stock Quake's. Each is a function of time, or exact for any division of time into steps, so the frame rate
// does not change it.
#pragma once

#include <limits>

#include "math/vec.h"
#include "net/protocol/server_message.h"

namespace temblor::client {

// The vertical bob of walking, -7 to 4 units. `velocity`: units per second; only its horizontal part counts.
// It rises for a share `up` of each cycle, 0 to 1. A cycle of 0 s: none.
float compute_bob(double time_s, const math::Vec3& velocity, double cycle_s = 0.6, double up = 0.5);

// The roll of moving sideways: 2 degrees at 200 units per second and above, in proportion below. `right`: the
// unit vector to the view's right.
float compute_strafe_roll_deg(const math::Vec3& velocity, const math::Vec3& right);

// The sway of a view that nobody controls: pitch, yaw, roll.
math::Vec3 compute_idle_sway_deg(double time_s);

// Smooths steps: the eyes rise at 80 units per second and lag behind the floor by at most 12 units.
class StairSmoothing {
 public:
  // Advances by the time since the last call. Returns the eyes' height relative to the floor, 0 or negative.
  float advance(float floor_z, bool on_ground, double elapsed_s);
  // Puts the eyes at the floor at once, for teleports.
  void reset(float floor_z) { eyes_z_ = floor_z; }

 private:
  float eyes_z_ = 0;
};

// Damage throws the head away from the attacker for half a second.
class DamageKick {
 public:
  void add(const net::Damage& damage, const math::Vec3& body_world, float body_yaw_deg, double time_s);
  // The kick at a time: pitch, 0, roll. It fades linearly over `duration_s`.
  math::Vec3 angles_deg(double time_s, double duration_s) const;

 private:
  // The full kick, and when it began.
  math::Vec3 kick_deg_{0.0f};
  double since_s_ = -std::numeric_limits<double>::infinity();
};

// Turns values that change with each packet into even motion. A change takes as long as the time between the
// last two changes, at most 0.1 s.
class EasedVector {
 public:
  // Starts to move to a new target; does nothing for the same one.
  void advance(const math::Vec3& target, double time_s);
  // Changes the value at once.
  void jump(const math::Vec3& target, double time_s);
  math::Vec3 value(double time_s) const;

 private:
  math::Vec3 from_{0.0f}, to_{0.0f};
  double changed_s_ = 0, step_s_ = 0;
};

}  // namespace temblor::client
