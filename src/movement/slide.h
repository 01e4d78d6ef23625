// Moves a body that slides along whatever it meets.
//
// The body knows neither entities nor game code. It asks an `Environment` how far it can get, and reports
// what it met: on a server that calls touch functions of QuakeC, in a client's prediction it does nothing.
// After each contact the velocity is clipped to the planes met so far at this place, as in the original game:
//
//   1 plane: slide along it      2 planes: along their crease      3 planes in a corner: stop
#pragma once

#include <cstdint>
#include <optional>

#include "base/result.h"
#include "math/vec.h"
#include "world/trace.h"

namespace temblor::movement {

// A surface is a floor if the z of its normal is greater than this.
constexpr float kFloorNormal = 0.7f;

struct Body {
  math::Vec3 origin{0.0f}, velocity{0.0f};  // units; units per second
  bool on_ground = false;
  std::uint32_t ground = 0;  // what it stands on, or stood on last, in the environment's numbers
};

struct Contact {
  world::Trace trace;
  std::uint32_t obstacle = 0;  // what was met, in the environment's numbers; valid if `hit`
  bool hit = false;            // something stopped the body, or it started in something solid
  bool can_stand_on = false;   // the obstacle is a brush model
};

// Everything that a body moves among.
class Environment {
 public:
  virtual ~Environment() = default;
  // How far the body's box gets from `start` to `end`.
  virtual Contact trace(const math::Vec3& start, const math::Vec3& end) = 0;
  // The same for push(). Missiles and bodies that nothing collides with meet other things there.
  virtual Contact trace_push(const math::Vec3& start, const math::Vec3& end) = 0;
  // The body has met something. The call may change the body. false: the body no longer exists.
  virtual base::Result<bool> touch(const Contact& contact, Body& io_body) = 0;
  // The body was moved to another place. Otherwise like touch().
  virtual base::Result<bool> moved(Body& io_body) = 0;
};

struct Slide {
  bool met_floor = false, met_wall = false;
  // The last vertical surface that was met. met_wall without it: the body was stuck.
  std::optional<world::Trace> wall{};
  bool is_gone = false;  // something that it touched removed the body
};

// Moves the body by its velocity for `duration_s`, along at most four obstacles. It never ends up moving
// against the velocity that it began with. Sets on_ground if it meets a floor that it can stand on. Fails if
// a touch does.
base::Result<Slide> slide(Body& io_body, float duration_s, Environment& io_environment);

struct Push {
  Contact contact;
  bool is_gone = false;  // something that it touched removed the body
};
// Moves the body in a straight line, as far as it gets. Fails if a touch does.
base::Result<Push> push(Body& io_body, const math::Vec3& way, Environment& io_environment);

// Takes the part of `velocity` that goes into a plane away, times `bounce`: 1 slides along the plane, 2
// reflects. Components below 0.1 become 0.
math::Vec3 clip_velocity(const math::Vec3& velocity, const math::Vec3& normal, float bounce);

}  // namespace temblor::movement
