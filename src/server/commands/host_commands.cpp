#include "server/commands/host_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "command/text.h"
#include "server/save/save_game.h"
#include "server/server.h"

namespace temblor::server {
namespace {

using Arguments = command::Console::Arguments;

// Errors in configuration files get their file and line from the console.
void print_error(Server& io_server, const base::Status& status) {
  if (!status.ok()) io_server.console.print_error(status.error().message());
}

std::string not_a_number(std::string_view command, std::string_view word) {
  return fmt::format("{}: \"{}\" is not a number", command, base::quotable(word));
}

// All words from this one on, joined by blanks.
std::string join_words_from(Arguments arguments, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < arguments.size(); ++i) text += (i > first ? " " : "") + arguments[i];
  return text;
}

// Finds a player by name or by its number, as `status` shows it: "NAME", "#3" or "# 3".
base::Result<std::size_t> find_player(Server& io_server, Arguments arguments) {
  std::string who = arguments[1];
  if (who == "#" && arguments.size() > 2) who += arguments[2];
  Clients& clients = io_server.clients;
  if (who.starts_with('#')) {
    const std::optional<std::int64_t> number = command::parse_whole_number(std::string_view(who).substr(1));
    if (!number)
      return base::error(base::ErrorCode::kUsage, "\"{}\" is not a player number; `status` lists them",
                         base::quotable(who));
    const auto slot = static_cast<std::size_t>(*number - 1);
    if (*number >= 1 && slot < clients.size() && !clients[slot].is_free()) return slot;
  } else {
    for (std::size_t slot = 0; slot < clients.size(); ++slot)
      if (!clients[slot].is_free() && base::equal_ignoring_case(clients[slot].name, who)) return slot;
  }
  return base::error(base::ErrorCode::kNotFound, "there is no player \"{}\"; `status` lists them",
                     base::quotable(who));
}

void kick(Server& io_server, Arguments arguments) {
  const base::Result<std::size_t> slot = find_player(io_server, arguments);
  if (!slot.ok()) return io_server.console.print_error(slot.error().message());
  const std::size_t first = arguments[1] == "#" ? 3 : 2;
  drop_client(io_server, *slot,
              arguments.size() > first ? fmt::format("kicked: {}", join_words_from(arguments, first))
                                       : "kicked by the host");
}

void ban_prefix(Server& io_server, const net::AddressPrefix& prefix) {
  io_server.endpoint.ban(prefix);
  // A file may contain many bans, so it is not answered line by line.
  if (!io_server.console.is_in_file())
    print(io_server, fmt::format("{0} is banned until the server shuts down; `unban {0}` lifts the ban\n",
                                 net::to_text(prefix)));
}

// An argument that is not a player's name is an address, or the first bits of one. Bans last as long as the
// server.
void ban(Server& io_server, Arguments arguments) {
  if (arguments.size() < 2) {
    for (const net::AddressPrefix& prefix : io_server.endpoint.bans())
      print(io_server, net::to_text(prefix) + "\n");
    if (io_server.endpoint.bans().empty()) print(io_server, "nobody is banned\n");
    return;
  }
  const base::Result<std::size_t> slot = find_player(io_server, arguments);
  if (slot.ok() && io_server.clients[*slot].is_bot())
    return io_server.console.print_error("bots have no address; `bot_fill` sets their number");
  if (slot.ok()) {
    auto address = io_server.endpoint.peer_address(io_server.clients[*slot].connection);
    drop_client(io_server, *slot, "banned by the host");
    if (!address) return;
    address->port = 0;  // all ports of the host, as for `unban ADDRESS`
    return ban_prefix(io_server, {.base = *address});
  }
  if (arguments[1].starts_with('#')) return io_server.console.print_error(slot.error().message());
  const base::Result<net::AddressPrefix> prefix = net::parse_prefix(arguments[1]);
  if (!prefix.ok())
    return io_server.console.print_error(
        fmt::format("ban: there is no such player, and {}", prefix.error().message()));
  ban_prefix(io_server, *prefix);
}

void unban(Server& io_server, Arguments arguments) {
  const base::Result<net::AddressPrefix> prefix = net::parse_prefix(arguments[1]);
  if (!prefix.ok()) return print_error(io_server, prefix.error());
  if (!io_server.endpoint.unban(*prefix))
    return io_server.console.print_error(
        fmt::format("{} is not banned; `ban` lists all bans", net::to_text(*prefix)));
  print(io_server, fmt::format("{} is no longer banned\n", net::to_text(*prefix)));
}

void status(Server& io_server) {
  const std::string map = io_server.game ? io_server.game->setup().map_name : "(none)";
  print(io_server,
        fmt::format("host:    {}\nmap:     {}\nplayers: {} of {}\n", io_server.settings().host_name(), map,
                    io_server.clients.connected_count(), io_server.clients.size()));
  for (std::size_t slot = 0; slot < io_server.clients.size(); ++slot) {
    const Client& client = io_server.clients[slot];
    if (client.is_free()) continue;
    print(io_server, fmt::format("#{:<3} {:<15} {:5} {:<5} {:5.0f} s {:4.0f} ms  {}\n", slot + 1, client.name,
                                 client.sent_frags, client.sent_frags == 1 ? "frag" : "frags",
                                 io_server.clock.now_s - client.joined_at_s, client.mean_ping_s() * 1000,
                                 client.address));
  }
}

// For each player: how much of the level the last snapshot contained.
void net_stats(Server& io_server) {
  const net::ServerEndpointStatistics& counts = io_server.endpoint.statistics();
  print(io_server, fmt::format("{} received, {} invalid, {} from unknown peers, {} over a rate limit\n",
                               base::counted(counts.datagrams, "packet"), counts.malformed,
                               counts.from_unknown_peers, counts.rate_limited + counts.unanswered));
  for (std::size_t slot = 0; slot < io_server.clients.size(); ++slot) {
    const Client& client = io_server.clients[slot];
    if (client.stage != ClientStage::kPlaying) continue;
    const DatagramCounts& sent = client.sent_counts;
    print(io_server, fmt::format("#{:<3} {:<15} was sent {} of {} visible entities\n", slot + 1, client.name,
                                 sent.entities, sent.entities + sent.entities_left_out));
  }
  if (const std::size_t count = io_server.buffers.snapshot.unnumbered; count > 0)
    print(io_server, fmt::format("{} more {} no number in protocol 15 and cannot be seen\n", count,
                                 count == 1 ? "has" : "have"));
}

void say(Server& io_server, Arguments arguments) {
  const std::string text =
      fmt::format("<{}> {}\n", io_server.settings().host_name(), join_words_from(arguments, 1));
  io_server.clients.print_to_all("\1" + text);
  print_event(io_server, text);
}

void tell(Server& io_server, Arguments arguments) {
  const base::Result<std::size_t> slot = find_player(io_server, arguments);
  if (!slot.ok()) return io_server.console.print_error(slot.error().message());
  io_server.clients.print(
      *slot, fmt::format("{}:{}\n", io_server.settings().host_name(), join_words_from(arguments, 2)));
}

void list_pings(Server& io_server) {
  print(io_server, "Client ping times:\n");
  for (const Client& client : io_server.clients.all())
    if (!client.is_free())
      print(io_server, fmt::format("{:4} {}\n", static_cast<int>(std::lround(client.mean_ping_s() * 1000)),
                                   client.name));
}

// Files that begin with "b_" are models of items, such as boxes of ammunition.
void list_maps(Server& io_server) {
  for (const std::string& file : io_server.setup.library.files().list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    if (!name.starts_with("b_")) print(io_server, name + "\n");
  }
}

// Counts start again with each call, so that a host can measure one scene.
void profile(Server& io_server) {
  if (!io_server.game) return io_server.console.print_error("profile: no level is running");
  constexpr std::size_t kShown = 20;
  vm::Machine& machine = io_server.game->machine();
  const std::vector<vm::FunctionProfile> profile = machine.profile();
  for (std::size_t i = 0; i < std::min(kShown, profile.size()); ++i)
    print(io_server, fmt::format("{:12} instructions {:9} calls  {}\n", profile[i].instructions,
                                 profile[i].calls, machine.program().function_name(profile[i].function)));
  machine.reset_profile();
}

void entity(Server& io_server, Arguments arguments) {
  command::Console& console = io_server.console;
  if (!io_server.game) return console.print_error("edict: no level is running");
  const std::optional<std::int64_t> number = command::parse_whole_number(arguments[1]);
  if (!number) return console.print_error(not_a_number("edict", arguments[1]));
  const std::size_t count = io_server.game->world().edicts.count();
  if (*number < 0 || static_cast<std::size_t>(*number) >= count)
    return console.print_error(fmt::format("there is no entity {}; the last one is {}", *number, count - 1));
  const auto index = static_cast<std::uint32_t>(*number);
  for (const auto& [name, value] : nonzero_fields(*io_server.game, vm::EntityIndex{index}))
    print(io_server, fmt::format("{:<16} {}\n", name, value));
}

// All entities, or those whose class contains the argument.
void list_entities(Server& io_server, Arguments arguments) {
  if (!io_server.game) return io_server.console.print_error("edicts: no level is running");
  Edicts& edicts = io_server.game->world().edicts;
  std::size_t shown = 0;
  for (std::uint32_t i = 0; i < edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (edicts.is_free(entity)) continue;
    const std::string name(io_server.game->machine().text(edicts[entity][field::kClassName]));
    if (arguments.size() > 1 && name.find(arguments[1]) == std::string::npos) continue;
    const math::Vec3 at = edicts[entity][field::kOrigin];
    print(io_server, fmt::format("{:5} {:<28} {:.0f} {:.0f} {:.0f}\n", i, name, at.x, at.y, at.z));
    ++shown;
  }
  print(io_server, fmt::format("{} {}\n", shown, shown == 1 ? "entity" : "entities"));
}

void count_entities(Server& io_server) {
  if (!io_server.game) return io_server.console.print_error("edictcount: no level is running");
  Edicts& edicts = io_server.game->world().edicts;
  std::size_t used = 0, solid = 0, with_model = 0;
  for (std::uint32_t i = 0; i < edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (edicts.is_free(entity)) continue;
    ++used;
    solid += edicts[entity].solid() != Solid::kNot;
    with_model += edicts[entity][field::kModelIndex] != 0;
  }
  print(io_server, fmt::format("{} entities: {} with a model, {} solid or triggers; {} numbers in use\n",
                               used, with_model, solid, edicts.count()));
}

void record(Server& io_server, Arguments arguments) {
  std::int64_t number = 1;
  if (arguments.size() > 2) {
    const std::optional<std::int64_t> parsed = command::parse_whole_number(arguments[2]);
    if (!parsed) return io_server.console.print_error(not_a_number("record", arguments[2]));
    number = *parsed;
  }
  print_error(io_server, record_demo(io_server, static_cast<std::size_t>(number - 1), arguments[1]));
}

void pause(Server& io_server) {
  if (!io_server.game) return io_server.console.print_error("pause: no level is running");
  set_paused(io_server, !io_server.clock.is_paused);
  print(io_server, io_server.clock.is_paused ? "Paused. Type pause to continue.\n" : "Unpaused.\n");
}

// Prints which level runs, for a host of several players. A single player sees it.
void print_level(Server& io_server, const base::Status& status) {
  print_error(io_server, status);
  if (!status.ok() || io_server.clients.size() == 1) return;
  const GameSetup& game = io_server.game->setup();
  print(io_server,
        fmt::format("level {}, protocol {}\n", game.map_name, static_cast<int>(game.dialect.protocol)));
}

void load(Server& io_server, Arguments arguments) {
  const base::Status status = load_saved_game(io_server, arguments[1]);
  print_error(io_server, status);
  if (status.ok()) print(io_server, "Loaded.\n");
}

void max_players(Server& io_server, Arguments arguments) {
  if (arguments.size() < 2)
    return print(io_server, fmt::format("maxplayers is {}.\n", io_server.setup.max_clients));
  constexpr int kMaxClients = 255;
  const std::optional<std::int64_t> count = command::parse_whole_number(arguments[1]);
  if (!count || *count < 1 || *count > kMaxClients)
    return io_server.console.print_error(
        fmt::format("maxplayers: \"{}\" is not a number from 1 to {}", arguments[1], kMaxClients));
  print_error(io_server, set_max_clients(io_server, static_cast<std::uint32_t>(*count)));
}

}  // namespace

