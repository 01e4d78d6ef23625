#include "server/host_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "server/save_game.h"
#include "server/server.h"

namespace temblor::server {
namespace {

using Arguments = command::Console::Arguments;

void print_error(Server& io_server, const base::Status& status) {
  if (!status.ok()) io_server.print(status.error().message() + "\n");
}

// Text behind the first `count` words.
std::string words_from(Arguments arguments, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < arguments.size(); ++i) text += (i > first ? " " : "") + arguments[i];
  return text;
}

// "NAME", "#3" or "# 3": a player by name or by number as `status` shows it.
std::optional<std::size_t> find_player(Server& io_server, Arguments arguments) {
  std::string who = arguments[1];
  if (who == "#" && arguments.size() > 2) who += arguments[2];
  if (who.starts_with('#')) {
    std::size_t number = 0;
    std::from_chars(who.data() + 1, who.data() + who.size(), number);
    const bool is_there =
        number >= 1 && number <= io_server.clients().size() && !io_server.clients()[number - 1].is_free();
    return is_there ? std::optional(number - 1) : std::nullopt;
  }
  for (std::size_t slot = 0; slot < io_server.clients().size(); ++slot)
    if (!io_server.clients()[slot].is_free() &&
        base::equal_ignoring_case(io_server.clients()[slot].name, who))
      return slot;
  return std::nullopt;
}

void kick(Server& io_server, Arguments arguments) {
  if (arguments.size() < 2) return io_server.print("kick NAME or kick #NUMBER, then a reason\n");
  const std::optional<std::size_t> slot = find_player(io_server, arguments);
  if (!slot)
    return io_server.print(fmt::format("there is no player \"{}\"; `status` lists them\n", arguments[1]));
  const std::size_t first = arguments[1] == "#" ? 3 : 2;
  const std::string reason = arguments.size() > first ? words_from(arguments, first) : "kicked by the host";
  io_server.clients().print(*slot, fmt::format("Kicked: {}\n", reason));
  io_server.drop(*slot, reason);
}

void ban(Server& io_server, Arguments arguments) {
  if (arguments.size() < 2) {
    for (const net::AddressPrefix& prefix : io_server.endpoint().bans())
      io_server.print(net::to_text(prefix) + "\n");
    if (io_server.endpoint().bans().empty()) io_server.print("nobody is banned\n");
    return;
  }
  if (const std::optional<std::size_t> slot = find_player(io_server, arguments)) {
    auto address = io_server.endpoint().address_of(io_server.clients()[*slot].connection);
    io_server.drop(*slot, "banned by the host");
    if (!address) return;
    address->port = 0;  // the whole host, as `unban ADDRESS` means it
    io_server.endpoint().ban({.base = *address});
    return;
  }
  if (arguments[1].starts_with('#'))
    return io_server.print(fmt::format("there is no player \"{}\"; `status` lists them\n", arguments[1]));
  const base::Result<net::AddressPrefix> prefix = net::parse_prefix(arguments[1]);
  if (!prefix.ok()) return io_server.print(prefix.error().message() + "\n");
  io_server.endpoint().ban(*prefix);
}

void unban(Server& io_server, Arguments arguments) {
  if (arguments.size() < 2) return io_server.print("unban ADDRESS or ADDRESS/BITS\n");
  const base::Result<net::AddressPrefix> prefix = net::parse_prefix(arguments[1]);
  if (!prefix.ok()) return io_server.print(prefix.error().message() + "\n");
  if (!io_server.endpoint().unban(*prefix)) io_server.print(fmt::format("{} was not banned\n", arguments[1]));
}

void status(Server& io_server) {
  const std::string map = io_server.game() ? io_server.game()->setup().map_name : "(none)";
  io_server.print(fmt::format("host:    {}\nmap:     {}\nplayers: {} of {}\n",
                              io_server.settings().host_name(), map, io_server.clients().connected(),
                              io_server.clients().size()));
  for (std::size_t slot = 0; slot < io_server.clients().size(); ++slot) {
    const Client& client = io_server.clients()[slot];
    if (client.is_free()) continue;
    io_server.print(fmt::format("#{:<3} {:<15} {:5} frags {:5.0f} s {:4.0f} ms  {}\n", slot + 1, client.name,
                                client.frags_told, io_server.now_s() - client.joined_at_s,
                                client.ping() * 1000, client.address));
  }
}

void say(Server& io_server, Arguments arguments) {
  const std::string text =
      fmt::format("<{}> {}\n", io_server.settings().host_name(), words_from(arguments, 1));
  io_server.clients().print_everyone("\1" + text);
  io_server.print(text);
}

void list_maps(Server& io_server) {
  for (const std::string& file : io_server.files().list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    if (!name.starts_with("b_")) io_server.print(name + "\n");
  }
}

void profile(Server& io_server) {
  if (!io_server.game()) return io_server.print("no level is running\n");
  constexpr std::size_t kShown = 20;
  vm::Machine& machine = io_server.game()->machine();
  const std::vector<vm::FunctionProfile> profile = machine.profile();
  for (std::size_t i = 0; i < std::min(kShown, profile.size()); ++i)
    io_server.print(fmt::format("{:12} instructions {:9} calls  {}\n", profile[i].instructions,
                                profile[i].calls, machine.program().name_of(profile[i].function)));
  machine.reset_profile();
}

void entity(Server& io_server, Arguments arguments) {
  if (!io_server.game() || arguments.size() < 2)
    return io_server.print("edict NUMBER, while a level is running\n");
  std::uint32_t number = 0;
  std::from_chars(arguments[1].data(), arguments[1].data() + arguments[1].size(), number);
  if (number >= io_server.game()->world().edicts.count())
    return io_server.print(fmt::format("there is no entity {}\n", number));
  for (const auto& [name, value] : entity_as_text(*io_server.game(), vm::EntityIndex{number}))
    io_server.print(fmt::format("{:<16} {}\n", name, value));
}

}  // namespace

