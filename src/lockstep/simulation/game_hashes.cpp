#include "lockstep/simulation/game_hashes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::lockstep {

void hash_game(const server::Game& game, GameHashes& io_hashes) {
  io_hashes.state = game.state_hash(&io_hashes.entities);
}

std::optional<std::uint32_t> find_first_difference(const std::vector<std::uint32_t>& a,
                                                   const std::vector<std::uint32_t>& b) {
  const auto [at, unused] = std::ranges::mismatch(a, b);
  const auto number = static_cast<std::uint32_t>(at - a.begin());
  if (at == a.end() && a.size() == b.size()) return std::nullopt;
  return number;
}

std::string describe_entity(server::Game& io_game, std::uint32_t number) {
  const vm::EntityIndex index{number};
  server::Edicts& edicts = io_game.world().edicts;
  if (number >= edicts.count() || edicts.is_free(index)) return fmt::format("entity {} (free)", number);
  const server::Edict entity = edicts[index];
  const math::Vec3 origin = entity[server::field::kOrigin];
  return fmt::format("entity {} ({} at {:.0f} {:.0f} {:.0f})", number,
                     base::printable(io_game.machine().text(entity[server::field::kClassName])), origin.x,
                     origin.y, origin.z);
}

}  // namespace temblor::lockstep
