// Built-in functions that read the state of the game: stats, players, and rules.
#include <algorithm>
#include <bit>
#include <numeric>

#include "client/hud_program/program_call.h"

namespace temblor::client {
namespace {

// Stats that travel in other messages, with their numbers in HUD programs.
constexpr int kItems = 15, kViewHeight = 16, kTime = 17;

bool is_stat(int stat) {
  return stat >= 0 && stat < net::kStats;
}

// The stat as an integer; its fraction is cut off.
std::int32_t whole_stat(const Game& game, int stat) {
  if (stat == kItems) return std::bit_cast<std::int32_t>(game.data.items);
  return builtins::to_whole(stat_number(game, stat));
}

// getstati(stat): a raw integer, which newer compilers know as a type.
base::Status getstati(ProgramCall& io_call) {
  const int stat = io_call.whole(0);
  const std::int32_t value = !is_stat(stat) ? 0
                             : io_call.game().game_stats.contains(static_cast<std::uint8_t>(stat))
                                 ? whole_stat(io_call.game(), stat)
                             : stat == kItems || stat == kViewHeight || stat == kTime
                                 ? whole_stat(io_call.game(), stat)
                                 : io_call.game().stats[static_cast<std::size_t>(stat)];
  io_call.machine.return_float(std::bit_cast<float>(value));
  return base::Ok{};
}

// getstatf(stat, first_bit, bits): a number, or a few bits of an integer.
base::Status getstatf(ProgramCall& io_call) {
  const int stat = io_call.whole(0);
  if (!is_stat(stat)) return io_call.return_number(0);
  if (io_call.count() < 2) return io_call.return_number(stat_number(io_call.game(), stat));
  const int first = std::clamp(io_call.whole(1), 0, 31);
  const int bits = std::clamp(io_call.count() > 2 ? io_call.whole(2) : 1, 1, 24);
  const auto word = static_cast<std::uint32_t>(whole_stat(io_call.game(), stat));
  return io_call.return_number((word >> first) & ((1u << bits) - 1));
}

// getstats(stat): a text; numbers are converted.
base::Status getstats(ProgramCall& io_call) {
  const int stat = io_call.whole(0);
  if (!is_stat(stat)) return io_call.return_text("");
  const auto found = io_call.game().game_stats.find(static_cast<std::uint8_t>(stat));
  if (found != io_call.game().game_stats.end())
    if (const auto* text = std::get_if<std::string>(&found->second)) return io_call.return_text(*text);
  return io_call.return_text(fmt::format("{}", stat_number(io_call.game(), stat)));
}

// The player of a slot, or by rank: -1 has the most frags. Null if there is none.
const Player* find_player(const Game& game, int number) {
  std::vector<const Player*> players;
  for (const Player& player : game.players)
    if (number >= 0 || !player.name.empty()) players.push_back(&player);
  if (number < 0)
    std::stable_sort(players.begin(), players.end(),
                     [](const Player* a, const Player* b) { return a->frags > b->frags; });
  const auto place = static_cast<std::size_t>(number < 0 ? -(number + 1) : number);
  return place < players.size() && !players[place]->name.empty() ? players[place] : nullptr;
}

std::string find_player_value(const Game& game, const Player& player, std::string_view key) {
  const auto slot = static_cast<int>(&player - game.players.data());
  if (key == "name") return player.name;
  if (key == "frags") return fmt::format("{}", player.frags);
  if (key == "topcolor") return fmt::format("{}", player.shirt);
  if (key == "bottomcolor" || key == "team") return fmt::format("{}", player.pants);
  if (key == "viewentity") return fmt::format("{}", slot + 1);
  if (key == "userid") return fmt::format("{}", slot);
  if (key == "ping") return fmt::format("{}", player.ping_ms);
  if (key == "pl") return "0";  // lost packets are not sent in the protocol
  return "";
}

// Pings arrive only on request.
std::string player_value(ProgramCall& io_call, const Player* player, std::string_view key) {
  if (key == "ping") io_call.program.wants_pings = true;
  return player == nullptr ? "" : find_player_value(io_call.game(), *player, key);
}

// getplayerkeyvalue(player, key): empty for a slot without a player.
base::Status getplayerkeyvalue(ProgramCall& io_call) {
  const Player* const player = find_player(io_call.game(), io_call.whole(0));
  return io_call.return_text(player_value(io_call, player, io_call.text(1)));
}
base::Status getplayerkeyfloat(ProgramCall& io_call) {
  const Player* const player = find_player(io_call.game(), io_call.whole(0));
  const std::string value = player_value(io_call, player, io_call.text(1));
  return io_call.return_number(std::strtod(value.c_str(), nullptr));
}

std::string rule(const ProgramCall& call, std::string_view key) {
  const Game& game = call.game();
  const std::string level = game.models.size() > 1 ? game.models[1] : "";
  if (key == "deathmatch") return game.deathmatch ? "1" : "0";
  if (key == "maxclients") return fmt::format("{}", game.players.size());
  if (key == "levelname") return game.level_name;
  if (key == "constate") return "active";
  if (key == "protocol") return fmt::format("{}", static_cast<int>(game.dialect.protocol));
  if (key == "mapname" && level.starts_with("maps/") && level.ends_with(".bsp"))
    return level.substr(5, level.size() - 9);
  return "";
}

// serverkey(key): deathmatch, mapname, levelname, maxclients, protocol, or constate.
base::Status serverkey(ProgramCall& io_call) {
  return io_call.return_text(rule(io_call, io_call.text(0)));
}
base::Status serverkeyfloat(ProgramCall& io_call) {
  return io_call.return_number(std::strtod(rule(io_call, io_call.text(0)).c_str(), nullptr));
}

// infokey(entity, key): the world's keys are the server's, a player's are those of getplayerkeyvalue().
base::Status infokey(ProgramCall& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  if (entity == vm::kWorld) return io_call.return_text(rule(io_call, io_call.text(1)));
  const Player* const player = find_player(io_call.game(), static_cast<int>(base::to_size(entity)) - 1);
  return io_call.return_text(player_value(io_call, player, io_call.text(1)));
}

base::Status isdemo(ProgramCall& io_call) {
  return io_call.return_number(io_call.program.moment.is_demo ? 1 : 0);
}
base::Status isserver(ProgramCall& io_call) {
  return io_call.return_number(io_call.program.moment.is_own_server ? 1 : 0);
}

// modelnameforindex(number): as the server has named it.
base::Status modelnameforindex(ProgramCall& io_call) {
  const std::vector<std::string>& models = io_call.game().models;
  const int number = io_call.whole(0);
  const bool is_there = number >= 0 && static_cast<std::size_t>(number) < models.size();
  return io_call.return_text(is_there ? models[static_cast<std::size_t>(number)] : "");
}

}  // namespace

float stat_number(const Game& game, int stat) {
  if (stat == kItems) return static_cast<float>(game.data.items);
  if (stat == kViewHeight) return game.data.view_height;
  const auto found = game.game_stats.find(static_cast<std::uint8_t>(stat));
  if (found == game.game_stats.end()) return static_cast<float>(game.stats[static_cast<std::size_t>(stat)]);
  const auto* const number = std::get_if<float>(&found->second);
  return number != nullptr ? *number : std::strtof(std::get<std::string>(found->second).c_str(), nullptr);
}

std::span<const ProgramEntry> program_state() {
  static constexpr ProgramEntry kEntries[] = {
      {80, "infokey", infokey},
      {330, "getstati", getstati},
      {331, "getstatf", getstatf},
      {332, "getstats", getstats},
      {334, "modelnameforindex", modelnameforindex},
      {348, "getplayerkeyvalue", getplayerkeyvalue},
      {0, "getplayerkeyfloat", getplayerkeyfloat},
      {349, "isdemo", isdemo},
      {350, "isserver", isserver},
      {354, "serverkey", serverkey},
      {0, "serverkeyfloat", serverkeyfloat},
  };
  return kEntries;
}

}  // namespace temblor::client
