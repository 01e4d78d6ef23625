// Hashes of a game's state after a tick, to see whether two peers still play the same game, and which entity
// differs first if they do not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/game.h"

namespace temblor::lockstep {

struct GameHashes {
  std::uint64_t state = 0;              // server::Game::state_hash()
  std::vector<std::uint32_t> entities;  // of each entity's fields, by number

  // The 32 bits of `state` that peers exchange.
  std::uint32_t short_hash() const { return static_cast<std::uint32_t>(state); }
};

// Reuses the memory of `io_hashes`.
void hash_game(const server::Game& game, GameHashes& io_hashes);

// The number of the first entity that differs, also if one game lacks it. Nothing if all are the same.
std::optional<std::uint32_t> find_first_difference(const std::vector<std::uint32_t>& a,
                                                   const std::vector<std::uint32_t>& b);

// "entity 57 (monster_ogre at 64 -128 24)", or "entity 57 (free)".
std::string describe_entity(server::Game& io_game, std::uint32_t number);

}  // namespace temblor::lockstep
