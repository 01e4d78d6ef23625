#include "server/commands/player_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/text.h"
#include "command/text.h"
#include "server/commands/give.h"
#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

constexpr std::size_t kMaxSayChars = 200;
constexpr int kMaxColor = 13;  // of shirts and pants in stock clients
// Beyond the largest level that any format can hold.
constexpr double kMaxPlace_units = 1 << 20;

using Words = std::span<const std::string>;

// The player who gave the command, and its words.
struct Caller {
  Server& server;
  std::size_t slot;
  std::string_view line;  // the whole command, without a newline
  Words words;            // the command's name first

  Client& client() const { return server.clients[slot]; }
  Edict edict() const { return server.game->player(slot); }
  void print(std::string_view text) const { server.clients.print(slot, text); }
  // Everything after the command's name, without quotes around it.
  std::string_view rest() const {
    std::string_view text = line.substr(std::min(words[0].size(), line.size()));
    while (text.starts_with(' ')) text.remove_prefix(1);
    if (text.size() >= 2 && text.starts_with('"') && text.ends_with('"'))
      text = text.substr(1, text.size() - 2);
    return text;
  }
};

// Removes characters that would begin another line, or color this one like the server's.
std::string to_one_line(std::string_view text) {
  std::string line(text);
  std::erase_if(line, [](char c) { return static_cast<unsigned char>(c) < 32; });
  return line;
}

// Without a name, shows the current one, like a console variable.
void name_command(const Caller& caller) {
  if (caller.words.size() < 2) return caller.print(fmt::format("\"name\" is \"{}\"\n", caller.client().name));
  set_player_name(caller.server, caller.slot, presentable_name(caller.rest()));
}

// One number sets both colors.
void color_command(const Caller& caller) {
  const auto parse_color = [&](std::size_t i) {
    const std::optional<std::int64_t> number = command::parse_whole_number(caller.words[i]);
    return number ? std::optional(std::clamp<std::int64_t>(*number, 0, kMaxColor)) : std::nullopt;
  };
  const std::size_t words = caller.words.size();
  const auto shirt = words > 1 ? parse_color(1) : std::nullopt, pants = words > 2 ? parse_color(2) : shirt;
  if (!shirt || !pants) return caller.print(fmt::format("Usage: color SHIRT [PANTS], 0 to {}\n", kMaxColor));
  Client& client = caller.client();
  client.colors = static_cast<std::uint8_t>(*shirt << 4 | *pants);
  if (client.is_in_game() &&
      !caller.server.game->set_player_look(caller.slot, client.name, client.colors).ok())
    client.drop_reason = "there is no memory for its name";
  caller.server.clients.send_to_all(net::UpdateColors{static_cast<std::uint8_t>(caller.slot), client.colors});
}

// Talk to the team reaches those whose `team` is the same, as game code set it.
void say(const Caller& caller, bool to_team) {
  const std::string said = to_one_line(caller.rest().substr(0, kMaxSayChars));
  if (said.empty()) return;
  // A first character of 1 makes clients show the line as chat.
  const std::string text = to_team ? fmt::format("\1({}): {}\n", caller.client().name, said)
                                   : fmt::format("\1{}: {}\n", caller.client().name, said);
  const float team = caller.edict()[field::kTeam];
  for (std::size_t slot = 0; slot < caller.server.clients.size(); ++slot) {
    if (!caller.server.clients[slot].is_in_game()) continue;
    if (to_team && caller.server.game->player(slot)[field::kTeam] != team) continue;
    caller.server.clients.print(slot, text);
  }
  print_event(caller.server, text.substr(1));
}

void tell_command(const Caller& caller) {
  if (caller.words.size() < 3) return caller.print("Usage: tell NAME TEXT\n");
  for (std::size_t slot = 0; slot < caller.server.clients.size(); ++slot) {
    if (caller.server.clients[slot].is_free() || caller.server.clients[slot].name != caller.words[1])
      continue;
    const std::string_view said =
        caller.rest().substr(std::min(caller.words[1].size(), caller.rest().size()));
    caller.server.clients.print(
        slot, fmt::format("{}:{}\n", caller.client().name, to_one_line(said.substr(0, kMaxSayChars))));
    return;
  }
  caller.print(fmt::format("No player is named \"{}\"\n", caller.words[1]));
}

