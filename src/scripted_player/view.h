// Where a player looks: turns as a hand does, with a bounded rate and without jerks.
#pragma once

#include "math/vec.h"

namespace temblor::player {

class View {
 public:
  // As the server has turned him.
  void set(const math::Vec3& angles_deg);
  // Turns towards those angles for that long; `haste` 1 for a walk, 2 in a fight.
  void turn(const math::Vec3& wanted_deg, float haste, float seconds);
  const math::Vec3& angles_deg() const { return angles_deg_; }

 private:
  math::Vec3 angles_deg_{0.0f};
  math::Vec3 rate_{0.0f};    // degrees/s
  math::Vec3 wanted_{0.0f};  // at the last turn
};

}  // namespace temblor::player
