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

void print_error(Server& io_server, const base::Status& status) {
  if (!status.ok()) io_server.console().print_error(status.error().message());
}

std::string not_a_number(std::string_view command, std::string_view word) {
  return fmt::format("{}: \"{}\" is not a number", command, base::quotable(word));
}

// Text behind the first `count` words.
std::string words_from(Arguments arguments, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < arguments.size(); ++i) text += (i > first ? " " : "") + arguments[i];
  return text;
}

// "NAME", "#3" or "# 3": a player by name or by number as `status` shows it.
base::Result<std::size_t> find_player(Server& io_server, Arguments arguments) {
  std::string who = arguments[1];
  if (who == "#" && arguments.size() > 2) who += arguments[2];
  Clients& clients = io_server.clients();
  if (who.starts_with('#')) {
    const std::optional<std::int64_t> number = command::parse_whole_number(std::string_view(who).substr(1));
    if (!number)
      return base::error(base::ErrorCode::kUsage, "\"{}\" is no player's number; `status` lists them",
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
  if (!slot.ok()) return io_server.console().print_error(slot.error().message());
  const std::size_t first = arguments[1] == "#" ? 3 : 2;
  io_server.drop(*slot, arguments.size() > first ? fmt::format("kicked: {}", words_from(arguments, first))
                                                 : "kicked by the host");
}

void ban_prefix(Server& io_server, const net::AddressPrefix& prefix) {
  io_server.endpoint().ban(prefix);
  // A file may hold many.
  if (!io_server.console().is_in_file())
    io_server.print(
        fmt::format("{0} is banned until the server ends, or `unban {0}`\n", net::to_text(prefix)));
}

void ban(Server& io_server, Arguments arguments) {
  if (arguments.size() < 2) {
    for (const net::AddressPrefix& prefix : io_server.endpoint().bans())
      io_server.print(net::to_text(prefix) + "\n");
    if (io_server.endpoint().bans().empty()) io_server.print("nobody is banned\n");
    return;
  }
  const base::Result<std::size_t> slot = find_player(io_server, arguments);
  if (slot.ok() && io_server.clients()[*slot].is_bot())
    return io_server.console().print_error("a bot has no address; `bot_fill` says how many there are");
  if (slot.ok()) {
    auto address = io_server.endpoint().address_of(io_server.clients()[*slot].connection);
    io_server.drop(*slot, "banned by the host");
    if (!address) return;
    address->port = 0;  // the whole host, as `unban ADDRESS` means it
    return ban_prefix(io_server, {.base = *address});
  }
  if (arguments[1].starts_with('#')) return io_server.console().print_error(slot.error().message());
  const base::Result<net::AddressPrefix> prefix = net::parse_prefix(arguments[1]);
  if (!prefix.ok())
    return io_server.console().print_error(
        fmt::format("ban: there is no such player, and {}", prefix.error().message()));
  ban_prefix(io_server, *prefix);
}

void unban(Server& io_server, Arguments arguments) {
  const base::Result<net::AddressPrefix> prefix = net::parse_prefix(arguments[1]);
  if (!prefix.ok()) return print_error(io_server, prefix.error());
  if (!io_server.endpoint().unban(*prefix))
    return io_server.console().print_error(
        fmt::format("{} was not banned; `ban` lists who is", net::to_text(*prefix)));
  io_server.print(fmt::format("{} may come again\n", net::to_text(*prefix)));
}

void status(Server& io_server) {
  const std::string map = io_server.game() ? io_server.game()->setup().map_name : "(none)";
  io_server.print(fmt::format("host:    {}\nmap:     {}\nplayers: {} of {}\n",
                              io_server.settings().host_name(), map, io_server.clients().connected(),
                              io_server.clients().size()));
  for (std::size_t slot = 0; slot < io_server.clients().size(); ++slot) {
    const Client& client = io_server.clients()[slot];
    if (client.is_free()) continue;
    io_server.print(fmt::format("#{:<3} {:<15} {:5} {:<5} {:5.0f} s {:4.0f} ms  {}\n", slot + 1, client.name,
                                client.sent_frags, client.sent_frags == 1 ? "frag" : "frags",
                                io_server.now_s() - client.joined_at_s, client.ping() * 1000,
                                client.address));
  }
}

void say(Server& io_server, Arguments arguments) {
  const std::string text =
      fmt::format("<{}> {}\n", io_server.settings().host_name(), words_from(arguments, 1));
  io_server.clients().print_everyone("\1" + text);
  io_server.print_event(text);
}

void list_maps(Server& io_server) {
  for (const std::string& file : io_server.files().list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    if (!name.starts_with("b_")) io_server.print(name + "\n");
  }
}

void profile(Server& io_server) {
  if (!io_server.game()) return io_server.console().print_error("profile: no level is running");
  constexpr std::size_t kShown = 20;
  vm::Machine& machine = io_server.game()->machine();
  const std::vector<vm::FunctionProfile> profile = machine.profile();
  for (std::size_t i = 0; i < std::min(kShown, profile.size()); ++i)
    io_server.print(fmt::format("{:12} instructions {:9} calls  {}\n", profile[i].instructions,
                                profile[i].calls, machine.program().name_of(profile[i].function)));
  machine.reset_profile();
}

void entity(Server& io_server, Arguments arguments) {
  command::Console& console = io_server.console();
  if (!io_server.game()) return console.print_error("edict: no level is running");
  const std::optional<std::int64_t> number = command::parse_whole_number(arguments[1]);
  if (!number) return console.print_error(not_a_number("edict", arguments[1]));
  const std::size_t count = io_server.game()->world().edicts.count();
  if (*number < 0 || static_cast<std::size_t>(*number) >= count)
    return console.print_error(fmt::format("there is no entity {}: they are 0 to {}", *number, count - 1));
  const auto index = static_cast<std::uint32_t>(*number);
  for (const auto& [name, value] : entity_as_text(*io_server.game(), vm::EntityIndex{index}))
    io_server.print(fmt::format("{:<16} {}\n", name, value));
}

void record(Server& io_server, Arguments arguments) {
  std::int64_t number = 1;
  if (arguments.size() > 2) {
    const std::optional<std::int64_t> told = command::parse_whole_number(arguments[2]);
    if (!told) return io_server.console().print_error(not_a_number("record", arguments[2]));
    number = *told;
  }
  print_error(io_server, io_server.record(static_cast<std::size_t>(number - 1), arguments[1]));
}

void pause(Server& io_server) {
  if (!io_server.game()) return io_server.console().print_error("pause: no level is running");
  io_server.set_paused(!io_server.is_paused());
  io_server.print(io_server.is_paused() ? "time stands still; `pause` lets it go on\n" : "time goes on\n");
}

// A player who is alone sees it.
void tell_of_level(Server& io_server, const base::Status& status) {
  print_error(io_server, status);
  if (!status.ok() || io_server.clients().size() == 1) return;
  const GameSetup& game = io_server.game()->setup();
  io_server.print(
      fmt::format("level {}, protocol {}\n", game.map_name, static_cast<int>(game.dialect.protocol)));
}

void load(Server& io_server, Arguments arguments) {
  const base::Status status = io_server.load(arguments[1]);
  print_error(io_server, status);
  if (status.ok()) io_server.print(fmt::format("loaded: level {}\n", io_server.game()->setup().map_name));
}

}  // namespace

void add_host_commands(Server& io_server) {
  // With fewer words behind its name, a command answers with its help.
  const auto add = [&](std::string_view name, std::string_view help, std::size_t least_words, auto run) {
    io_server.console().add_command(name, help,
                                    [server = &io_server, help, least_words, run](Arguments arguments) {
                                      if (arguments.size() <= least_words)
                                        return server->console().print_error(help);
                                      run(*server, arguments);
                                    });
  };
  add("map", "map NAME begins a new game on a level; `maps` lists them.", 1,
      [](Server& s, Arguments words) { tell_of_level(s, s.start_map(words[1])); });
  add("changelevel", "changelevel NAME goes on in another level with what players have.", 1,
      [](Server& s, Arguments words) { tell_of_level(s, s.change_level(words[1])); });
  add("restart", "Starts the level again.", 0, [](Server& s, Arguments) { tell_of_level(s, s.restart()); });
  add("reload", "Takes up the program and the level as they are on disk now.", 0,
      [](Server& s, Arguments) { print_error(s, s.reload()); });
  add("save", "save NAME saves the game of a single player.", 1,
      [](Server& s, Arguments words) { print_error(s, s.save(words[1])); });
  add("load", "load NAME goes on from a saved game.", 1, load);
  add("maps", "Lists the levels that there are.", 0, [](Server& s, Arguments) { list_maps(s); });
  add("status", "Shows the level and who plays.", 0, [](Server& s, Arguments) { status(s); });
  add("kick", "kick NAME or #NUMBER, then a reason: lets go of a player.", 1, kick);
  add("ban", "ban ADDRESS, ADDRESS/BITS, NAME or #NUMBER refuses them from now on; ban lists them.", 0, ban);
  add("unban", "unban ADDRESS or ADDRESS/BITS takes back a ban.", 1, unban);
  add("say", "say WORDS says something to all players.", 1, say);
  add("pause", "Stops time, or lets it go on.", 0, [](Server& s, Arguments) { pause(s); });
  add("record", "record NAME [NUMBER] records what the first player, or player NUMBER, is told.", 1, record);
  add("stop", "Ends the recording.", 0, [](Server& s, Arguments) { print_error(s, s.stop_recording()); });
  add("profile", "Functions of the program that took the most instructions since the last time.", 0,
      [](Server& s, Arguments) { profile(s); });
  add("edict", "edict NUMBER shows the fields of an entity.", 1, entity);
  add("quit", "Ends the server.", 0, [](Server& s, Arguments) { s.quit(); });
}

}  // namespace temblor::server
