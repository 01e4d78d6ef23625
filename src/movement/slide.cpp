#include "movement/slide.h"

#include <array>
#include <cmath>
#include <span>

namespace temblor::movement {
namespace {

constexpr int kBumps = 4;  // obstacles in one slide
constexpr std::size_t kMaxPlanes = 5;
constexpr float kStopSpeed = 0.1f;  // slower components become 0

// Classifies a contact by its plane's normal: floor, wall, or a slope in between, which is neither. A body is
// on the ground only on brush models: the head of a monster does not count.
void note_contact(const Contact& contact, Body& io_body, Slide& io_slide) {
  const float up = contact.trace.plane_normal.z;
  if (up > kFloorNormal) {
    io_slide.met_floor = true;
    if (contact.can_stand_on) {
      io_body.on_ground = true;
      io_body.ground = contact.obstacle;
    }
  }
  if (up == 0) {
    io_slide.met_wall = true;
    io_slide.wall = contact.trace;
  }
}

// The velocity clipped to one of the planes such that it goes into none of the others. Empty: there is no
// such plane, and the body is in a crease or a corner.
std::optional<math::Vec3> clip_along_one(const math::Vec3& velocity, std::span<const math::Vec3> normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const math::Vec3 clipped = clip_velocity(velocity, normals[i], 1);
    bool is_free = true;
    for (std::size_t j = 0; j < normals.size() && is_free; ++j)
      is_free = j == i || !(glm::dot(clipped, normals[j]) < 0);
    if (is_free) return clipped;
  }
  return std::nullopt;
}

}  // namespace

math::Vec3 clip_velocity(const math::Vec3& velocity, const math::Vec3& normal, float bounce) {
  math::Vec3 clipped = velocity - normal * (glm::dot(velocity, normal) * bounce);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(clipped[axis]) < kStopSpeed) clipped[axis] = 0;
  return clipped;
}

// Invariant: `normals` are the planes met at the body's current place, and `velocity` is what it had when it
// got there. Each clip starts from that velocity, so that the order of contacts at one place does not matter
// as long as one plane suffices.
base::Result<Slide> slide(Body& io_body, float duration_s, Environment& io_environment) {
  Slide result;
  const math::Vec3 first_velocity = io_body.velocity;
  math::Vec3 velocity = io_body.velocity;  // before the planes at this place clipped it
  std::array<math::Vec3, kMaxPlanes> normals;
  std::size_t planes = 0;
  float time_left_s = duration_s;
  const auto stop_dead = [&] {
    io_body.velocity = math::Vec3(0.0f);
    result.met_floor = result.met_wall = true;
    return result;
  };
  for (int bump = 0; bump < kBumps && io_body.velocity != math::Vec3(0.0f); ++bump) {
    const Contact contact =
        io_environment.trace(io_body.origin, io_body.origin + io_body.velocity * time_left_s);
    if (contact.trace.all_solid) return stop_dead();
    if (contact.trace.fraction > 0) {
      io_body.origin = contact.trace.end;
      velocity = io_body.velocity;
      planes = 0;
    }
    if (contact.trace.fraction == 1) break;
    note_contact(contact, io_body, result);
    TRY(const bool is_there, io_environment.touch(contact, io_body));
    if (!is_there) {
      result.is_gone = true;
      break;
    }
    time_left_s -= time_left_s * contact.trace.fraction;

    if (planes == kMaxPlanes) return stop_dead();
    normals[planes++] = contact.trace.plane_normal;
    if (const auto clipped = clip_along_one(velocity, std::span(normals).first(planes))) {
      io_body.velocity = *clipped;
    } else {
      if (planes != 2) return stop_dead();
      const math::Vec3 crease = glm::cross(normals[0], normals[1]);
      io_body.velocity = crease * glm::dot(crease, io_body.velocity);
    }
    // A corner has turned the body back. It would jitter there.
    if (glm::dot(io_body.velocity, first_velocity) <= 0) {
      io_body.velocity = math::Vec3(0.0f);
      break;
    }
  }
  return result;
}

base::Result<Push> push(Body& io_body, const math::Vec3& way, Environment& io_environment) {
  Push result{io_environment.trace_push(io_body.origin, io_body.origin + way)};
  io_body.origin = result.contact.trace.end;
  TRY(bool is_there, io_environment.moved(io_body));
  if (is_there && result.contact.hit) {
    TRY(is_there, io_environment.touch(result.contact, io_body));
  }
  result.is_gone = !is_there;
  return result;
}

}  // namespace temblor::movement
