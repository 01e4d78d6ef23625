#include "level_reach/explorer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace temblor::test {
namespace {

using world::Hull;
using world::ModelIndex;

constexpr float kCell = 16, kStep = 18, kRunSpeed = 320, kJumpSpeed = 270, kGravity = 800;
constexpr math::Vec3 kMins{-16, -16, -24}, kMaxs{16, 16, 32};

// A key for the 16-unit cell of a position; each cell is visited once.
std::uint64_t find_cell(const math::Vec3& position) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis)
    key = (key << 21) | static_cast<std::uint64_t>(
                            static_cast<std::int64_t>(std::floor(position[axis] / kCell)) + (1 << 20));
  return key;
}

bool overlap(const math::Bounds& a, const math::Bounds& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.mins[axis] > b.maxs[axis] || b.mins[axis] > a.maxs[axis]) return false;
  return true;
}

math::Bounds box_at(const math::Vec3& position) {
  return {position + kMins, position + kMaxs};
}

std::vector<math::Vec3> list_directions() {
  std::vector<math::Vec3> directions;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * 0.78539816339744831;
    directions.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0f);
  }
  return directions;
}

const formats::Entity* find_by_targetname(const world::Level& level, std::string_view name) {
  for (const formats::Entity& entity : level.entities)
    if (entity.find("targetname") == name) return &entity;
  return nullptr;
}

math::Vec3 find_push_direction(const formats::Entity& trigger) {
  const float angle = trigger.find_number("angle").value_or(0);
  if (angle == -1) return {0, 0, 1};
  if (angle == -2) return {0, 0, -1};
  const math::Vec3 angles = trigger.find_vec3("angles").value_or(math::Vec3(0, angle, 0));
  const double pitch = angles.x * 0.017453292519943295, yaw = angles.y * 0.017453292519943295;
  return {static_cast<float>(std::cos(pitch) * std::cos(yaw)),
          static_cast<float>(std::cos(pitch) * std::sin(yaw)), static_cast<float>(-std::sin(pitch))};
}

}  // namespace

math::Bounds entity_box(const world::Level& level, const formats::Entity& entity) {
  const std::string_view model = entity.find("model").value_or("");
  if (model.starts_with('*')) {
    std::uint32_t number = 0;
    std::from_chars(model.data() + 1, model.data() + model.size(), number);
    return level.models[number].bounds;
  }
  const math::Vec3 origin = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
  return {origin - 16.0f, origin + 16.0f};
}

Explorer::Explorer(const world::Level& level)
    : level_(level),
      player_hull_(level, ModelIndex{0}, Hull::kPlayer),
      point_hull_(level, ModelIndex{0}, Hull::kPoint) {
  collect_links();
}

void Explorer::collect_links() {
  for (const formats::Entity& entity : level_.entities) {
    const math::Bounds box = entity_box(level_, entity);
    if (entity.classname() == "trigger_teleport") {
      const formats::Entity* goal = find_by_targetname(level_, entity.find("target").value_or(""));
      if (goal != nullptr)
        links_.push_back({box, goal->find_vec3("origin").value_or(math::Vec3(0.0f)) + math::Vec3(0, 0, 27)});
    } else if (entity.classname() == "trigger_push") {
      const float speed = entity.find_number("speed").value_or(1000);
      links_.push_back({box, math::Vec3(0.0f), find_push_direction(entity) * (speed * 10)});
    } else if (entity.classname() == "func_plat") {
      // From anywhere in the shaft onto the middle of the raised lift.
      const float height = entity.find_number("height").value_or(box.maxs.z - box.mins.z - 8);
      math::Bounds shaft = box;
      shaft.mins.z -= height;
      // Far enough from the middle to stand on the floor around it.
      const math::Vec3 middle = (box.mins + box.maxs) * 0.5f, size = box.maxs - box.mins;
      const float to_edge = std::max(size.x, size.y) * 0.5f + kMaxs.x + 8;
      links_.push_back({shaft, {middle.x, middle.y, box.maxs.z + 25}, math::Vec3(0.0f), to_edge});
    }
  }
}

void Explorer::explore(const std::vector<math::Vec3>& starts) {
  for (const math::Vec3& start : starts) land(start + math::Vec3(0, 0, 1));
  while (!pending_.empty()) {
    const math::Vec3 position = pending_.back();
    pending_.pop_back();
    visit(position);
  }
}

bool Explorer::touches(const math::Bounds& box) const {
  return std::any_of(positions_.begin(), positions_.end(),
                     [&](const math::Vec3& position) { return overlap(box_at(position), box); });
}

