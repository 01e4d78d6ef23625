// Moves a walking body over a floor with steps.
//
// The body first slides (slide.h). If a wall stops it, it tries the same way from 18 units higher, and is
// then put down again:
//
//      up  +-->  across
//      |          |  down        The result counts only if it ends on a floor. Else the plain slide counts.
//   ---+   ####___v___
#pragma once

#include "movement/slide.h"

namespace temblor::movement {

// Units that a walking body climbs in one tick.
constexpr float kStepHeight = 18;

class WalkEnvironment : public Environment {
 public:
  // Whether the body, which has just slid into a wall, may try to climb it.
  virtual bool may_climb(bool was_on_ground) = 0;
};

// `view_forward` is a unit vector: a player who looks straight at a wall is slowed down along it. Climbing
// does not set on_ground; the slide before it did. false: something that the body touched removed it. Fails
// if a touch does.
base::Result<bool> walk(Body& io_body, float duration_s, const math::Vec3& view_forward,
                        WalkEnvironment& io_environment);

}  // namespace temblor::movement
