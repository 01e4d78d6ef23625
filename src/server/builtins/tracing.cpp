// Built-in functions that trace lines and boxes, and look up what is at a point.
#include "server/builtins/families.h"
#include "server/move_trace.h"

namespace temblor::server {
namespace {

// Any other number means kNormal, as in the original, where programs pass TRUE and FALSE.
MoveKind move_kind(int number) {
  switch (number) {
    case 1:
      return MoveKind::kNoMonsters;
    case 2:
      return MoveKind::kMissile;
    default:
      return MoveKind::kNormal;
  }
}

// Stores the result in the trace_* globals, in which QuakeC looks for it.
void set_trace_globals(vm::Machine& io_machine, const EntityTrace& found) {
  const auto flag = [&](vm::GlobalIndex index, bool value) {
    io_machine.set_global_float(index, value ? 1 : 0);
  };
  const world::Trace& trace = found.trace;
  flag(global::kTraceAllSolid, trace.all_solid);
  flag(global::kTraceStartSolid, trace.start_solid);
  flag(global::kTraceInOpen, trace.in_open);
  flag(global::kTraceInWater, trace.in_water);
  io_machine.set_global_float(global::kTraceFraction, trace.fraction);
  io_machine.set_global_vector(global::kTraceEnd, trace.end);
  io_machine.set_global_vector(global::kTracePlaneNormal, trace.plane_normal);
  io_machine.set_global_float(global::kTracePlaneDistance, trace.plane_distance);
  io_machine.set_global_entity(global::kTraceEntity, found.hit ? found.entity : vm::kWorld);
}

// traceline(from, to, kind, passing): traces a point.
base::Status traceline(Call& io_call) {
  TRY(const vm::EntityIndex passing, io_call.entity(3));
  const math::Vec3 point(0.0f);
  set_trace_globals(io_call.machine, trace_move(io_call.world, io_call.vector(0), point, point,
                                                io_call.vector(1), move_kind(io_call.whole(2)), passing));
  return base::Ok{};
}

// tracebox(from, mins, maxs, to, kind, passing): traces a box.
base::Status tracebox(Call& io_call) {
  TRY(const vm::EntityIndex passing, io_call.entity(5));
  set_trace_globals(io_call.machine,
                    trace_move(io_call.world, io_call.vector(0), io_call.vector(1), io_call.vector(2),
                               io_call.vector(3), move_kind(io_call.whole(4)), passing));
  return base::Ok{};
}

// pointcontents(place): a number such as CONTENT_WATER (-3).
base::Status pointcontents(Call& io_call) {
  io_call.machine.return_float(static_cast<float>(point_contents(io_call.world, io_call.vector(0))));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> tracing_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {16, "traceline", traceline},
      {41, "pointcontents", pointcontents},
      {90, "tracebox", tracebox},
  };
  return kEntries;
}

}  // namespace temblor::server