// In the format of stock servers, because players' tools parse it. Addresses are left out.
void status_command(const Caller& caller) {
  const Server& server = caller.server;
  caller.print(fmt::format("host:    {}\nmap:     {}\nplayers: {} active ({} max)\n\n",
                           server.settings().host_name(), caller.server.game->setup().map_name,
                           caller.server.clients.connected_count(), caller.server.clients.size()));
  for (std::size_t slot = 0; slot < caller.server.clients.size(); ++slot) {
    const Client& client = caller.server.clients[slot];
    if (client.is_free()) continue;
    const int seconds = static_cast<int>(server.clock.now_s - client.joined_at_s);
    caller.print(fmt::format("#{:<2} {:<16}  {:3}  {:2}:{:02}:{:02}\n", slot + 1, client.name,
                             client.sent_frags, seconds / 3600, seconds / 60 % 60, seconds % 60));
  }
}

void ping_command(const Caller& caller) {
  caller.print("Client ping times:\n");
  for (const Client& client : caller.server.clients.all())
    if (!client.is_free())
      caller.print(
          fmt::format("{:4} {}\n", static_cast<int>(std::lround(client.mean_ping_s() * 1000)), client.name));
}

void pause_command(const Caller& caller) {
  if (!caller.server.settings().is_pausable()) return caller.print("This server does not allow pausing.\n");
  set_paused(caller.server, !caller.server.clock.is_paused);
  caller.server.clients.print_to_all(fmt::format("{} {} the game\n", caller.client().name,
                                                 caller.server.clock.is_paused ? "paused" : "unpaused"));
}

void kill_command(const Caller& caller) {
  if (!(caller.edict()[field::kHealth] > 0)) return caller.print("You are already dead\n");
  if (const base::Status killed = caller.server.game->kill(caller.slot); !killed.ok())
    handle_game_failure(caller.server, killed.error());
}

void toggle_flag(const Caller& caller, int flag, std::string_view name) {
  const Edict edict = caller.edict();
  if (edict.has_flag(flag))
    edict.clear_flag(flag);
  else
    edict.set_flag(flag);
  caller.print(fmt::format("{} {}\n", name, edict.has_flag(flag) ? "ON" : "OFF"));
}

// A move type that game code has set in the meantime is not restored: off always means walking.
void toggle_move_type(const Caller& caller, MoveType type, std::string_view name) {
  const Edict edict = caller.edict();
  const bool is_on = edict.move_type() != type;
  edict.set(field::kMoveType, static_cast<float>(is_on ? type : MoveType::kWalk));
  caller.print(fmt::format("{} {}\n", name, is_on ? "ON" : "OFF"));
}

// "setpos X Y Z [PITCH YAW [ROLL]]", as other engines' players write it: flies there without clipping.
void setpos_command(const Caller& caller) {
  const Edict edict = caller.edict();
  if (caller.words.size() < 4) {
    const math::Vec3 at = edict[field::kOrigin], angles_deg = edict[field::kViewAngles];
    return caller.print(fmt::format("setpos {:.0f} {:.0f} {:.0f} {:.0f} {:.0f} {:.0f}\n", at.x, at.y, at.z,
                                    angles_deg.x, angles_deg.y, angles_deg.z));
  }
  std::array<float, 6> numbers{};
  const std::size_t count = std::min<std::size_t>(caller.words.size() - 1, numbers.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> number = command::parse_number(caller.words[i + 1]);
    if (!number || std::abs(*number) > kMaxPlace_units)
      return caller.print("Usage: setpos X Y Z [PITCH YAW [ROLL]]\n");
    numbers[i] = static_cast<float>(*number);
  }
  edict.set(field::kMoveType, static_cast<float>(MoveType::kNoClip));
  edict.set(field::kVelocity, math::Vec3(0.0f));
  edict.set(field::kOrigin, math::Vec3(numbers[0], numbers[1], numbers[2]));
  if (count > 3) {
    edict.set(field::kAngles, math::Vec3(numbers[3], numbers[4], numbers[5]));
    edict.set(field::kFixAngle, 1.0f);
  }
  if (const base::Status linked = link(caller.server.game->world(),
                                       caller.server.game->player_index(caller.slot), TouchTriggers::kNo);
      !linked.ok())
    handle_game_failure(caller.server, linked.error());
}

void give_command(const Caller& caller) {
  caller.print(give(*caller.server.game, caller.slot, caller.words));
}

