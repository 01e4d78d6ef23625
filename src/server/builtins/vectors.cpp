// The built-in function that turns angles into the directions v_forward, v_right, and v_up, which every
// program of the server has at the same place.
#include "math/angles.h"
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

base::Status makevectors(Call& io_call) {
  const math::Basis basis = math::basis_from_angles(io_call.vector(0));
  io_call.machine.set_global_vector(global::kForward, math::Vec3(basis.forward));
  io_call.machine.set_global_vector(global::kRight, math::Vec3(basis.right));
  io_call.machine.set_global_vector(global::kUp, math::Vec3(basis.up));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> vector_builtins() {
  static constexpr BuiltinEntry kEntries[] = {{1, "makevectors", makevectors}};
  return kEntries;
}

}  // namespace temblor::server
