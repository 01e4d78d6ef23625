#include "movement/walk.h"

#include <array>
#include <cmath>

namespace temblor::movement {
namespace {

constexpr float kUnmoved = 1.0f / 32;  // a body that gets less far along both axes has not moved
constexpr float kUnstickTime_s = 0.1f;
constexpr float kUnstuckDistance = 4;

// A player who looks straight at a wall is slowed down along it. The slowdown starts where view and wall
// normal are 120 degrees apart (a cosine of -0.5), and reaches half of the speed where they are opposite.
void slow_along_wall(const math::Vec3& normal, const math::Vec3& view_forward, Body& io_body) {
  const float facing = glm::dot(normal, view_forward) + 0.5f;
  if (facing >= 0) return;
  const math::Vec3 along = io_body.velocity - normal * glm::dot(normal, io_body.velocity);
  io_body.velocity.x = along.x * (1 + facing);
  io_body.velocity.y = along.y * (1 + facing);
}

// Along x or y only: a body that merely rose or fell has not got anywhere.
bool is_farther(const math::Vec3& a, const math::Vec3& b, float distance) {
  return std::abs(a.x - b.x) > distance || std::abs(a.y - b.y) > distance;
}

// Rounding can leave a climbing body stuck on something. Nudges it by two units in each of eight directions,
// and takes the first from which it gets on. If there is none, the body stops.
base::Result<Slide> try_sideways(const math::Vec3& velocity, Body& io_body, Environment& io_environment) {
  constexpr std::array<math::Vec3, 8> kWays = {
      {{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {2, -2, 0}, {-2, -2, 0}}};
  const math::Vec3 origin = io_body.origin;
  for (const math::Vec3& way : kWays) {
    TRY(const Push aside, push(io_body, way, io_environment));
    if (aside.is_gone) return Slide{.is_gone = true};
    io_body.velocity = {velocity.x, velocity.y, 0};
    TRY(const Slide across, slide(io_body, kUnstickTime_s, io_environment));
    if (across.is_gone || is_farther(io_body.origin, origin, kUnstuckDistance)) return across;
    io_body.origin = origin;
  }
  io_body.velocity = math::Vec3(0.0f);
  return Slide{.met_floor = true, .met_wall = true};
}

struct Climb {
  bool reached_floor = false, is_gone = false;
};
// Moves up, along, and down again, from the body's current place and with its current velocity. The way down
// also includes the vertical way of that velocity, so that a body that falls still falls.
base::Result<Climb> climb(float duration_s, const math::Vec3& view_forward, Body& io_body,
                          Environment& io_environment) {
  constexpr Climb kGone{.is_gone = true};
  const math::Vec3 origin = io_body.origin, velocity = io_body.velocity;
  TRY(const Push up, push(io_body, {0, 0, kStepHeight}, io_environment));
  if (up.is_gone) return kGone;
  io_body.velocity = {velocity.x, velocity.y, 0};
  TRY(Slide across, slide(io_body, duration_s, io_environment));
  if (!across.is_gone && (across.met_floor || across.met_wall) &&
      !is_farther(io_body.origin, origin, kUnmoved)) {
    TRY(across, try_sideways(velocity, io_body, io_environment));
  }
  if (across.is_gone) return kGone;
  if (across.wall) slow_along_wall(across.wall->plane_normal, view_forward, io_body);
  TRY(const Push down, push(io_body, {0, 0, -kStepHeight + velocity.z * duration_s}, io_environment));
  return Climb{down.contact.trace.plane_normal.z > kFloorNormal, down.is_gone};
}

}  // namespace

base::Result<bool> walk(Body& io_body, float duration_s, const math::Vec3& view_forward,
                        WalkEnvironment& io_environment) {
  const bool was_on_ground = io_body.on_ground;
  const math::Vec3 origin = io_body.origin, velocity = io_body.velocity;
  io_body.on_ground = false;
  TRY(const Slide plain, slide(io_body, duration_s, io_environment));
  if (plain.is_gone) return false;
  if (!plain.met_wall || !io_environment.may_climb(was_on_ground)) return true;

  const math::Vec3 plain_origin = io_body.origin, plain_velocity = io_body.velocity;
  io_body.origin = origin;
  io_body.velocity = velocity;
  TRY(const Climb climbed, climb(duration_s, view_forward, io_body, io_environment));
  if (!climbed.is_gone && !climbed.reached_floor) {
    io_body.origin = plain_origin;
    io_body.velocity = plain_velocity;
  }
  return !climbed.is_gone;
}

}  // namespace temblor::movement
