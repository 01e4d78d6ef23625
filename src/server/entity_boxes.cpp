#include "server/entity_boxes.h"

#include "server/game/entity_fields.h"

namespace temblor::server {
namespace {

// A turned brush model's own bounds do not contain it. The bounds with which it is linked do.
math::Bounds find_box(const Edict& edict) {
  if (edict.solid() == Solid::kBsp && edict[field::kAngles] != math::Vec3(0.0f))
    return {edict[field::kAbsMin], edict[field::kAbsMax]};
  const math::Vec3 origin = edict[field::kOrigin];
  return {origin + edict[field::kMins], origin + edict[field::kMaxs]};
}

}  // namespace

std::vector<math::Bounds> list_entity_boxes(Game& game, std::size_t without_slot) {
  Edicts& edicts = game.world().edicts;
  std::vector<math::Bounds> boxes;
  for (std::uint32_t i = 1; i < edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (!edicts.is_free(entity) && entity != Game::player_index(without_slot))
      boxes.push_back(find_box(edicts[entity]));
  }
  return boxes;
}

}  // namespace temblor::server
