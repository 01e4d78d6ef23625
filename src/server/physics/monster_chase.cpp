// The path of a monster to its goal: straight on, and around what is in the way by trying compass directions.
// There is no search and no memory besides ideal_yaw:
//    1. diagonally toward the goal        4. a full turn of all eight directions, either way round
//    2. along x or y toward the goal      5. back where it came from
//    3. on as before                      6. none: it stays
#include <cmath>
#include <optional>
#include <utility>

#include "server/physics/monster_angles.h"
#include "server/physics/physics.h"

namespace temblor::server {
namespace {

// Nearer than this along an axis: there is no need to move along it.
constexpr float kLevelWith = 10;
constexpr float kEighth_deg = 45;
// The original's number for south-west is a slip for 225. It is kept, so that monsters walk as they always
// did.
constexpr float kSouthWest_deg = 215;

// Whether the boxes are at most a step apart along every axis.
bool is_within_reach(const Edict& monster, const Edict& goal, float distance) {
  const math::Vec3 mins = monster[field::kAbsMin] - distance, maxs = monster[field::kAbsMax] + distance;
  return !glm::any(glm::greaterThan(goal[field::kAbsMin], maxs)) &&
         !glm::any(glm::lessThan(goal[field::kAbsMax], mins));
}

// One monster that looks for a path.
struct Chase {
  GameWorld& world;
  vm::EntityIndex monster;
  float distance;

  // Turns toward this direction, and takes a step in it. true: the path is free. The step is undone while the
  // monster still faces elsewhere, because it needs several ticks for a turn.
  base::Result<bool> step(float yaw_deg) const {
    const Edict edict = world.edicts[monster];
    edict.set(field::kIdealYaw, yaw_deg);
    change_yaw(world, monster);
    const math::Vec3 origin = edict[field::kOrigin];
    TRY(const bool is_free,
        step_monster(world, monster, step_towards(yaw_deg, distance), TouchTriggers::kNo));
    if (is_free) {
      const float off = edict[field::kAngles].y - edict[field::kIdealYaw];
      if (off > kEighth_deg && off < 360 - kEighth_deg) edict.set(field::kOrigin, origin);
    }
    TRY_STATUS(link(world, monster, TouchTriggers::kYes));
    return is_free;
  }

  // Tries the directions in order, except missing ones and the one to leave out.
  template <std::size_t count>
  base::Result<bool> step_toward_any(const std::array<std::optional<float>, count>& yaws_deg,
                                     std::optional<float> left_out_deg) const {
    for (const std::optional<float>& yaw_deg : yaws_deg) {
      if (!yaw_deg || yaw_deg == left_out_deg) continue;
      TRY(const bool is_free, step(*yaw_deg));
      if (is_free || !is_there(world, monster)) return true;
    }
    return false;
  }
};

// Needs a direction along both axes.
std::optional<float> diagonal_deg(std::optional<float> x_deg, std::optional<float> y_deg) {
  if (!x_deg || !y_deg) return std::nullopt;
  if (*x_deg == 0) return *y_deg == 90 ? 45.0f : 315.0f;
  return *y_deg == 90 ? 135.0f : kSouthWest_deg;
}

// All eight directions, in ascending or descending order.
std::array<std::optional<float>, 8> compass_deg(bool upwards) {
  std::array<std::optional<float>, 8> yaws;
  for (std::size_t i = 0; i < yaws.size(); ++i)
    yaws[i] = kEighth_deg * static_cast<float>(upwards ? i : yaws.size() - 1 - i);
  return yaws;
}

// The order of attempts, including the order in which random numbers are drawn, is the original's.
base::Status choose_direction(const Chase& chase, const Edict& monster, const Edict& goal,
                              GameRandom& io_random) {
  const auto eighths = std::trunc(monster[field::kIdealYaw] / kEighth_deg);
  const float old_deg = whole_turn_deg(eighths * kEighth_deg);
  const float back_deg = whole_turn_deg(old_deg - 180);
  const math::Vec3 to_goal = goal[field::kOrigin] - monster[field::kOrigin];
  const auto along = [](float delta, float positive_deg, float negative_deg) -> std::optional<float> {
    if (delta > kLevelWith) return positive_deg;
    if (delta < -kLevelWith) return negative_deg;
    return std::nullopt;
  };
  std::optional<float> first = along(to_goal.x, 0, 180), second = along(to_goal.y, 90, 270);

  TRY(bool found, chase.step_toward_any(std::array{diagonal_deg(first, second)}, back_deg));
  if (found) return base::Ok{};
  const bool swaps = (io_random.next_15_bits() & 1) != 0;
  if (swaps || std::abs(to_goal.y) > std::abs(to_goal.x)) std::swap(first, second);
  TRY(found, chase.step_toward_any(std::array{first, second}, back_deg));
  if (found) return base::Ok{};
  TRY(found, chase.step_toward_any(std::array{std::optional(old_deg)}, std::nullopt));
  if (found) return base::Ok{};
  TRY(found, chase.step_toward_any(compass_deg((io_random.next_15_bits() & 1) != 0), back_deg));
  if (found) return base::Ok{};
  TRY(found, chase.step_toward_any(std::array{std::optional(back_deg)}, std::nullopt));
  if (found) return base::Ok{};

  // No way at all. Perhaps a lift has moved its floor away: then it may walk over the edge.
  const Edict stuck = chase.world.edicts[chase.monster];
  stuck.set(field::kIdealYaw, old_deg);
  if (!check_bottom(chase.world, chase.monster)) stuck.set_flag(flag::kPartialGround);
  return base::Ok{};
}

}  // namespace

base::Status move_to_goal(GameWorld& io_world, vm::EntityIndex monster, float distance,
                          GameRandom& io_random) {
  const Edict edict = io_world.edicts[monster];
  if (!can_step(edict)) return base::Ok{};
  const vm::EntityIndex goal = io_world.edicts.at(edict[field::kGoalEntity]).index();
  const bool has_enemy = io_world.edicts.at(edict[field::kEnemy]).index() != vm::kWorld;
  if (has_enemy && is_within_reach(edict, io_world.edicts[goal], distance)) return base::Ok{};

  const Chase chase{io_world, monster, distance};
  if ((io_random.next_15_bits() & 3) != 1) {
    TRY(const bool is_free, chase.step(edict[field::kIdealYaw]));
    if (is_free || !is_there(io_world, monster)) return base::Ok{};
  }
  return choose_direction(chase, io_world.edicts[monster], io_world.edicts[goal], io_random);
}

}  // namespace temblor::server
