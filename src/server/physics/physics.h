// One tick of all entities, and the built-in functions of QuakeC that move monsters.
// Each entity moves as its `movetype` says. The entities that it touches on the way, its think function, and
// a blocked door call QuakeC, which may change or remove any entity, so nothing is remembered across such a
// call:
//    StartFrame
//    for each entity, in order of number:
//      player         PreThink -> think -> walk, swim, fly -> touch triggers -> PostThink     player.cpp
//      kStep          fall -> think (which steps with walkmove and movetogoal)               monster_*.cpp
//      kToss ...      think -> gravity -> fly, bounce, splash                                thrown.cpp
//      kPush          move by ltime, carry what is on it or in its way -> think              pusher.cpp
//    time += tick
#pragma once

#include <span>

#include "base/result.h"
#include "movement/player.h"
#include "server/game/game_random.h"
#include "server/game/game_world.h"

namespace temblor::server {

// The input of a player's client in one tick.
struct PlayerCommand {
  math::Vec3 view_angles_deg{0.0f};
  float forward = 0, side = 0, up = 0;  // units per second
};

// The entity in the form that src/movement works with. teleport_time_s is relative to the world's time.
movement::Player make_player(const GameWorld& world, const Edict& edict);

// The player's own movement before physics (the original's client think): sets angles from the view, and adds
// the accelerations of walking, swimming and flying to `velocity`. Punch angles fade. The length of the tick
// is io_world.tick_s. Does not change the origin.
void move_player(GameWorld& io_world, vm::EntityIndex player, const PlayerCommand& command);

// The functions that the program has for every tick.
struct TickFunctions {
  vm::FunctionIndex start_frame{}, player_pre_think{}, player_post_think{};
};

// One tick of one player: the program's PreThink and PostThink, and its think and move between them. Part of
// run_physics(); called separately for a player who has more than one move to catch up on.
base::Status run_player(GameWorld& io_world, vm::EntityIndex player, const TickFunctions& functions);

// Plays one tick of everything that moves, in order of number. `active_players` is by slot (entity number -
// 1); other players stand still. `io_force_retouch` is the word of the global of that name: while its value
// is above 0, every entity touches the triggers that it is in, and it counts down; QuakeC may set it
// meanwhile. New entities take part in the tick in which they are made. Advances io_world.time_s last, and
// adds sounds to io_world.sounds. Fails if QuakeC does.
base::Status run_physics(GameWorld& io_world, const TickFunctions& functions,
                         std::span<const bool> active_players, std::uint32_t& io_force_retouch);

// --- Built-in functions that are physics.

// Moves a monster by this step if it can stand there. Fliers and swimmers need no floor, and also come nearer
// to their enemy's height. With kYes the monster is linked there and touches triggers; with kNo only its
// origin has changed. false: it could not move.
base::Result<bool> step_monster(GameWorld& io_world, vm::EntityIndex monster, const math::Vec3& step,
                                TouchTriggers touch);
// A step in this direction. Also false if the monster neither stands, flies nor swims.
base::Result<bool> walk_move(GameWorld& io_world, vm::EntityIndex monster, float yaw_deg, float distance);
// Takes a step toward goalentity, or around what is in the way: mostly straight on, else in one of eight
// directions. Does nothing if its enemy is within reach already, or if it neither stands, flies nor swims.
// `distance` is the length of the step.
base::Status move_to_goal(GameWorld& io_world, vm::EntityIndex monster, float distance,
                          GameRandom& io_random);
// Whether there is floor under all four corners of the box, at most a step deeper than under its middle.
bool check_bottom(GameWorld& io_world, vm::EntityIndex monster);
// Turns toward ideal_yaw, by at most yaw_speed degrees.
void change_yaw(GameWorld& io_world, vm::EntityIndex monster);
// Moves the entity down to the floor, by at most 256 units. false: there is no floor, and it did not move.
base::Result<bool> drop_to_floor(GameWorld& io_world, vm::EntityIndex entity);

}  // namespace temblor::server