world::Trace Explorer::trace(const math::Vec3& from, const math::Vec3& to) {
  return player_hull_.trace_line(from, to);
}

bool Explorer::is_water(const math::Vec3& position) {
  return point_hull_.contents(position) == world::Contents::kWater;
}

bool Explorer::is_deadly(const math::Vec3& position) {
  const world::Contents contents = point_hull_.contents(position - math::Vec3(0, 0, 20));
  return contents == world::Contents::kLava || contents == world::Contents::kSlime;
}

void Explorer::visit(const math::Vec3& position) {
  follow_links(position);
  if (is_deadly(position)) return;
  static const std::vector<math::Vec3> kWays = list_directions();
  if (is_water(position)) {
    swim(position);
    return;
  }
  for (const math::Vec3& direction : kWays) {
    walk(position, direction);
    fly(position, direction * kRunSpeed + math::Vec3(0, 0, kJumpSpeed));
    fly(position, direction * (kRunSpeed / 3) + math::Vec3(0, 0, kJumpSpeed));
  }
}

void Explorer::follow_links(const math::Vec3& position) {
  for (const Link& link : links_) {
    if (!overlap(box_at(position), link.box)) continue;
    if (link.to_edge > 0)
      leave_lift(link);
    else if (link.velocity == math::Vec3(0.0f))
      land(link.to);
    else
      for (const math::Vec3& drift : list_directions()) fly(position, link.velocity + drift * 30.0f);
  }
}

// The lift itself is not solid here, so the player must leave it before falling.
void Explorer::leave_lift(const Link& link) {
  if (trace(link.to, link.to).start_solid) return;
  for (const math::Vec3& direction : list_directions()) {
    land(trace(link.to, link.to + direction * link.to_edge).end);
    fly(link.to, direction * kRunSpeed + math::Vec3(0, 0, kJumpSpeed));
  }
}

void Explorer::walk(const math::Vec3& position, const math::Vec3& direction) {
  const world::Trace level_trace = trace(position, position + direction * kCell);
  if (level_trace.fraction == 1) return land(level_trace.end);
  const math::Vec3 up = trace(position, position + math::Vec3(0, 0, kStep)).end;
  const math::Vec3 over = trace(up, up + direction * kCell).end;
  land(over);
  land(level_trace.end);
}

void Explorer::fly(math::Vec3 position, math::Vec3 velocity) {
  constexpr float kTick = 0.02f;
  for (int i = 0; i < 250; ++i) {
    velocity.z -= kGravity * kTick;
    const math::Vec3 across(velocity.x * kTick, velocity.y * kTick, 0);
    position = trace(position, position + across).end;
    const world::Trace fall = trace(position, position + math::Vec3(0, 0, velocity.z * kTick));
    position = fall.end;
    if (fall.fraction < 1 && velocity.z < 0) return land(position);
    if (fall.fraction < 1) velocity.z = 0;
    if (is_water(position)) return land(position);
    // A player also touches items in the air.
    if (i % 8 == 0) positions_.push_back(position);
  }
}

// Swims in all directions, and climbs out onto a shore that is at most 32 units above the water.
void Explorer::swim(const math::Vec3& position) {
  for (const math::Vec3& direction : list_directions()) {
    for (const float rise : {-1.0f, 0.0f, 1.0f}) {
      const math::Vec3 to = trace(position, position + (direction + math::Vec3(0, 0, rise)) * kCell).end;
      if (is_water(to)) land(to);
    }
    const math::Vec3 up = trace(position, position + math::Vec3(0, 0, 56)).end;
    if (!is_water(up + math::Vec3(0, 0, 8))) land(trace(up, up + direction * 24.0f).end);
  }
  for (const float rise : {-kCell, kCell}) {
    const math::Vec3 to = trace(position, position + math::Vec3(0, 0, rise)).end;
    if (is_water(to)) land(to);
  }
}

// Falls from the position to the ground or into water, and registers the new position.
void Explorer::land(const math::Vec3& position) {
  math::Vec3 at = position;
  if (!is_water(at)) {
    for (int i = 0; i < 1024; ++i) {
      const world::Trace fall = trace(at, at - math::Vec3(0, 0, 8));
      if (fall.start_solid) return;
      at = fall.end;
      if (fall.fraction < 1 || is_water(at)) break;
    }
  }
  if (!visited_.insert(find_cell(at)).second) return;
  positions_.push_back(at);
  pending_.push_back(at);
}

}  // namespace temblor::test
