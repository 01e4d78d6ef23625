// Built-in functions for the program's own entities, which exist only as its data: nothing is drawn for them.
#include "client/hud_program/program_call.h"
#include "math/angles.h"

namespace temblor::client {
namespace {

// makevectors(angles): sets v_forward, v_right, and v_up, if the program declares them.
base::Status makevectors(ProgramCall& io_call) {
  const math::Basis basis = math::basis_from_angles(io_call.vector(0));
  const auto set = [&](std::string_view name, const math::Vec3& value) {
    const formats::ProgsDefinition* const global = io_call.machine.program().find_global(name);
    if (global != nullptr && global->type == formats::ProgsType::kVector)
      io_call.machine.set_global_vector(vm::GlobalIndex{global->offset}, value);
  };
  set("v_forward", math::Vec3(basis.forward));
  set("v_right", math::Vec3(basis.right));
  set("v_up", math::Vec3(basis.up));
  return base::Ok{};
}

// spawn(): an entity whose fields are 0.
base::Status spawn(ProgramCall& io_call) {
  auto& free = io_call.program.free_entities;
  std::uint32_t number = io_call.machine.entity_count();
  if (free.empty()) {
    TRY_STATUS(io_call.machine.set_entity_count(number + 1));
  } else {
    number = *free.begin();
    free.erase(free.begin());
  }
  const std::span<std::uint32_t> words = io_call.machine.entity(vm::EntityIndex{number});
  std::fill(words.begin(), words.end(), 0);
  io_call.machine.return_entity(vm::EntityIndex{number});
  return base::Ok{};
}

base::Status remove(ProgramCall& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  if (entity == vm::kWorld) return io_call.error("the world cannot be removed");
  io_call.program.free_entities.insert(static_cast<std::uint32_t>(entity));
  return base::Ok{};
}

base::Status wasfreed(ProgramCall& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  return io_call.return_number(
      io_call.program.free_entities.contains(static_cast<std::uint32_t>(entity)) ? 1 : 0);
}

// Returns the next entity in use that fits, or the world.
template <typename Fits>
base::Status return_next(ProgramCall& io_call, vm::EntityIndex after, Fits fits) {
  const std::uint32_t count = io_call.machine.entity_count();
  io_call.machine.return_entity(vm::kWorld);
  for (std::uint32_t number = static_cast<std::uint32_t>(after) + 1; number < count; ++number) {
    io_call.machine.charge(1);
    if (io_call.program.free_entities.contains(number) || !fits(vm::EntityIndex{number})) continue;
    io_call.machine.return_entity(vm::EntityIndex{number});
    break;
  }
  return base::Ok{};
}

base::Status nextent(ProgramCall& io_call) {
  TRY(const vm::EntityIndex after, io_call.entity(0));
  return return_next(io_call, after, [](vm::EntityIndex) { return true; });
}

// find(after, field, text) and findfloat(after, field, number)
base::Status find(ProgramCall& io_call) {
  TRY(const vm::EntityIndex after, io_call.entity(0));
  TRY(const vm::FieldIndex field, io_call.field(1));
  const std::string text(io_call.text(2));
  return return_next(io_call, after, [&](vm::EntityIndex entity) {
    return io_call.machine.text(vm::StringIndex{io_call.machine.entity(entity)[base::to_size(field)]}) ==
           text;
  });
}
base::Status findfloat(ProgramCall& io_call) {
  TRY(const vm::EntityIndex after, io_call.entity(0));
  TRY(const vm::FieldIndex field, io_call.field(1));
  const float number = io_call.number(2);
  return return_next(io_call, after, [&](vm::EntityIndex entity) {
    return std::bit_cast<float>(io_call.machine.entity(entity)[base::to_size(field)]) == number;
  });
}

}  // namespace

std::span<const ProgramEntry> program_entities() {
  static constexpr ProgramEntry kEntries[] = {
      {1, "makevectors", makevectors}, {14, "spawn", spawn},
      {15, "remove", remove},          {18, "find", find},
      {47, "nextent", nextent},        {98, "findfloat", findfloat},
      {353, "wasfreed", wasfreed},
  };
  return kEntries;
}

}  // namespace temblor::client
