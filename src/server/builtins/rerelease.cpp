// Functions that programs of the 2021 re-release declare with number 0 and a name. What they ask for and this
// server does not have is answered so that their programs do without it.
#include <algorithm>
#include <charconv>

#include "server/builtins/families.h"
#include "server/builtins/text/player_text.h"

namespace temblor::server {
namespace {

// The text of parameter `first`, in which {0} stands for the text behind it, {1} for the next and so on. One
// without such places is followed by the others, as stock functions have it.
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

base::Status ex_bprint(Call& io_call) {
  Outbox& outbox = io_call.game.outbox;
  write_text<net::Print>(filled_text(io_call, 0), outbox, outbox.reliable());
  return base::Ok{};
}

base::Status ex_sprint(Call& io_call) {
  TRY(base::ByteWriter* const writer, listener(io_call));
  if (writer != nullptr) write_text<net::Print>(filled_text(io_call, 1), io_call.game.outbox, *writer);
  return base::Ok{};
}

base::Status ex_centerprint(Call& io_call) {
  TRY(base::ByteWriter* const writer, listener(io_call));
  if (writer != nullptr) write_center_text(filled_text(io_call, 1), io_call.game.outbox, *writer);
  return base::Ok{};
}

// ex_localsound(player, sample): at full volume, wherever he is, and for him alone.
base::Status ex_localsound(Call& io_call) {
  TRY(base::ByteWriter* const writer, listener(io_call));
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

// Whether a closing text was read to its end (nobody tells the server), a player's special flags (there are
// none), a step on a map of ways (there is none; the program then walks by itself).
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