void add_host_commands(Server& io_server) {
  // A command with too few arguments prints its help.
  const auto add = [&](std::string_view name, std::string_view help, std::size_t min_words, auto run) {
    io_server.console.add_command(name, help,
                                  [server = &io_server, help, min_words, run](Arguments arguments) {
                                    if (arguments.size() <= min_words)
                                      return server->console.print_error(help);
                                    run(*server, arguments);
                                  });
  };
  add("map", "map NAME: starts a new game on a level; `maps` lists them.", 1,
      [](Server& s, Arguments words) { print_level(s, start_map(s, words[1])); });
  add("changelevel", "changelevel NAME: goes to another level; players keep what they carry.", 1,
      [](Server& s, Arguments words) { print_level(s, change_level(s, words[1])); });
  add("restart", "Restarts the level.", 0, [](Server& s, Arguments) { print_level(s, restart_level(s)); });
  add("reload", "Reloads game code and the level from disk.", 0,
      [](Server& s, Arguments) { print_error(s, reload_level(s)); });
  add("maxplayers",
      "maxplayers N: sets the number of player slots, before the first level; without N, shows it.", 0,
      max_players);
  add("save", "save NAME [TITLE]: saves a single-player game; the menu shows the title.", 1,
      [](Server& s, Arguments words) {
        print_error(s, save_game(s, words[1], words.size() > 2 ? words[2] : std::string_view()));
      });
  add("load", "load NAME: loads a saved game.", 1, load);
  add("maps", "Lists all levels.", 0, [](Server& s, Arguments) { list_maps(s); });
  add("status", "Shows the level and its players.", 0, [](Server& s, Arguments) { status(s); });
  add("net_stats", "Shows how many packets arrived, and how many entities each player is sent.", 0,
      [](Server& s, Arguments) { net_stats(s); });
  add("kick", "kick NAME or #NUMBER [REASON]: disconnects a player.", 1, kick);
  add("ban", "ban ADDRESS, ADDRESS/BITS, NAME or #NUMBER: refuses connections; ban alone lists bans.", 0,
      ban);
  add("unban", "unban ADDRESS or ADDRESS/BITS: lifts a ban.", 1, unban);
  add("say", "say TEXT: sends a chat line to all players.", 1, say);
  add("pause", "Pauses or resumes the game.", 0, [](Server& s, Arguments) { pause(s); });
  add("record", "record NAME [NUMBER]: records a demo of the first player, or of player NUMBER.", 1, record);
  add("stop", "Stops recording the demo.", 0, [](Server& s, Arguments) { print_error(s, stop_demo(s)); });
  add("profile", "Lists the QuakeC functions that ran the most instructions since the last call.", 0,
      [](Server& s, Arguments) { profile(s); });
  add("edict", "edict NUMBER: shows the fields of an entity.", 1, entity);
  add("edicts", "edicts [PART]: lists the entities, or those whose class contains PART.", 0, list_entities);
  add("edictcount", "Counts the entities.", 0, [](Server& s, Arguments) { count_entities(s); });
  // Other servers' names for some of these.
  add("users", "Shows the level and its players.", 0, [](Server& s, Arguments) { status(s); });
  add("addip", "addip ADDRESS or ADDRESS/BITS: refuses connections; addip alone lists bans.", 0, ban);
  add("removeip", "removeip ADDRESS or ADDRESS/BITS: lifts a ban.", 1, unban);
  add("listip", "Lists the bans.", 0, [](Server& s, Arguments words) { ban(s, words.first(1)); });
  add("tell", "tell NAME or #NUMBER TEXT: sends a chat line to one player.", 2, tell);
  add("ping", "Shows every player's ping.", 0, [](Server& s, Arguments) { list_pings(s); });
  add("version", "Shows the version of Temblor.", 0,
      [](Server& s, Arguments) { print(s, s.setup.version + "\n"); });
  add("heartbeat", "Does nothing: Temblor uses no master server.", 0,
      [](Server& s, Arguments) { print(s, "There is no master server. Players join by address.\n"); });
  for (const char* const name : {"quit", "killserver"})
    add(name, "Shuts the server down.", 0, [](Server& s, Arguments) { s.wants_to_quit = true; });
}

}  // namespace temblor::server
