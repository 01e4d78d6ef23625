// Built-in functions that make, place, shape and remove entities.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// Links an entity whose shape or place was set. Triggers are not touched; physics does that later.
base::Status linked(Call& io_call, vm::EntityIndex entity) {
  return link(io_call.world, entity, TouchTriggers::kNo);
}

void set_size(const Edict& edict, const math::Bounds& box) {
  edict.set(field::kMins, box.mins);
  edict.set(field::kMaxs, box.maxs);
  edict.set(field::kSize, box.maxs - box.mins);
}

// setorigin(entity, place)
base::Status setorigin(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  io_call.world.edicts[entity].set(field::kOrigin, io_call.vector(1));
  return linked(io_call, entity);
}

// setmodel(entity, name): also sets modelindex, and the size to the model's box. The model must be precached.
// Without a brush model that only the level's entities name, the entity is a point.
base::Status setmodel(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  const std::string_view name = io_call.text(1);
  const std::vector<ServerModel>& models = io_call.world.models;
  const auto found = std::find_if(models.begin(), models.end(),
                                  [&](const ServerModel& model) { return model.name == name; });
  const bool is_found = found != models.end();
  if (!is_found && !name.starts_with('*'))
    return io_call.error("\"{}\" was not precached", base::quotable(name));
  if (!is_found) io_call.warn_once(fmt::format("the level has no brush model \"{}\"", base::quotable(name)));
  const Edict edict = io_call.world.edicts[entity];
  edict.set(field::kModel, io_call.machine.parameter_string(1));
  edict.set(field::kModelIndex, is_found ? static_cast<float>(found - models.begin()) : 0.0f);
  set_size(edict, is_found ? found->box : math::Bounds{});
  return linked(io_call, entity);
}

// setsize(entity, mins, maxs)
base::Status setsize(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  const math::Bounds box{io_call.vector(1), io_call.vector(2)};
  for (int axis = 0; axis < 3; ++axis)
    if (box.mins[axis] > box.maxs[axis])
      return io_call.error("the box from ({} {} {}) to ({} {} {}) has mins above maxs in {}", box.mins.x,
                           box.mins.y, box.mins.z, box.maxs.x, box.maxs.y, box.maxs.z, "xyz"[axis]);
  set_size(io_call.world.edicts[entity], box);
  return linked(io_call, entity);
}

// spawn(): returns a new entity with all fields 0.
base::Status spawn(Call& io_call) {
  const base::Result<vm::EntityIndex> made = io_call.world.edicts.spawn(io_call.world.time_s);
  if (!made.ok()) return io_call.error("{}", made.error().message());
  io_call.machine.return_entity(*made);
  return base::Ok{};
}

// The level cannot continue without the world or a player's entity. The original lets game code remove them,
// and crashes later.
base::Status check_removable(Call& io_call, vm::EntityIndex entity) {
  if (entity == vm::kWorld) return io_call.error("the world cannot be removed");
  if (io_call.is_player(entity))
    return io_call.error("entity {} is a player's and cannot be removed", base::to_size(entity));
  return base::Ok{};
}

// remove(entity): a second call for the same entity does nothing.
base::Status remove_entity(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  TRY_STATUS(check_removable(io_call, entity));
  if (!io_call.world.edicts.is_free(entity)) remove(io_call.world, entity);
  return base::Ok{};
}

std::uint8_t low_byte(float value) {
  return static_cast<std::uint8_t>(to_whole(value) & 0xff);
}

// makestatic(entity): hands the entity over to the clients, which get it once, when they join. It no longer
// exists on the server.
base::Status makestatic(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  TRY_STATUS(check_removable(io_call, entity));
  if (io_call.world.edicts.is_free(entity)) return base::Ok{};
  const Edict edict = io_call.world.edicts[entity];
  net::Baseline baseline;
  baseline.model =
      static_cast<std::uint16_t>(std::clamp(edict.whole(field::kModelIndex), 0, net::kMaxModels));
  baseline.frame = static_cast<std::uint16_t>(std::clamp(edict.whole(field::kFrame), 0, 65535));
  baseline.colormap = low_byte(edict[field::kColorMap]);
  baseline.skin = low_byte(edict[field::kSkin]);
  baseline.origin = edict[field::kOrigin];
  baseline.angles_deg = edict[field::kAngles];
  if (const auto* alpha = io_call.machine.program().find_field("alpha"))
    if (const float value = edict[Field<float>{alpha->offset}]; value > 0 && value <= 1)
      baseline.alpha = value;
  io_call.game.outbox.write(net::SpawnStatic{baseline}, io_call.game.outbox.signon());
  remove(io_call.world, entity);
  return base::Ok{};
}

// copyentity(from, to): copies all fields.
base::Status copyentity(Call& io_call) {
  TRY(const vm::EntityIndex from, io_call.entity(0));
  TRY(const vm::EntityIndex to, io_call.entity(1));
  if (to == vm::kWorld) return io_call.error("nothing can be copied over the world");
  if (io_call.world.edicts.is_free(to)) return io_call.error("entity {} was removed", base::to_size(to));
  const auto words = io_call.world.edicts[from].words();
  std::copy(words.begin(), words.end(), io_call.world.edicts[to].words().begin());
  return linked(io_call, to);
}

base::Status num_for_edict(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  return io_call.return_number(static_cast<double>(base::to_size(entity)));
}

}  // namespace

std::span<const BuiltinEntry> entity_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {2, "setorigin", setorigin},     {3, "setmodel", setmodel},
      {4, "setsize", setsize},         {14, "spawn", spawn},
      {15, "remove", remove_entity},   {69, "makestatic", makestatic},
      {400, "copyentity", copyentity}, {512, "num_for_edict", num_for_edict},
  };
  return kEntries;
}

}  // namespace temblor::server
