// Clients whose hands are the program itself (DP_SV_BOTCLIENT, DP_SV_DROPCLIENT).
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// A client of the program's own, put into the game as one that joins; the world, where no place is free.
base::Status spawnclient(Call& io_call) {
  if (!io_call.game.places.spawn_bot) return io_call.error("this server has no bots");
  TRY(const vm::EntityIndex bot, io_call.game.places.spawn_bot());
  io_call.machine.return_entity(bot);
  return base::Ok{};
}

base::Status dropclient(Call& io_call) {
  TRY(const vm::EntityIndex player, io_call.player(0));
  if (!io_call.game.places.drop) return io_call.error("this server has no bots");
  return io_call.game.places.drop(base::to_size(player) - 1);
}

base::Status clienttype(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  const auto& type_of = io_call.game.places.type_of;
  const bool is_place = io_call.is_player(entity) && type_of;
  const PlayerType type = is_place ? type_of(base::to_size(entity) - 1) : PlayerType::kNoPlace;
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
