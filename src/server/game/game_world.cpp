#include "server/game/game_world.h"

#include <algorithm>

namespace temblor::server {
namespace {

// Traces stop short of what they meet, so things that touch are a little apart.
constexpr float kBoxMargin = 1;
// Makes items easy to pick up.
constexpr float kItemMargin = 15;

// The box in which others look for the entity. Items are wider, but not higher.
math::Bounds linked_box(const Edict& edict) {
  const math::Vec3 origin = edict[field::kOrigin];
  const math::Vec3 margin =
      edict.has_flag(flag::kItem) ? math::Vec3(kItemMargin, kItemMargin, 0) : math::Vec3(kBoxMargin);
  return {origin + edict[field::kMins] - margin, origin + edict[field::kMaxs] + margin};
}

// The box's nearest and farthest distance from a plane.
struct PlaneReach {
  double nearest, farthest;
};
PlaneReach find_reach(const math::Bounds& box, const world::Plane& plane) {
  if (plane.axis < 3)
    return {double{box.mins[plane.axis]} - double{plane.distance},
            double{box.maxs[plane.axis]} - double{plane.distance}};
  const math::Vec3d normal(plane.normal);
  const math::Vec3d low = normal * math::Vec3d(box.mins), high = normal * math::Vec3d(box.maxs);
  const math::Vec3d nearest = glm::min(low, high), farthest = glm::max(low, high);
  return {nearest.x + nearest.y + nearest.z - double{plane.distance},
          farthest.x + farthest.y + farthest.z - double{plane.distance}};
}

// Walks down the BSP tree, and recurses only where a plane cuts the box. Solid leaves do not count: nothing
// is visible from or in them.
void find_leaves(const world::Level& level, world::Child child, const math::Bounds& box,
                 EdictState& io_state) {
  while (!child.is_leaf()) {
    const world::Node& node = level.node(child.node());
    const PlaneReach reach = find_reach(box, level.planes[node.plane]);
    if (reach.farthest >= 0) {
      if (reach.nearest < 0) find_leaves(level, node.children[1], box, io_state);
      if (io_state.is_in_too_many_leaves) return;
      child = node.children[0];
    } else {
      child = node.children[1];
    }
  }
  if (level.leaf(child.leaf()).contents == world::Contents::kSolid) return;
  if (io_state.leaves.size() == EdictState::kMaxLeaves) {
    io_state.is_in_too_many_leaves = true;
    io_state.leaves.clear();
    return;
  }
  io_state.leaves.push_back(child.leaf());
}

bool boxes_meet(const Edict& a, const Edict& b) {
  const math::Vec3 a_min = a[field::kAbsMin], a_max = a[field::kAbsMax];
  const math::Vec3 b_min = b[field::kAbsMin], b_max = b[field::kAbsMax];
  return glm::all(glm::lessThanEqual(a_min, b_max)) && glm::all(glm::greaterThanEqual(a_max, b_min));
}

// Calls touch functions of triggers only; the toucher's own is not called. Any of these functions may remove
// or move anything, so each entity is looked up again.
base::Status touch_triggers(GameWorld& io_world, vm::EntityIndex entity) {
  std::vector<vm::EntityIndex>& found = io_world.scratch.found;
  const std::size_t first = found.size();
  const Edict toucher = io_world.edicts[entity];
  io_world.areas.find({toucher[field::kAbsMin], toucher[field::kAbsMax]}, AreaKind::kTrigger, found);
  const std::size_t end = found.size();
  base::Status status = base::Ok{};
  for (std::size_t i = first; i < end && status.ok() && is_there(io_world, entity); ++i) {
    if (found[i] == entity || !is_there(io_world, found[i])) continue;
    // Touches before this one may have moved either, or changed what the trigger is.
    const Edict trigger = io_world.edicts[found[i]];
    if (trigger.solid() != Solid::kTrigger || trigger[field::kTouch] == vm::kNoFunction ||
        !boxes_meet(io_world.edicts[entity], trigger))
      continue;
    status = io_world.calls.call(trigger[field::kTouch], found[i], entity, io_world.time_s);
  }
  found.resize(first);
  return status;
}

// Water of Half-Life's levels rises and falls.
void place_liquid(GameWorld& io_world, const Edict& edict) {
  const ServerModel* const model = io_world.find_model(edict);
  if (model == nullptr || !model->brush_model) return;
  const world::BrushEntity& entity = io_world.level->brush_entities[base::to_size(*model->brush_model)];
  if (entity.liquid == world::Contents::kEmpty) return;
  const auto placed = std::ranges::find(io_world.liquids, *model->brush_model, &world::PlacedLiquid::model);
  if (placed == io_world.liquids.end())
    io_world.liquids.push_back({*model->brush_model, edict[field::kOrigin]});
  else
    placed->origin = edict[field::kOrigin];
}

}  // namespace

const ServerModel* GameWorld::find_model(const Edict& edict) const {
  const int number = edict.whole(field::kModelIndex);
  return number > 0 && static_cast<std::size_t>(number) < models.size()
             ? &models[static_cast<std::size_t>(number)]
             : nullptr;
}

bool is_there(const GameWorld& world, vm::EntityIndex entity) {
  return base::to_size(entity) < world.edicts.count() && !world.edicts.is_free(entity);
}

// The world and free entities are only unlinked. Entities without a model have no leaves: clients never see
// them.
base::Status link(GameWorld& io_world, vm::EntityIndex entity, TouchTriggers touch) {
  io_world.areas.unlink(entity);
  if (entity == vm::kWorld || io_world.edicts.is_free(entity)) return base::Ok{};
  const Edict edict = io_world.edicts[entity];
  const math::Bounds box = linked_box(edict);
  edict.set(field::kAbsMin, box.mins);
  edict.set(field::kAbsMax, box.maxs);

  EdictState& state = io_world.edicts.state(entity);
  state.leaves.clear();
  state.is_in_too_many_leaves = false;
  if (edict[field::kModelIndex] != 0) find_leaves(*io_world.level, io_world.level->world().head, box, state);

  if (io_world.level->is_half_life) place_liquid(io_world, edict);
  const Solid solid = edict.solid();
  if (solid == Solid::kNot) return base::Ok{};
  io_world.areas.link(entity, box, solid == Solid::kTrigger ? AreaKind::kTrigger : AreaKind::kSolid);
  return touch == TouchTriggers::kYes ? touch_triggers(io_world, entity) : base::Status(base::Ok{});
}

void unlink(GameWorld& io_world, vm::EntityIndex entity) {
  io_world.areas.unlink(entity);
}

void remove(GameWorld& io_world, vm::EntityIndex entity) {
  unlink(io_world, entity);
  io_world.edicts.free(entity, io_world.time_s);
}

}  // namespace temblor::server
