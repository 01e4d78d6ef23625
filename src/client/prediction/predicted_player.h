// Simulates one move of a player on the client, as the server will, but without its game program.
//
// The order is that of a server tick (server/physics/player.cpp): crouching, acceleration, the program before
// the move (of which the client knows what the stock one does: jumping), the move, then movers and the
// players on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "movement/player.h"
#include "net/protocol/client_message.h"
#include "net/protocol/numbered_moves.h"
#include "world/trace.h"
#include "world/visibility.h"

namespace temblor::client {

// A brush model that blocks players: a door, a lift. It stands where the last packet put it.
struct SolidModel {
  std::uint32_t entity = 0;
  world::ModelIndex model{};
  math::Vec3 origin{0.0f};
};

// The surroundings of a prediction, constant during a step.
struct PredictionWorld {
  const world::Level& level;
  std::span<const SolidModel> solids;  // sorted by entity
  math::PhysicsSettings settings{};
  std::span<const world::PlacedLiquid> liquids{};
};

// The state that a move starts from and changes. Server and client must agree on all of it.
struct PredictedPlayer {
  movement::Player player;
  // The eyes' height above the player's origin, units. Only crouching changes it.
  float eyes_z = 22;
  bool is_jump_released = true;
  // Units per second while jump is held under water; depends on the liquid.
  float swim_up_speed = 100;
  // A factor on the world's gravity.
  float own_gravity = 1;
  // The mover under the player as of the last acknowledgment, and its further motion. Its model is among the
  // solids; the solid's own origin is ignored.
  std::uint32_t ride_entity = 0;
  std::optional<net::MoveAcknowledgment::Ride> ride{};
};

// Returns the player as the server acknowledged it: the state right after a move.
PredictedPlayer make_predicted_player(const net::MoveAcknowledgment& acknowledged);
// Whether the client can predict the player: alive, and walking, flying or without clipping. Anything else is
// moved by game code.
bool is_predictable(const PredictedPlayer& predicted);
// Simulates a move for `duration_s`, a tick or a part of one. is_predictable() must hold. Returns the effort:
// one for each trace through the level or a model, and one for each 128 models that were skipped.
std::size_t step(PredictedPlayer& io_predicted, const net::Move& move, double duration_s,
                 const PredictionWorld& world);

}  // namespace temblor::client
