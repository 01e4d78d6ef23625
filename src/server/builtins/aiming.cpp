// Built-in functions for monsters that look for players, and for players' aim.
#include <algorithm>

#include "server/builtins/families.h"
#include "server/move_trace.h"
#include "world/visibility.h"

namespace temblor::server {
namespace {

constexpr double kCheckSeconds = 0.1;
constexpr int kDamageAim = 2;      // the takedamage of entities that attract shots
constexpr float kShotHeight = 20;  // of a shot's start above the origin
constexpr float kStraightReach = 2048;

math::Vec3 eye_position(const Edict& edict) {
  return edict[field::kOrigin] + edict[field::kViewOffset];
}

// The next player that monsters may notice: the first one after `last` that is alive and not hidden by
// notarget. If there is none, `last` itself, in whatever state.
vm::EntityIndex next_client(const GameWorld& world, Edicts& edicts, vm::EntityIndex last) {
  const std::size_t count = world.edicts.client_count();
  std::size_t number = base::to_size(last);
  if (number < 1) number = 1;
  if (number > count) number = count;
  const std::size_t stop = number;
  do {
    number = number == count ? 1 : number + 1;
    const auto index = base::to_index<vm::EntityIndex>(number);
    const Edict player = edicts[index];
    if (!edicts.is_free(index) && player[field::kHealth] > 0 && !player.has_flag(flag::kNoTarget)) break;
  } while (number != stop);
  return base::to_index<vm::EntityIndex>(number);
}

// checkclient(): each player in turn can be noticed for 0.1 s, so that a room full of monsters costs no more
// than one PVS. Returns that player if the caller's eye is in the player's PVS, else the world.
base::Status checkclient(Call& io_call) {
  GameWorld& world = io_call.world;
  BuiltinContext& game = io_call.game;
  io_call.machine.return_entity(vm::kWorld);
  if (world.edicts.client_count() == 0) return base::Ok{};
  // The clock starts again in a new level.
  const double waited_s = world.time_s - game.check_client_since_s;
  if (waited_s >= kCheckSeconds || waited_s < 0 || game.check_client_pvs.empty()) {
    game.check_client = next_client(world, world.edicts, game.check_client);
    game.check_client_since_s = world.time_s;
    const math::Vec3 eye = eye_position(world.edicts[game.check_client]);
    world::decompress_pvs(*world.level, world::find_leaf(*world.level, eye), game.check_client_pvs);
  }
  const Edict player = world.edicts.at(game.check_client);
  if (world.edicts.is_free(player.index()) || !(player[field::kHealth] > 0)) return base::Ok{};
  const Edict viewer = world.edicts.at(io_call.self());
  if (world::is_in_pvs(game.check_client_pvs, world::find_leaf(*world.level, eye_position(viewer))))
    io_call.machine.return_entity(player.index());
  return base::Ok{};
}

// checkpvs(place, entity): whether the entity's box is in the PVS of the place, or its origin if it has no
// model.
base::Status checkpvs(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(1));
  const world::Level& level = *io_call.world.level;
  std::vector<std::uint8_t> row;
  world::decompress_pvs(level, world::find_leaf(level, io_call.vector(0)), row);
  const auto sees = [&](world::LeafIndex leaf) { return world::is_in_pvs(row, leaf); };
  const EdictState& state = io_call.world.edicts.state(entity);
  const bool is_seen =
      state.is_in_too_many_leaves || std::ranges::any_of(state.leaves, sees) ||
      (state.leaves.empty() && sees(world::find_leaf(level, io_call.world.edicts[entity][field::kOrigin])));
  return io_call.return_number(is_seen ? 1 : 0);
}

// Whether `shooter` wants to hit `target`: it takes aimed damage, and in team play it is in another team.
bool is_target(Call& io_call, const Edict& shooter, const Edict& target) {
  if (target.index() == shooter.index() || target.whole(field::kTakeDamage) != kDamageAim) return false;
  return io_call.variable("teamplay") == 0 || !(shooter[field::kTeam] > 0) ||
         shooter[field::kTeam] != target[field::kTeam];
}

EntityTrace trace_shot(Call& io_call, const math::Vec3& start, const math::Vec3& end,
                       vm::EntityIndex shooter) {
  const math::Vec3 point(0.0f);
  return trace_move(io_call.world, start, point, point, end, MoveKind::kNormal, shooter);
}

math::Vec3 unit(const math::Vec3& vector) {
  const float length = glm::length(vector);
  return length == 0 ? math::Vec3(0.0f) : vector / length;
}

// The original's default where the variable does not exist (in tests, for example).
float aim_limit(Call& io_call) {
  return io_call.context.variables.find("sv_aim") == nullptr ? 0.93f : io_call.variable("sv_aim");
}

// The target that is closest to the direction of view, within sv_aim (a cosine), and that a shot can reach.
// The world: there is none.
vm::EntityIndex best_target(Call& io_call, const Edict& shooter, const math::Vec3& start) {
  const math::Vec3 forward = io_call.forward();
  float best_cosine = aim_limit(io_call);
  vm::EntityIndex best = vm::kWorld;
  for (std::size_t i = 1; i < io_call.world.edicts.count(); ++i) {
    const auto index = base::to_index<vm::EntityIndex>(i);
    const Edict target = io_call.world.edicts[index];
    if (io_call.world.edicts.is_free(index) || !is_target(io_call, shooter, target)) continue;
    const math::Vec3 middle = target[field::kOrigin] + (target[field::kMins] + target[field::kMaxs]) * 0.5f;
    const float cosine = glm::dot(unit(middle - start), forward);
    if (!(cosine >= best_cosine)) continue;
    const EntityTrace trace = trace_shot(io_call, start, middle, shooter.index());
    if (!trace.hit || trace.entity != index) continue;
    best_cosine = cosine;
    best = index;
  }
  return best;
}

// aim(shooter, speed): the direction to shoot in. It is straight ahead, turned up or down as needed to hit
// the best target. The speed is not used.
base::Status aim(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  const Edict shooter = io_call.world.edicts[entity];
  const math::Vec3 forward = io_call.forward();
  const math::Vec3 start = shooter[field::kOrigin] + math::Vec3(0, 0, kShotHeight);
  io_call.machine.return_vector(forward);

  const EntityTrace straight = trace_shot(io_call, start, start + kStraightReach * forward, entity);
  if (straight.hit && is_target(io_call, shooter, io_call.world.edicts[straight.entity])) return base::Ok{};
  const vm::EntityIndex best = best_target(io_call, shooter, start);
  if (best == vm::kWorld) return base::Ok{};
  const math::Vec3 way = io_call.world.edicts[best][field::kOrigin] - shooter[field::kOrigin];
  math::Vec3 direction = forward * glm::dot(way, forward);
  direction.z = way.z;
  io_call.machine.return_vector(unit(direction));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> aiming_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {17, "checkclient", checkclient},
      {44, "aim", aim},
      {240, "checkpvs", checkpvs},
  };
  return kEntries;
}

}  // namespace temblor::server
