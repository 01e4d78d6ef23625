#include "client/view/free_camera.h"

#include <algorithm>
#include <cmath>

#include "math/angles.h"

namespace temblor::client {

namespace {

// Well beyond any level, and small enough that floats stay precise.
constexpr float kMaxCoordinate = 1 << 16;

}  // namespace

void FreeCamera::place(const render::Camera& camera) {
  camera_ = camera;
  camera_.angles_deg.z = 0;
  turn(0, 0);
}

// remainder() keeps the yaw small, so that a float's precision does not suffer.
void FreeCamera::turn(float pitch_deg, float yaw_deg) {
  math::Vec3& angles_deg = camera_.angles_deg;
  angles_deg.x = std::clamp(std::remainder(angles_deg.x, 360.0f) + pitch_deg, -90.0f, 90.0f);
  angles_deg.y = std::remainder(angles_deg.y + yaw_deg, 360.0f);
}

void FreeCamera::fly(const Directions& directions, float speed, double seconds) {
  const math::Basis look = math::basis_from_angles(camera_.angles_deg);
  math::Vec3d motion = look.forward * double{directions.forward} + look.right * double{directions.right};
  motion.z += double{directions.up};
  // Diagonal flight is not faster.
  const double length = std::max(1.0, glm::length(motion));
  const auto moved = camera_.origin_world + math::Vec3(motion / length * (double{speed} * seconds));
  camera_.origin_world = glm::clamp(moved, math::Vec3(-kMaxCoordinate), math::Vec3(kMaxCoordinate));
}

}  // namespace temblor::client