// The text after its first word, which may be in quotes.
std::string_view skip_first_word(std::string_view text) {
  const bool is_quoted = text.starts_with('"');
  const std::size_t end = text.find(is_quoted ? '"' : ' ', 1);
  text.remove_prefix(std::min(end, text.size() - 1) + 1);
  while (text.starts_with(' ')) text.remove_prefix(1);
  return text;
}

// "rcon PASSWORD COMMAND": runs a command on the host's console. The endpoint limits how often an address may
// try.
void rcon_command(const Caller& caller) {
  Server& server = caller.server;
  const std::optional<platform::Address> from = server.endpoint.peer_address(caller.client().connection);
  const bool is_right = from && caller.words.size() > 2 &&
                        server.endpoint.admit_remote_command(*from, caller.words[1], server.clock.now_s);
  if (!is_right) {
    print(server,
          fmt::format("{} ({}) gave a wrong rcon password\n", caller.client().name, caller.client().address));
    return caller.print("Wrong rcon password\n");
  }
  const std::string line(skip_first_word(skip_first_word(caller.line)));
  print(server, fmt::format("rcon from {}: {}\n", caller.client().name, line));
  caller.print(run_and_capture(server, line));
}

// A row of the table of commands.
struct PlayerCommandEntry {
  std::string_view name;
  void (*run)(const Caller& caller);
  bool is_cheat = false;
  bool needs_game = true;  // only for players who are in the game
};

constexpr std::array kCommands = {
    PlayerCommandEntry{"name", name_command, false, false},
    PlayerCommandEntry{"color", color_command, false, false},
    PlayerCommandEntry{"say", [](const Caller& caller) { say(caller, false); }},
    PlayerCommandEntry{"say_team", [](const Caller& caller) { say(caller, true); }},
    PlayerCommandEntry{"tell", tell_command},
    PlayerCommandEntry{"status", status_command},
    PlayerCommandEntry{"ping", ping_command},
    PlayerCommandEntry{"pause", pause_command},
    PlayerCommandEntry{"kill", kill_command},
    PlayerCommandEntry{"rcon", rcon_command, false, false},
    PlayerCommandEntry{"god", [](const Caller& caller) { toggle_flag(caller, flag::kGodMode, "godmode"); },
                       true},
    PlayerCommandEntry{"notarget",
                       [](const Caller& caller) { toggle_flag(caller, flag::kNoTarget, "notarget"); }, true},
    PlayerCommandEntry{
        "noclip", [](const Caller& caller) { toggle_move_type(caller, MoveType::kNoClip, "noclip"); }, true},
    PlayerCommandEntry{
        "fly", [](const Caller& caller) { toggle_move_type(caller, MoveType::kFly, "flymode"); }, true},
    PlayerCommandEntry{"give", give_command, true},
    PlayerCommandEntry{"setpos", setpos_command, true},
};

}  // namespace

std::string presentable_name(std::string_view wanted) {
  std::string name;
  for (const char c : wanted) {
    const auto value = static_cast<unsigned char>(c);
    // 128 and above are characters of the game's own font.
    if (name.size() < Client::kMaxNameChars && value >= 32 && value != 127 && c != '"' && c != ';') name += c;
  }
  while (name.ends_with(' ')) name.pop_back();
  while (name.starts_with(' ')) name.erase(0, 1);
  return name.empty() ? "player" : name;
}

void run_player_command(Server& io_server, std::size_t slot, std::string_view line) {
  while (line.starts_with(' ')) line.remove_prefix(1);
  while (line.ends_with('\n') || line.ends_with(' ')) line.remove_suffix(1);
  const std::vector<std::string> words = command::split_words(line);
  if (words.empty() || !io_server.game) return;
  const Caller caller{io_server, slot, line, words};
  const std::string name = base::to_lower(words[0]);
  const auto found = std::find_if(kCommands.begin(), kCommands.end(),
                                  [&](const PlayerCommandEntry& entry) { return entry.name == name; });
  if (found == kCommands.end()) return caller.print(fmt::format("Unknown command \"{}\"\n", words[0]));
  if (found->needs_game && !caller.client().is_in_game()) return;
  const bool is_alone = io_server.clients.size() == 1;
  if (found->is_cheat && !is_alone && !io_server.settings().cheats_allowed())
    return caller.print(fmt::format("{} needs sv_cheats 1\n", name));
  found->run(caller);
}

}  // namespace temblor::server
