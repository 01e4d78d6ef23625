// How the player's eyes move within the body: what walking, strafing, stairs, kicks and idleness do to them.
// All of it is a function of time, or exact for any steps of time.
#pragma once

#include <limits>

#include "math/vec.h"
#include "net/protocol/server_message.h"

namespace temblor::client {

// Up and down while walking, -7 to 4 units.
float bob_units(double time_s, const math::Vec3& velocity);

// The head leans 2 degrees towards where it is carried sideways, at 200 units a second and above.
float strafe_roll_deg(const math::Vec3& velocity, const math::Vec3& right);

// Pitch, yaw and roll of a view that nobody holds.
math::Vec3 idle_sway_deg(double time_s);

// A floor that lifts the player by a step lifts the eyes at 80 units a second, at most 12 units behind.
class StairSmoothing {
 public:
  // For the time since the last call. Returns how far the eyes are behind, 0 or below.
  float advance(float floor_z, bool on_ground, double passed_s);
  void follow(float floor_z) { eyes_z_ = floor_z; }

 private:
  float eyes_z_ = 0;
};

// A blow throws the head away from where it came from, for half a second.
class DamageKick {
 public:
  void take(const net::Damage& damage, const math::Vec3& body_world, float body_yaw_deg, double time_s);
  // Pitch, 0, roll.
  math::Vec3 angles_deg(double time_s) const;

 private:
  math::Vec3 whole_deg_{0.0f};
  double since_s_ = -std::numeric_limits<double>::infinity();
};

// Follows values that come by messages, in even steps from one to the next instead of jumps. The time for a
// step is that between the last two changes, at most 0.1 s.
class EasedVector {
 public:
  void advance(const math::Vec3& target, double time_s);
  void jump(const math::Vec3& target, double time_s);
  math::Vec3 value(double time_s) const;

 private:
  math::Vec3 from_{0.0f}, to_{0.0f};
  double changed_s_ = 0, step_s_ = 0;
};

}  // namespace temblor::client
