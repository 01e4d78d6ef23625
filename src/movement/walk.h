// A player's way over a floor with stairs.
#pragma once

#include "movement/slide.h"

namespace temblor::movement {

class WalkEnvironment : public Environment {
 public:
  // Asked when the body has slid against a wall: whether it may try to climb over it.
  virtual bool may_climb(bool was_on_ground) = 0;
};

// Slides; where that met a wall, tries the same 18 units higher and comes down again (and by what it falls),
// and keeps that way if it ends on a floor. A step does not set on_ground by itself; the slide before it did.
// `view_forward` is a unit vector: who looks straight at a wall is slowed down along it. false: the body was
// removed by what it touched.
base::Result<bool> walk(Body& io_body, float duration_s, const math::Vec3& view_forward,
                        WalkEnvironment& io_environment);

}  // namespace temblor::movement
