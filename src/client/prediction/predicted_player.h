// One step of a player as a client sees it coming: what the server will make of a move, without its program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "movement/player.h"
#include "net/protocol/client_message.h"
#include "net/protocol/numbered_moves.h"
#include "world/trace.h"

namespace temblor::client {

// A brush model that stops players: a door, a lift.
struct SolidModel {
  std::uint32_t entity = 0;
  world::ModelIndex model{};
  math::Vec3 origin{0.0f};
};

struct PredictionWorld {
  const world::Level& level;
  std::span<const SolidModel> solids;  // in order of entity
  movement::Settings settings{};
  float eyes_z = 22;  // above the player's origin
};

struct PredictedPlayer {
  movement::Player player;
  bool is_jump_released = true;
  float swim_up_speed = 100;  // who wants to jump under water
  float own_gravity = 1;
  // What he stood on when the server last told of him, and how it goes on. Its model is among the solids,
  // whose origin does not count then.
  std::uint32_t ride_entity = 0;
  std::optional<net::MoveAcknowledgement::Ride> ride{};
};

// As the server has told.
PredictedPlayer predicted_from(const net::MoveAcknowledgement& told);
// Whether a client can know how he goes on: who lives and walks, flies or goes through walls.
bool is_predictable(const PredictedPlayer& predicted);
// As far as he gets by that move in `duration_s`, a tick or a part of one. For whom is_predictable(). Returns
// what it took: one for each trace through the level or a model, and for each 128 models that were passed
// over.
std::size_t step(PredictedPlayer& io_predicted, const net::Move& move, double duration_s,
                 const PredictionWorld& world);

movement::Settings settings_of(const net::MoveParameters& terms);

}  // namespace temblor::client
