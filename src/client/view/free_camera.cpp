#include "client/view/free_camera.h"

#include <algorithm>
#include <cmath>

#include "math/angles.h"
#include "world/trace.h"

namespace temblor::client {

namespace {

// Well beyond any level, and small enough that floats stay precise.
constexpr float kMaxCoordinate = 1 << 16;
// The distance from walls: nearer ones would be cut off by the edge of the view.
constexpr float kFromWall_units = 8;

// Moves along `motion`, up to kFromWall_units before a wall, and then on along the wall. Each wall of a
// corner takes one more step.
math::Vec3 slide(const world::Level& level, math::Vec3 place, math::Vec3 motion) {
  constexpr int kMaxSteps = 4;
  constexpr float kMinSteepness = 0.2f;  // of the motion against the wall, for the look ahead
  constexpr float kLookAhead_units = kFromWall_units / kMinSteepness;
  for (int step = 0; step < kMaxSteps; ++step) {
    const float length = glm::length(motion);
    if (length <= 0) break;
    const math::Vec3 way = motion / length;
    const world::Trace trace = world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint, place,
                                                 place + way * (length + kLookAhead_units));
    if (trace.fraction == 1) return place + motion;
    const float steepness = std::max(-glm::dot(way, trace.plane_normal), kMinSteepness);
    const float room = glm::distance(place, trace.end) - kFromWall_units / steepness;
    if (room >= length) return place + motion;
    const float moved = std::max(room, 0.0f);
    place += way * moved;
    motion -= way * moved;
    motion -= trace.plane_normal * std::min(glm::dot(motion, trace.plane_normal), 0.0f);
  }
  return place;
}

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

bool FreeCamera::is_inside(const world::Level& level) const {
  return world::hull_contents(level, world::ModelIndex{0}, world::Hull::kPoint, camera_.origin_world) !=
         world::Contents::kSolid;
}

void FreeCamera::fly(const Directions& directions, float speed, double seconds, const world::Level* level) {
  const math::Basis look = math::basis_from_angles(camera_.angles_deg);
  math::Vec3d motion = look.forward * double{directions.forward} + look.right * double{directions.right};
  motion.z += double{directions.up};
  // Diagonal flight is not faster.
  const double length = std::max(1.0, glm::length(motion));
  const math::Vec3 wanted(motion / length * (double{speed} * seconds));
  const math::Vec3 moved = level != nullptr && is_inside(*level) ? slide(*level, camera_.origin_world, wanted)
                                                                 : camera_.origin_world + wanted;
  camera_.origin_world = glm::clamp(moved, math::Vec3(-kMaxCoordinate), math::Vec3(kMaxCoordinate));
}

}  // namespace temblor::client
