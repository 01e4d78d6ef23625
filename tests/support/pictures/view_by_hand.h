// A view without a level, for tests of single objects in space.
#pragma once

#include "math/angles.h"
#include "render/view/view_frame.h"

namespace temblor::test {

// A perspective view with the focal length of docs/architecture.md, section 1. Fields that depend on a level
// are empty.
render::ViewFrame make_test_view(int width, int height, double fov_deg, const math::Vec3& angles_deg,
                                 const math::Vec3d& eye_world);

}  // namespace temblor::test
