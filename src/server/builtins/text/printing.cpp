// Built-in functions that print to players and to the server's console. Several texts are joined. Clients get
// keys of localized texts as text, because stock clients do not know the keys.
#include "server/builtins/families.h"
#include "server/builtins/text/player_text.h"

namespace temblor::server {
namespace {

base::Status bprint(Call& io_call) {
  Outbox& outbox = io_call.game.outbox;
  write_text<net::Print>(io_call.localized_text(0), outbox, outbox.reliable());
  return base::Ok{};
}

base::Status sprint(Call& io_call) {
  TRY(base::ByteWriter* const writer, player_buffer(io_call));
  if (writer != nullptr) write_text<net::Print>(io_call.localized_text(1), io_call.game.outbox, *writer);
  return base::Ok{};
}

base::Status centerprint(Call& io_call) {
  TRY(base::ByteWriter* const writer, player_buffer(io_call));
  if (writer != nullptr) write_center_text(io_call.localized_text(1), io_call.game.outbox, *writer);
  return base::Ok{};
}

// dprint(): shown only to developers.
base::Status dprint(Call& io_call) {
  if (io_call.variable("developer") != 0) io_call.print(io_call.joined_text(0));
  return base::Ok{};
}

// stuffcmd(): runs a command in a player's own console.
base::Status stuffcmd(Call& io_call) {
  TRY(const vm::EntityIndex player, io_call.player(0));
  Outbox& outbox = io_call.game.outbox;
  write_text<net::StuffText>(io_call.joined_text(1), outbox, *outbox.reliable_to(player));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> printing_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {21, "stuffcmd", stuffcmd}, {23, "bprint", bprint},           {24, "sprint", sprint},
      {25, "dprint", dprint},     {73, "centerprint", centerprint},
  };
  return kEntries;
}

}  // namespace temblor::server
