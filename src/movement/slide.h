// A body that slides along whatever it meets. Knows neither entities nor programs: it asks an Environment how
// far it gets, and tells it what was met.
#pragma once

#include <cstdint>
#include <optional>

#include "base/result.h"
#include "math/vec.h"
#include "world/trace.h"

namespace temblor::movement {

struct Body {
  math::Vec3 origin{0.0f}, velocity{0.0f};  // units; units a second
  bool on_ground = false;
  std::uint32_t ground = 0;  // what it stands on, by the environment's numbers
};

struct Contact {
  world::Trace trace;
  std::uint32_t obstacle = 0;  // by the environment's numbers; where `hit`
  bool hit = false;            // something stopped it, or it began in something solid
  bool can_stand_on = false;   // a brush model
};

// What a body moves in. Where nothing is called when things meet (prediction), touch() and moved() do
// nothing.
class Environment {
 public:
  virtual ~Environment() = default;
  virtual Contact trace(const math::Vec3& start, const math::Vec3& end) = 0;
  // Like trace(), for a push(): what it meets may differ for some bodies (missiles).
  virtual Contact trace_push(const math::Vec3& start, const math::Vec3& end) = 0;
  // The body has met something, and: it was brought to another place. Either may change it. false: there is
  // no such body any more.
  virtual base::Result<bool> touch(const Contact& contact, Body& io_body) = 0;
  virtual base::Result<bool> moved(Body& io_body) = 0;
};

struct Slide {
  bool met_floor = false, met_wall = false;
  std::optional<world::Trace>
      wall{};            // the last upright one that it met; met_wall without: no way out at all
  bool is_gone = false;  // the body was removed by what it touched
};

// Moves for that long, along everything met on the way: four times at most, and never back against the
// velocity that it began with. Sets on_ground where it meets a floor to stand on.
base::Result<Slide> slide(Body& io_body, float duration_s, Environment& io_environment);

// Straight to another place, as far as it gets.
struct Push {
  Contact contact;
  bool is_gone = false;
};
base::Result<Push> push(Body& io_body, const math::Vec3& way, Environment& io_environment);

// What is left of a velocity on a plane: `bounce` 1 slides along it, 2 would come back as fast. What is
// slower than 0.1 along an axis stops.
math::Vec3 clip_velocity(const math::Vec3& velocity, const math::Vec3& normal, float bounce);

}  // namespace temblor::movement
