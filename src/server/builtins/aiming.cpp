// Who sees a player, and at whom a player shoots.
#include "server/builtins/families.h"
#include "server/move_trace.h"
#include "world/visibility.h"

namespace temblor::server {
namespace {

constexpr double kCheckSeconds = 0.1;
constexpr int kDamageAim = 2;      // takedamage of what helps a player to hit it
constexpr float kShotHeight = 20;  // of a shot's start over the origin
constexpr float kStraightReach = 2048;

math::Vec3 eye_of(const Edict& edict) {
  return edict[field::kOrigin] + edict[field::kViewOffset];
}

// Whose turn it is next: the one behind `last` who is there, lives and may be noticed; `last` himself where
// there is no other, whatever he is.
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

// One player every 0.1 s is there to be seen, so that a room of monsters costs no more than one of them.
// Returns him where the caller's eye is in his PVS, else the world.
base::Status checkclient(Call& io_call) {
  GameWorld& world = io_call.world;
  BuiltinContext& game = io_call.game;
  io_call.machine.return_entity(vm::kWorld);
  if (world.edicts.client_count() == 0) return base::Ok{};
  // A clock that was set back (a new level) begins anew.
  const double waited_s = world.time_s - game.check_client_since_s;
  if (waited_s >= kCheckSeconds || waited_s < 0 || game.check_client_pvs.empty()) {
    game.check_client = next_client(world, world.edicts, game.check_client);
    game.check_client_since_s = world.time_s;
    const math::Vec3 eye = eye_of(world.edicts[game.check_client]);
    world::decompress_pvs(*world.level, world::find_leaf(*world.level, eye), game.check_client_pvs);
  }
  const Edict player = world.edicts.at(game.check_client);
  if (world.edicts.is_free(player.index()) || !(player[field::kHealth] > 0)) return base::Ok{};
  const Edict viewer = world.edicts.at(io_call.self());
  if (world::pvs_has(game.check_client_pvs, world::find_leaf(*world.level, eye_of(viewer))))
    io_call.machine.return_entity(player.index());
  return base::Ok{};
}

// Whether `shooter` wants to hit it: what takes aimed damage, and in team play is of another team.
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

float aim_limit(Call& io_call) {
  return io_call.game.variables.find("sv_aim") == nullptr ? 0.93f : io_call.variable("sv_aim");
}

// Whom the view points at best, within sv_aim (a cosine), and can hit; the world where there is nobody.
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

// aim(shooter, speed): where to shoot: straight ahead, but up or down as it takes to hit whom the view points
// at. The speed does nothing.
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
  };
  return kEntries;
}

}  // namespace temblor::server
