// Built-in functions for bots: clients that QuakeC plays (DP_SV_BOTCLIENT, DP_SV_DROPCLIENT).
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// spawnclient(): puts a bot into the game, as if it had joined. Returns the world if no slot is free.
base::Status spawnclient(Call& io_call) {
  if (!io_call.game.bot_services.spawn_bot) return io_call.error("this server has no bots");
  TRY(const vm::EntityIndex bot, io_call.game.bot_services.spawn_bot());
  io_call.machine.return_entity(bot);
  return base::Ok{};
}

// dropclient(player): disconnects a person, or removes a bot.
base::Status dropclient(Call& io_call) {
  TRY(const vm::EntityIndex player, io_call.player(0));
  if (!io_call.game.bot_services.drop) return io_call.error("this server has no bots");
  return io_call.game.bot_services.drop(base::to_size(player) - 1);
}

// clienttype(entity): a PlayerType.
base::Status clienttype(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  const auto& player_type = io_call.game.bot_services.player_type;
  const bool is_slot = io_call.is_player(entity) && player_type;
  const PlayerType type = is_slot ? player_type(base::to_size(entity) - 1) : PlayerType::kNotASlot;
  io_call.machine.return_float(static_cast<float>(type));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> bot_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {453, "dropclient", dropclient},
      {454, "spawnclient", spawnclient},
      {455, "clienttype", clienttype},
  };
  return kEntries;
}

}  // namespace temblor::server
