// Built-in functions of the 2021 re-release. Its programs declare them with number 0 and a name. Functions
// that this server cannot provide return an answer with which programs can go on.
#include <algorithm>
#include <charconv>

#include "server/builtins/families.h"
#include "server/builtins/text/player_text.h"

namespace temblor::server {
namespace {

// Replaces {0} in the text of parameter `first` by the text after it, {1} by the next one, and so on. If the
// text has no such marks, the other texts are appended, as in stock functions.
std::string filled_text(const Call& call, int first) {
  if (first >= call.machine.parameter_count()) return "";
  std::string_view text = call.text(first);
  if (text.find('{') == std::string_view::npos) return call.joined_text(first);
  std::string filled;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    filled += text.substr(0, open);
    text.remove_prefix(open);
    if (text.empty()) break;
    int number = -1;
    const char* const end = text.data() + text.size();
    const auto [close, error] = std::from_chars(text.data() + 1, end, number);
    const bool is_place = error == std::errc{} && close != end && *close == '}' && number >= 0 &&
                          number < call.machine.parameter_count() - first - 1;
    if (is_place) filled += call.text(first + 1 + number);
    if (!is_place) filled += '{';
    text.remove_prefix(is_place ? static_cast<std::size_t>(close + 1 - text.data()) : 1);
  }
  return filled;
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

// The answers are constant: the server does not know whether a player has read a closing text, has no special
// flags for players, and no map of paths for bots (game code then finds its own way).
base::Status none(Call& io_call) {
  io_call.machine.return_float(0);
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> rerelease_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {0, "ex_bprint", ex_bprint},           {0, "ex_sprint", ex_sprint},
      {0, "ex_centerprint", ex_centerprint}, {0, "ex_localsound", ex_localsound},
      {0, "ex_finaleFinished", none},        {0, "ex_CheckPlayerEXFlags", none},
      {0, "ex_walkpathtogoal", none},
  };
  return kEntries;
}

}  // namespace temblor::server
