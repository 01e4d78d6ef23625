#include "server/game/half_life/brush_entities.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace temblor::server {
namespace {

enum class Show { kNot, kPassable, kSolid };

Show choose_show(std::string_view class_name, bool is_passable) {
  constexpr std::array<std::string_view, 6> kVolumes = {"func_ladder",          "func_monsterclip",
                                                        "func_friction",        "func_mortar_field",
                                                        "func_vehiclecontrols", "func_tankcontrols"};
  if (std::ranges::find(kVolumes, class_name) != kVolumes.end()) return Show::kNot;
  if (is_passable) return Show::kPassable;
  const bool is_thing = class_name.starts_with("func_") || class_name.starts_with("momentary_") ||
                        class_name == "button_target";
  return is_thing ? Show::kSolid : Show::kNot;
}

bool has_brush_model(const formats::Entity& entity) {
  return entity.find("model").value_or("").starts_with('*');
}

// The number of the entity's model in the list of models; 0: there is none.
std::size_t find_brush_model(const GameWorld& world, const formats::Entity& entity) {
  const std::string_view name = entity.find("model").value_or("");
  for (std::size_t i = 1; i < world.models.size(); ++i)
    if (world.models[i].brush_model && world.models[i].name == name) return i;
  return 0;
}

}  // namespace

base::Result<bool> show_half_life_entity(GameWorld& io_world, const formats::Entity& entity,
                                         vm::EntityIndex index) {
  const std::size_t model = find_brush_model(io_world, entity);
  if (!has_brush_model(entity) || model == 0) return false;
  const std::size_t number = base::to_size(*io_world.models[model].brush_model);
  const Show show = choose_show(entity.classname(), io_world.level->brush_entities[number].is_passable);
  if (show == Show::kNot) return false;
  const Edict edict = io_world.edicts[index];
  const math::Bounds& box = io_world.models[model].box;
  edict.set(field::kModelIndex, static_cast<float>(model));
  edict.set(field::kMins, box.mins);
  edict.set(field::kMaxs, box.maxs);
  edict.set(field::kSize, box.maxs - box.mins);
  edict.set(field::kAngles, math::Vec3(0.0f));  // the direction in which it would move
  edict.set(field::kMoveType, static_cast<float>(show == Show::kSolid ? MoveType::kPush : MoveType::kNone));
  edict.set(field::kSolid, static_cast<float>(show == Show::kSolid ? Solid::kBsp : Solid::kNot));
  TRY_STATUS(link(io_world, index, TouchTriggers::kNo));
  return true;
}

}  // namespace temblor::server
