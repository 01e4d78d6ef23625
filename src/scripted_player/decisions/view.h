// The view direction of a player. Turns smoothly and at a limited rate, as a hand with a mouse does, so that
// demos look natural.
//
// Method: a critically damped spring pulls the view to the wanted angles, with its speed limited.
#pragma once

#include "math/vec.h"

namespace temblor::player {

class View {
 public:
  // Sets the view that the server has forced, for example after a teleport.
  void set(const math::Vec3& angles_deg);
  // Turns toward those angles for that long. `haste` scales speed and stiffness: 1 for a walk, about 2 in a
  // fight.
  void turn(const math::Vec3& wanted_deg, float haste, float seconds);
  const math::Vec3& angles_deg() const { return angles_deg_; }

 private:
  math::Vec3 angles_deg_{0.0f};
  // Degrees per second.
  math::Vec3 rate_{0.0f};
  // The wanted angles of the last turn, to measure how fast the target moves.
  math::Vec3 wanted_{0.0f};
};

}  // namespace temblor::player
