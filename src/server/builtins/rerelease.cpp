// Built-in functions of the 2021 re-release, except those that draw (debug_drawing.cpp). Its programs declare
// them with number 0 and a name. Functions that this server cannot provide return an answer with which
// programs can go on.
#include <span>
#include <string>
#include <vector>

#include "server/builtins/families.h"
#include "server/builtins/text/player_text.h"

namespace temblor::server {
namespace {

// Like localized_text(), but places are filled in a text that is no key, too.
std::string filled_text(const Call& call, int first) {
  const std::vector<std::string> texts = call.localized_texts(first);
  if (texts.empty() || texts[0].find('{') == std::string::npos) return call.localized_text(first);
  return formats::fill_places(texts[0], std::span(texts).subspan(1));
}

// ex_bprint(text, ...): prints to all players.
base::Status ex_bprint(Call& io_call) {
  Outbox& outbox = io_call.game.outbox;
  write_text<net::Print>(filled_text(io_call, 0), outbox, outbox.reliable());
  return base::Ok{};
}

// ex_sprint(player, text, ...)
base::Status ex_sprint(Call& io_call) {
  TRY(base::ByteWriter* const writer, player_buffer(io_call));
  if (writer != nullptr) write_text<net::Print>(filled_text(io_call, 1), io_call.game.outbox, *writer);
  return base::Ok{};
}

// ex_centerprint(player, text, ...)
base::Status ex_centerprint(Call& io_call) {
  TRY(base::ByteWriter* const writer, player_buffer(io_call));
  if (writer != nullptr) write_center_text(filled_text(io_call, 1), io_call.game.outbox, *writer);
  return base::Ok{};
}

// ex_localsound(player, sample): plays a sound at full volume, for this player alone.
base::Status ex_localsound(Call& io_call) {
  TRY(base::ByteWriter* const writer, player_buffer(io_call));
  const std::optional<std::uint16_t> number = io_call.sound_number(io_call.text(1));
  if (writer == nullptr || !number) return base::Ok{};
  TRY(const vm::EntityIndex player, io_call.player(0));
  io_call.game.outbox.write(net::Sound{.attenuation = 0,
                                       .entity = static_cast<std::uint16_t>(player),
                                       .channel = 0,
                                       .sound = *number,
                                       .origin = io_call.world.edicts[player][field::kOrigin]},
                            *writer);
  return base::Ok{};
}

// ex_finaleFinished(): 1 when clients have written all letters of the closing text; 0 if there is none.
base::Status ex_finale_finished(Call& io_call) {
  constexpr double kLettersPerSecond = 8;  // of stock clients
  const std::optional<ClosingText>& text = io_call.game.closing_text;
  const bool is_finished =
      text && io_call.world.time_s >= text->since_s + static_cast<double>(text->letters) / kLettersPerSecond;
  io_call.machine.return_float(is_finished ? 1 : 0);
  return base::Ok{};
}

// The answers are constant: there are no special flags for players, and no map of paths for bots (game code
// then finds its own way).
base::Status none(Call& io_call) {
  io_call.machine.return_float(0);
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> rerelease_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {0, "ex_bprint", ex_bprint},
      {0, "ex_sprint", ex_sprint},
      {0, "ex_centerprint", ex_centerprint},
      {0, "ex_localsound", ex_localsound},
      {0, "ex_finaleFinished", ex_finale_finished},
      {0, "ex_CheckPlayerEXFlags", none},
      {0, "ex_walkpathtogoal", none},
      {0, "ex_bot_movetopoint", none},
      {0, "ex_bot_followentity", none},
  };
  return kEntries;
}

}  // namespace temblor::server