void add_host_commands(Server& io_server) {
  command::Console& console = io_server.console();
  Server* server = &io_server;
  // A command that is a call of the server with one name.
  const auto add_named = [&](std::string_view name, std::string_view help,
                             base::Status (Server::*run)(std::string_view)) {
    console.add_command(name, help, [server, run, name = std::string(name)](Arguments arguments) {
      if (arguments.size() != 2) return server->print(fmt::format("{} NAME\n", name));
      print_error(*server, (server->*run)(arguments[1]));
    });
  };
  add_named("map", "Starts a new game on a level.", &Server::start_map);
  add_named("changelevel", "Goes on in another level with what players have.", &Server::change_level);
  add_named("save", "Saves the game of a single player.", &Server::save);
  add_named("load", "Goes on from a saved game.", &Server::load);
  const auto add = [&](std::string_view name, std::string_view help, auto run) {
    console.add_command(name, help, [server, run](Arguments arguments) { run(*server, arguments); });
  };
  add("restart", "Starts the level again.", [](Server& s, Arguments) { print_error(s, s.restart()); });
  add("reload", "Takes up the program and the level as they are on disk now.",
      [](Server& s, Arguments) { print_error(s, s.reload()); });
  add("maps", "Lists the levels that there are.", [](Server& s, Arguments) { list_maps(s); });
  add("status", "Shows the level and who plays.", [](Server& s, Arguments) { status(s); });
  add("kick", "Lets go of a player: kick NAME or #NUMBER, then a reason.", kick);
  add("ban", "Refuses an address, ADDRESS/BITS or a player from now on; alone: lists them.", ban);
  add("unban", "Takes back a ban.", unban);
  add("say", "Says something to all players.", say);
  add("pause", "Stops time, or lets it go on.", [](Server& s, Arguments) { s.set_paused(!s.is_paused()); });
  add("record", "Records what the first player, or player NUMBER, is told: record NAME [NUMBER].",
      [](Server& s, Arguments arguments) {
        if (arguments.size() < 2) return s.print("record NAME [NUMBER]\n");
        std::size_t number = 1;
        if (arguments.size() > 2)
          std::from_chars(arguments[2].data(), arguments[2].data() + arguments[2].size(), number);
        print_error(s, s.record(number - 1, arguments[1]));
      });
  add("stop", "Ends the recording.", [](Server& s, Arguments) { print_error(s, s.stop_recording()); });
  add("profile", "Functions of the program that took the most instructions since the last time.",
      [](Server& s, Arguments) { profile(s); });
  add("edict", "Shows the fields of an entity.", entity);
  add("quit", "Ends the server.", [](Server& s, Arguments) { s.quit(); });
}

}  // namespace temblor::server
