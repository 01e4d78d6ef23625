#include "scripted_player/decisions/monster_watch.h"

#include <fmt/format.h>

#include "scripted_player/decisions/senses.h"
#include "server/move_trace.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr double kIdle_s = 5;
// Horizontal distance that counts as movement. Height does not count, because a monster may hop in place.
constexpr float kMoved_units = 10;
// At four checks per second, two seconds.
constexpr int kStuckLooks = 8;

bool is_in_wall(server::GameWorld& io_world, const server::Edict& edict) {
  const math::Vec3 at = edict[field::kOrigin];
  return server::trace_move(io_world, at, edict[field::kMins], edict[field::kMaxs], at,
                            server::MoveKind::kNoMonsters, edict.index())
      .trace.start_solid;
}

// Returns whether a monster that cannot swim is in a liquid, where it has nowhere to go while the player
// swims above.
bool is_at_the_bottom(const server::Edict& monster) {
  constexpr float kEmpty = -1;  // contents
  return monster[field::kWaterType] < kEmpty && !monster.has_flag(server::flag::kSwim);
}

}  // namespace

MonsterWatch::MonsterWatch(server::Game& io_game) : fields_(io_game.machine().program()) {}

std::vector<std::string> MonsterWatch::idle() const {
  std::vector<std::string> lines;
  for (const auto& [name, line] : idle_) lines.push_back(line);
  return lines;
}

// Returns whether the monster sees its enemy, a living player.
bool MonsterWatch::fights(server::Game& io_game, const server::Edict& monster) const {
  server::GameWorld& world = io_game.world();
  const vm::EntityIndex enemy = monster[field::kEnemy];
  if (!world.edicts.is_client(enemy)) return false;
  const server::Edict player = world.edicts[enemy];
  if (player[field::kHealth] <= 0) return false;
  return can_see(world, monster.index(), monster[field::kOrigin] + monster[field::kViewOffset],
                 player[field::kOrigin] + player[field::kViewOffset]);
}

// Returns whether its animation plays only once, such as an attack or pain. Those of standing and running
// repeat. Reads fields of the shipped game code; with other game code, this is always false.
bool MonsterWatch::plays_action(server::Game& io_game, const server::Edict& monster) const {
  const vm::FunctionIndex end = fields_.function(monster, "seq_end");
  return end != vm::kNoFunction && io_game.machine().program().function_name(end) != "play_again";
}

void MonsterWatch::look(server::Game& io_game, double now_s) {
  server::GameWorld& world = io_game.world();
  for (std::uint32_t i = 1 + world.edicts.client_count(); i < world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (world.edicts.is_free(entity)) continue;
    const server::Edict edict = world.edicts[entity];
    if (!edict.has_flag(server::flag::kMonster) || edict[field::kHealth] <= 0) continue;
    auto [found, is_new] = watched_.try_emplace(i);
    Watched& watched = found->second;
    const math::Vec3 at = edict[field::kOrigin];
    if (is_new) watched = {.name = describe(io_game, entity), .at = at, .since_s = now_s};
    // A zombie that was knocked down is not solid until it stands up again.
    if (edict.solid() == server::Solid::kNot) {
      watched.since_s = now_s;
      continue;
    }
    watched.stuck_looks = is_in_wall(world, edict) ? watched.stuck_looks + 1 : 0;
    if (watched.stuck_looks == kStuckLooks)
      stuck_.insert(fmt::format("{}, now at {:.0f} {:.0f} {:.0f}", watched.name, at.x, at.y, at.z));

    // A monster that changes its animation or attacks is not idle.
    watched.animations.insert(fields_.number(edict, "seq_first"));
    watched.attack_times.insert(fields_.number(edict, "attack_finished"));
    if (glm::distance(math::Vec2(at), math::Vec2(watched.at)) > kMoved_units ||
        watched.animations.size() > 1 || watched.attack_times.size() > 1 ||
        edict[field::kHealth] != watched.health || plays_action(io_game, edict) || is_at_the_bottom(edict) ||
        !fights(io_game, edict)) {
      watched.at = at;
      watched.health = edict[field::kHealth];
      watched.since_s = now_s;
      watched.animations = {fields_.number(edict, "seq_first")};
      watched.attack_times = {fields_.number(edict, "attack_finished")};
    } else if (now_s - watched.since_s > kIdle_s) {
      const math::Vec3 enemy = world.edicts.at(edict[field::kEnemy])[field::kOrigin];
      idle_.try_emplace(
          watched.name,
          fmt::format("{}: stands at {:.0f} {:.0f} {:.0f} and sees its enemy at {:.0f} {:.0f} {:.0f}",
                      watched.name, at.x, at.y, at.z, enemy.x, enemy.y, enemy.z));
      // Report each monster once.
      watched.since_s = now_s + 1e6;
    }
  }
}

}  // namespace temblor::player
