// One tick of all entities.
#pragma once

#include <span>

#include "base/result.h"
#include "movement/player.h"
#include "server/game/game_random.h"
#include "server/game_world.h"

namespace temblor::server {

// What a player's client asked for, of one tick.
struct PlayerCommand {
  math::Vec3 view_angles_deg{0.0f};
  float forward = 0, side = 0, up = 0;  // units a second
};

// A player as what moves him sees him; teleport_time_s is of the world's time.
movement::Player player_of(const GameWorld& world, const Edict& edict);

// The player's own movement before physics: angles, accelerations of walking, swimming and flying into
// `velocity` (the original's client think). Punch angles fade. `io_world.tick_s` long.
void move_player(GameWorld& io_world, vm::EntityIndex player, const PlayerCommand& command);

// The functions that the program has for every tick.
struct TickFunctions {
  vm::FunctionIndex start_frame{}, player_pre_think{}, player_post_think{};
};

// A tick of one player: the program's functions around his think and move. Part of run_physics(); by itself
// for who has more than one move to catch up on.
base::Status run_player(GameWorld& io_world, vm::EntityIndex player, const TickFunctions& functions);

// Everything that moves, in order of number; `active_players` by slot (entity number - 1). `io_force_retouch`
// is the word of the global of that name: while its value is above 0 everything touches what it is in, and it
// counts down; the program may set it meanwhile. New entities take part in the tick that they are made in.
// Advances io_world.time_s last. Sounds are added to io_world.sounds. An error is the program's.
base::Status run_physics(GameWorld& io_world, const TickFunctions& functions,
                         std::span<const bool> active_players, std::uint32_t& io_force_retouch);

// --- Built-in functions that are physics.

// Moves a monster by that step if it can stand there (or, of fliers and swimmers, be there: these also come
// nearer to their enemy's height). With kYes it is linked there and touches triggers; with kNo only its
// origin has changed. false: it stays.
base::Result<bool> step_monster(GameWorld& io_world, vm::EntityIndex monster, const math::Vec3& step,
                                TouchTriggers touch);
// The step of that length; false also for who neither stands, flies nor swims.
base::Result<bool> walk_move(GameWorld& io_world, vm::EntityIndex monster, float yaw_deg, float distance);
// A step towards its goalentity, or around what is in the way: straight on mostly, else in one of eight
// directions. Nothing where its enemy is within reach already, or where it neither stands, flies nor swims.
base::Status move_to_goal(GameWorld& io_world, vm::EntityIndex monster, float distance,
                          GameRandom& io_random);
// Whether there is floor under all four corners, at most a step deeper than under the middle.
bool check_bottom(GameWorld& io_world, vm::EntityIndex monster);
// Turns towards ideal_yaw, at most by yaw_speed.
void change_yaw(GameWorld& io_world, vm::EntityIndex monster);
// Down at most 256 units; false where there is no floor.
base::Result<bool> drop_to_floor(GameWorld& io_world, vm::EntityIndex entity);

}  // namespace temblor::server
