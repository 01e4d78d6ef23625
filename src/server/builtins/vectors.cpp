// Built-in functions that set the directions v_forward, v_right, and v_up, which every program of the server
// has at the same place.
#include <cmath>

#include "math/angles.h"
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

base::Status set_directions(Call& io_call, const math::Vec3& forward, const math::Vec3& right,
                            const math::Vec3& up) {
  io_call.machine.set_global_vector(global::kForward, forward);
  io_call.machine.set_global_vector(global::kRight, right);
  io_call.machine.set_global_vector(global::kUp, up);
  return base::Ok{};
}

// makevectors(angles)
base::Status makevectors(Call& io_call) {
  const math::Basis basis = math::basis_from_angles(io_call.vector(0));
  return set_directions(io_call, math::Vec3(basis.forward), math::Vec3(basis.right), math::Vec3(basis.up));
}

// vectorvectors(direction): the direction becomes v_forward; v_right is horizontal.
base::Status vectorvectors(Call& io_call) {
  const math::Vec3 direction = io_call.vector(0);
  const float length = glm::length(direction);
  if (!(length > 0)) return set_directions(io_call, math::Vec3(0.0f), math::Vec3(0.0f), math::Vec3(0.0f));
  const math::Vec3 forward = direction / length;
  const float level = std::sqrt(forward.x * forward.x + forward.y * forward.y);
  const math::Vec3 right = level > 0 ? math::Vec3(forward.y, -forward.x, 0) / level : math::Vec3(0, -1, 0);
  return set_directions(io_call, forward, right, glm::cross(right, forward));
}

}  // namespace

std::span<const BuiltinEntry> vector_builtins() {
  static constexpr BuiltinEntry kEntries[] = {{1, "makevectors", makevectors},
                                              {432, "vectorvectors", vectorvectors}};
  return kEntries;
}

}  // namespace temblor::server
