// Built-in functions that search for entities. They never find free ones.
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

std::uint32_t word_at(Call& io_call, std::size_t entity, vm::FieldIndex field) {
  return io_call.world.edicts[base::to_index<vm::EntityIndex>(entity)].words()[base::to_size(field)];
}
float float_at(Call& io_call, std::size_t entity, vm::FieldIndex field) {
  return std::bit_cast<float>(word_at(io_call, entity, field));
}
std::string_view text_at(Call& io_call, std::size_t entity, vm::FieldIndex field) {
  return io_call.machine.text(vm::StringIndex{word_at(io_call, entity, field)});
}

// The first wanted entity after `start`, or the world.
template <typename IsWanted>
vm::EntityIndex next_entity(Call& io_call, vm::EntityIndex start, IsWanted is_wanted) {
  for (std::size_t i = base::to_size(start) + 1; i < io_call.world.edicts.count(); ++i) {
    const auto index = base::to_index<vm::EntityIndex>(i);
    if (!io_call.world.edicts.is_free(index) && is_wanted(i)) return index;
  }
  return vm::kWorld;
}

// Links all wanted entities through their `chain` field: each refers to the one found before it. Returns the
// last one.
template <typename IsWanted>
base::Status return_chain(Call& io_call, IsWanted is_wanted) {
  vm::EntityIndex chain = vm::kWorld;
  for (vm::EntityIndex found = next_entity(io_call, vm::kWorld, is_wanted); found != vm::kWorld;
       found = next_entity(io_call, found, is_wanted)) {
    io_call.world.edicts[found].set(field::kChain, chain);
    chain = found;
  }
  io_call.machine.return_entity(chain);
  return base::Ok{};
}

// These functions take a field after the parameter `start` (or first), and a value after that.
template <typename IsWanted>
base::Status return_next(Call& io_call, IsWanted is_wanted) {
  TRY(const vm::EntityIndex start, io_call.entity(0));
  TRY(const vm::FieldIndex field, io_call.field(1));
  io_call.machine.return_entity(
      next_entity(io_call, start, [&](std::size_t i) { return is_wanted(i, field); }));
  return base::Ok{};
}

base::Status find(Call& io_call) {
  return return_next(io_call, [&, wanted = io_call.text(2)](std::size_t i, vm::FieldIndex field) {
    return text_at(io_call, i, field) == wanted;
  });
}
base::Status findfloat(Call& io_call) {
  return return_next(io_call, [&, wanted = io_call.number(2)](std::size_t i, vm::FieldIndex field) {
    return float_at(io_call, i, field) == wanted;
  });
}
// findflags(): any of the bits counts.
base::Status findflags(Call& io_call) {
  return return_next(io_call, [&, wanted = io_call.whole(2)](std::size_t i, vm::FieldIndex field) {
    return (to_whole(float_at(io_call, i, field)) & wanted) != 0;
  });
}

base::Status findchain(Call& io_call) {
  TRY(const vm::FieldIndex field, io_call.field(0));
  const std::string_view wanted = io_call.text(1);
  return return_chain(io_call, [&](std::size_t i) { return text_at(io_call, i, field) == wanted; });
}
base::Status findchainfloat(Call& io_call) {
  TRY(const vm::FieldIndex field, io_call.field(0));
  const float wanted = io_call.number(1);
  return return_chain(io_call, [&](std::size_t i) { return float_at(io_call, i, field) == wanted; });
}

base::Status findchainflags(Call& io_call) {
  TRY(const vm::FieldIndex field, io_call.field(0));
  const int wanted = io_call.whole(1);
  return return_chain(io_call,
                      [&](std::size_t i) { return (to_whole(float_at(io_call, i, field)) & wanted) != 0; });
}

// findradius(): measures the distance to the middle of each box. Entities that are not solid are skipped.
base::Status findradius(Call& io_call) {
  const math::Vec3 center = io_call.vector(0);
  const float radius = io_call.number(1);
  return return_chain(io_call, [&](std::size_t i) {
    const Edict edict = io_call.world.edicts[base::to_index<vm::EntityIndex>(i)];
    if (edict.solid() == Solid::kNot) return false;
    const math::Vec3 middle = edict[field::kOrigin] + (edict[field::kMins] + edict[field::kMaxs]) * 0.5f;
    return glm::distance(middle, center) <= radius;
  });
}

base::Status nextent(Call& io_call) {
  TRY(const vm::EntityIndex start, io_call.entity(0));
  io_call.machine.return_entity(next_entity(io_call, start, [](std::size_t) { return true; }));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> finding_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {18, "find", find},
      {22, "findradius", findradius},
      {47, "nextent", nextent},
      {98, "findfloat", findfloat},
      {402, "findchain", findchain},
      {403, "findchainfloat", findchainfloat},
      {449, "findflags", findflags},
      {450, "findchainflags", findchainflags},
  };
  return kEntries;
}

}  // namespace temblor::server
