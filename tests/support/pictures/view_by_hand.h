// A view without a level, for what is placed in space alone.
#pragma once

#include "math/angles.h"
#include "render/view/view_frame.h"

namespace temblor::test {

// In perspective, with the focal length of docs/architecture.md, section 1. What a level and a tree give is
// left out.
render::ViewFrame view_of(int width, int height, double fov_deg, const math::Vec3& angles_deg,
                          const math::Vec3d& eye_world);

}  // namespace temblor::test
