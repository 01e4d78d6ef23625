// Built-in functions for directions and lengths.
#include <cmath>
#include <numbers>

#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// The yaw of (x, y): counterclockwise from +x, in whole degrees from 0 to 359. It is cut toward 0, so that an
// angle just below 360 gives 359, and one just below 0 gives 0.
float whole_degrees(float x, float y) {
  const double degrees = std::atan2(double{y}, double{x}) * (180 / std::numbers::pi);
  const int whole = to_whole(static_cast<float>(std::trunc(degrees)));
  return static_cast<float>(whole < 0 ? whole + 360 : whole);
}

// normalize(vector): the zero vector stays as it is.
base::Status normalize(Call& io_call) {
  const math::Vec3 vector = io_call.vector(0);
  const float length = std::sqrt(glm::dot(vector, vector));
  io_call.machine.return_vector(length == 0 ? math::Vec3(0.0f) : vector * (1 / length));
  return base::Ok{};
}

base::Status vlen(Call& io_call) {
  const math::Vec3 vector = io_call.vector(0);
  io_call.machine.return_float(std::sqrt(glm::dot(vector, vector)));
  return base::Ok{};
}

// vectoyaw(vector): its direction in the horizontal plane.
base::Status vectoyaw(Call& io_call) {
  const math::Vec3 vector = io_call.vector(0);
  io_call.machine.return_float(whole_degrees(vector.x, vector.y));
  return base::Ok{};
}

// vectoangles(vector): pitch is positive upward here, as in the angles of models. Angles of views are the
// reverse.
base::Status vectoangles(Call& io_call) {
  const math::Vec3 vector = io_call.vector(0);
  math::Vec3 angles(vector.z > 0 ? 90.0f : 270.0f, 0, 0);
  if (vector.x != 0 || vector.y != 0) {
    const float along = std::sqrt(vector.x * vector.x + vector.y * vector.y);
    angles = {whole_degrees(along, vector.z), whole_degrees(vector.x, vector.y), 0};
  }
  io_call.machine.return_vector(angles);
  return base::Ok{};
}

// randomvec(): a point within one unit of the origin, uniformly distributed (by rejection).
base::Status randomvec(Call& io_call) {
  math::Vec3 vector;
  do {
    for (int axis = 0; axis < 3; ++axis) vector[axis] = io_call.context.random() * 2 - 1;
  } while (glm::dot(vector, vector) > 1);
  io_call.machine.return_vector(vector);
  return base::Ok{};
}

}  // namespace

std::span<const Entry> vector_builtins() {
  static constexpr Entry kEntries[] = {
      {9, "normalize", normalize},      {12, "vlen", vlen},           {13, "vectoyaw", vectoyaw},
      {51, "vectoangles", vectoangles}, {91, "randomvec", randomvec},
  };
  return kEntries;
}

}  // namespace temblor::builtins
