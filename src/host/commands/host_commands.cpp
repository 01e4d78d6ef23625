#include "host/commands/host_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "assets/mission_pack.h"
#include "base/text.h"
#include "command/text.h"
#include "host/commands/chat_macros.h"
#include "host/commands/command_adder.h"
#include "host/commands/configuration.h"
#include "host/commands/list_commands.h"
#include "host/commands/sound_commands.h"
#include "host/commands/view_commands.h"
#include "host/frame/host_parts.h"
#include "host/lockstep/lockstep_commands.h"
#include "host/menus/menus.h"
#include "host/session/configure.h"
#include "host/session/demos.h"
#include "host/session/games.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

// min_arguments does not count the command's name. With fewer arguments, the command prints its help.
struct CommandHelp {
  std::string_view name, help;
  std::size_t min_arguments = 0;
};

// Sent to the server unchanged. The server decides whether a player may use them.
constexpr std::array kPlayerCommands = {
    CommandHelp{"say", "say TEXT: sends a message to all players.", 1},
    CommandHelp{
        "say_team",
        "say_team TEXT: sends a message to your team. %l is where you are, %h your health; also %a, %w, "
        "%r, %c, %p, %t.",
        1},
    CommandHelp{"tell", "tell NAME TEXT: sends a message to one player.", 2},
    CommandHelp{"ping", "Shows every player's ping."},
    CommandHelp{"status", "Shows the level and the players."},
    CommandHelp{"pause", "Pauses or resumes the game."},
    CommandHelp{"kill", "Suicide."},
    CommandHelp{"god", "Toggles god mode (no damage)."},
    CommandHelp{"notarget", "Toggles whether monsters ignore you."},
    CommandHelp{"noclip", "Toggles flying through walls."},
    CommandHelp{"fly", "Toggles flying."},
    CommandHelp{"setpos", "setpos X Y Z [PITCH YAW]: flies to a place (see viewpos). Alone: shows yours."},
    CommandHelp{"give",
                "give all, weapons, ammo, or keys; give 2 to 8: a weapon; give h 100: health; a: armor, "
                "s: shells, n: nails, r: rockets, c: cells.",
                1},
    CommandHelp{"rcon", "rcon PASSWORD COMMAND: runs a command on the server.", 2},
};

// Run in the console of our own server. A remote server accepts them only through `rcon`.
constexpr std::array kServerCommands = {
    CommandHelp{"changelevel", "changelevel NAME: moves everyone to another level, with their items."},
    CommandHelp{"restart", "Restarts the level."},
    CommandHelp{"reload", "Reloads the level and the game code from disk."},
    CommandHelp{"net_stats", "Shows how many packets arrived, and how many entities each player is sent."},
    CommandHelp{"kick", "kick NAME or #NUMBER [REASON]: disconnects a player."},
    CommandHelp{"ban", "ban ADDRESS[/BITS] or PLAYER: bans a player. Without an argument: lists all bans."},
    CommandHelp{"unban", "unban ADDRESS: lifts a ban."},
    CommandHelp{"profile", "Lists the QuakeC functions that ran the most instructions since the last call."},
    CommandHelp{"edict", "edict NUMBER: shows the fields of an entity."},
    CommandHelp{"users", "Shows the level and the players."},
    CommandHelp{"addip", "addip ADDRESS[/BITS]: refuses connections. Without an argument: lists all bans."},
    CommandHelp{"removeip", "removeip ADDRESS[/BITS]: lifts a ban."},
    CommandHelp{"listip", "Lists all bans."},
    CommandHelp{"edicts", "edicts [PART]: lists the server's entities, or those whose class contains PART."},
    CommandHelp{"edictcount", "Counts the server's entities."},
};

// Prints an error, with the file and line of the command if it is in a file.
void print_command_error(Host& io_host, std::string_view text) {
  io_host.console.commands.print_error(text);
}

void print_if_command_error(Host& io_host, const base::Status& status) {
  if (!status.ok()) print_command_error(io_host, status.error().message());
}

// Whether the command has exactly one argument. If not, prints the help or an error.
bool has_one_name(Host& io_host, Arguments arguments, std::string_view help) {
  if (arguments.size() == 2) return true;
  print_command_error(
      io_host, arguments.size() < 2
                   ? std::string(help)
                   : fmt::format("{} takes one name. Put quotes around a name with spaces.", arguments[0]));
  return false;
}

// The inverse of splitting: quotes arguments that contain spaces.
std::string join_arguments(Arguments arguments) {
  return command::join_words(std::vector<std::string>(arguments.begin(), arguments.end()));
}

// Returns the argument as a number. Prints an error and returns none unless there is exactly one number.
std::optional<double> parse_number_argument(Host& io_host, Arguments arguments) {
  const auto number = arguments.size() == 2 ? command::parse_number(arguments[1]) : std::nullopt;
  if (!number) print_command_error(io_host, fmt::format("{} takes one number", arguments[0]));
  return number;
}

// Registers a command that takes exactly one name, of a level, file or server. Prints the error that it
// returns.
void add_named(Host& io_host, std::string_view name, std::string_view help,
               base::Status (*run)(Host&, std::string_view)) {
  make_adder(io_host)(name, help, [run, help](Host& host, Arguments arguments) {
    if (has_one_name(host, arguments, help)) print_if_command_error(host, run(host, arguments[1]));
  });
}

void add_player_commands(Host& io_host) {
  for (const CommandHelp& entry : kPlayerCommands)
    make_adder(io_host)(entry.name, entry.help, [entry](Host& host, Arguments arguments) {
      if (arguments.size() <= entry.min_arguments) return print_command_error(host, entry.help);
      if (client::Connection* const connection = host.game.session->connection())
        return connection->send_command(entry.name == "say_team"
                                            ? expand_chat_macros(host, join_arguments(arguments))
                                            : join_arguments(arguments));
      print_command_error(host, fmt::format("{}: start or join a game first", arguments[0]));
    });
}

void add_server_commands(Host& io_host) {
  for (const CommandHelp& entry : kServerCommands)
    make_adder(io_host)(entry.name, entry.help, [](Host& host, Arguments arguments) {
      if (server::Server* const server = host.game.session->server())
        return server->console.execute(join_arguments(arguments));
      print_command_error(
          host,
          fmt::format("{}: no game is running on this machine. Type map NAME to start one.", arguments[0]));
    });
}

void set_colors(Host& io_host, Arguments arguments) {
  command::Variables& variables = io_host.variables.variables();
  if (arguments.size() < 2)
    return print_line(
        io_host, fmt::format("color is {} {}; color SHIRT [PANTS]: 0 to 13", variables.find("topcolor")->text,
                             variables.find("bottomcolor")->text));
  print_if_command_error(io_host, variables.set("topcolor", arguments[1]));
  print_if_command_error(io_host, variables.set("bottomcolor", arguments[arguments.size() > 2 ? 2 : 1]));
}

void list_levels(Host& io_host) {
  for (const std::string& file : io_host.game.data->library.files().list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    if (!name.starts_with("b_")) print_line(io_host, name);  // b_*.bsp are the models of ammo boxes
  }
}

// Prints the camera for people, and as options of `temblor render`, which draws the same view for a bug
// report.
void print_camera(Host& io_host) {
  const std::optional<render::Camera> camera = current_camera(io_host);
  if (!camera) return print_command_error(io_host, "viewpos: start or join a game first");
  const auto format = [](const math::Vec3& v, std::string_view separator) {
    return fmt::format("{1}{0}{2}{0}{3}", separator, std::lround(v.x), std::lround(v.y), std::lround(v.z));
  };
  const math::Vec3& position = camera->origin_world;
  const math::Vec3& angles = camera->angles_deg;
  print_line(io_host, fmt::format("position {} (map units), angles {} (pitch, yaw, roll in degrees)",
                                  format(position, " "), format(angles, " ")));
  print_line(io_host, fmt::format("render --pos {} --angles {}", format(position, ","), format(angles, ",")));
}

void change_view_size(Host& io_host, int step) {
  command::Variables& variables = io_host.variables.variables();
  const command::Variable& size = *variables.find("viewsize");
  const double wanted = std::clamp(size.number + step, size.min, size.max);
  print_if_command_error(io_host, variables.set("viewsize", std::to_string(static_cast<int>(wanted))));
}

// Returns the current demo. Prints an error and returns null if no demo is playing.
client::DemoSession* find_demo(Host& io_host, Arguments arguments) {
  if (io_host.demos.session) return &*io_host.demos.session;
  print_command_error(io_host, fmt::format("{}: no demo is playing", arguments[0]));
  return nullptr;
}

// "+10" and "-10" are relative to the current time, "10" to the start of the demo.
void seek(Host& io_host, Arguments arguments) {
  const client::DemoSession* const demo = find_demo(io_host, arguments);
  const std::optional<double> number_s =
      demo == nullptr ? std::nullopt : parse_number_argument(io_host, arguments);
  if (!number_s) return;
  const bool is_relative = arguments[1].starts_with('+') || arguments[1].starts_with('-');
  print_if_command_error(io_host,
                         seek_demo(io_host, (is_relative ? demo->time_s() : demo->begin_s()) + *number_s));
}

// In quake.rc, a game or demo of the command line may still follow. Later, as in stock Quake, a game goes on.
void start_demos(Host& io_host, Arguments arguments) {
  if (arguments.size() < 2) return print_line(io_host, "startdemos NAME...");
  std::vector<std::string> demos(arguments.begin() + 1, arguments.end());
  if (!io_host.game.has_begun)
    io_host.game.startup.demos = std::move(demos);
  else if (io_host.game.session->connection() == nullptr)
    attract(io_host, std::move(demos));
}

// The command line may contain this command, so it runs once a frame at most.
void run_command_line_again(Host& io_host, Arguments) {
  StartupScript& startup = io_host.game.startup;
  if (!io_host.game.has_begun || std::exchange(startup.has_stuffed, true)) return;
  for (const std::string& line : io_host.options.commands) io_host.console.commands.append(line);
}

void add_demo_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  add_named(io_host, "playdemo",
            "playdemo NAME: plays a demo. Space pauses, the arrow keys seek and change the speed.",
            play_demo);
  add_named(io_host, "timedemo", "timedemo NAME: benchmark; plays a demo as fast as possible.", time_demo);
  add_named(io_host, "record", "record NAME: records a demo until you type stop.", record_demo);
  add("stop", "Stops recording and saves the demo.",
      [](Host& host, Arguments) { print_if_command_error(host, stop_recording(host)); });
  add("startdemos", "startdemos NAME...: plays demos behind the menu in an endless loop.", start_demos);
  add("stopdemo", "Stops the demo that is playing.", [](Host& host, Arguments) {
    if (host.demos.is_attracting()) host.game.startup.demos.clear();  // or it would start again
    stop_demo(host);
  });
  add("demo_pause", "Pauses or resumes a demo.", [](Host& host, Arguments arguments) {
    if (client::DemoSession* const demo = find_demo(host, arguments)) demo->pause(!demo->is_paused());
  });
  add("demo_speed", "demo_speed FACTOR: sets the speed of a demo, 0.1 to 8.",
      [](Host& host, Arguments arguments) {
        client::DemoSession* const demo = find_demo(host, arguments);
        const std::optional<double> speed =
            demo == nullptr ? std::nullopt : parse_number_argument(host, arguments);
        if (speed) demo->set_speed(*speed);
      });
  add("demo_seek", "demo_seek SECONDS: jumps to that time in a demo. +SECONDS and -SECONDS skip.", seek);
}

// "menu_video" -> "Opens the video menu." Names that do not read well get a title from the table.
std::string make_menu_help(std::string_view command) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTitles = {{
      {"menu_singleplayer", "single-player"},
      {"menu_newgame", "new game"},
      {"menu_setup", "player setup"},
      {"menu_games", "mods"},
      {"help_menu", "help"},
      {"menu_maps", "levels"},
  }};
  std::string_view title = command.substr(command.find('_') + 1);
  for (const auto& [name, text] : kTitles)
    if (name == command) title = text;
  return fmt::format("Opens the {} menu.", title);
}

void add_screen_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  for (const client::MenuCommand& menu : client::menu_commands())
    add(menu.name, make_menu_help(menu.name),
        [page = menu.page](Host& host, Arguments) { open_menu(host, page); });
  // Other engines' names for some of them.
  constexpr std::array<std::pair<std::string_view, client::MenuPage>, 3> kOtherNames = {{
      {"menu_maps", client::MenuPage::kLevels},
      {"menu_mods", client::MenuPage::kGameFolders},
      {"menu_credits", client::MenuPage::kHelp},
  }};
  for (const auto& [name, page] : kOtherNames)
    add(name, make_menu_help(name), [opened = page](Host& host, Arguments) { open_menu(host, opened); });
  add("slist", "Lists the servers on the local network.", [](Host& host, Arguments) { list_servers(host); });
  for (const char* const name : {"vid_restart", "vid_test"})
    add(name, "Applies the video settings to the window again.", [](Host& host, Arguments) {
      print_if_command_error(host, host.services.window.apply(host.variables.window()));
    });
  add("togglemenu", "Opens or closes the menu.", [](Host& host, Arguments) { toggle_menu(host); });
  add("toggleconsole", "Opens or closes the console.",
      [](Host& host, Arguments) { host.console.ui.toggle(); });
  add("messagemode", "Opens a prompt to chat with all players.",
      [](Host& host, Arguments) { host.console.ui.begin_chat(false); });
  add("messagemode2", "Opens a prompt to chat with your team.",
      [](Host& host, Arguments) { host.console.ui.begin_chat(true); });
  add("clear", "Clears the console.", [](Host& host, Arguments) { host.console.ui.clear(); });
  add("condump", "condump [FILE]: saves the console's text. Default file: condump.txt.",
      [](Host& host, Arguments arguments) {
        print_if_command_error(host, dump_console(host, arguments.size() > 1 ? arguments[1] : "condump.txt"));
      });
  add("bind_defaults", "Restores the default key bindings.",
      [](Host& host, Arguments) { restore_default_bindings(host); });
  add("screenshot", "screenshot [FILE]: saves the picture as a PNG. Without a name: the next free number.",
      [](Host& host, Arguments arguments) {
        print_if_command_error(host, write_screenshot(host, arguments.size() > 1 ? arguments[1] : ""));
      });
  add("viewpos", "Prints the camera's position and angles.",
      [](Host& host, Arguments) { print_camera(host); });
  add("sizeup", "Shows less of the status bar.", [](Host& host, Arguments) { change_view_size(host, 10); });
  add("sizedown", "Shows more of the status bar.",
      [](Host& host, Arguments) { change_view_size(host, -10); });
}

// Returns the folders of a `game` command. "game mymod -hipnotic" puts the mod on top of the pack, as in
// other engines.
std::vector<std::string> list_games(Arguments words) {
  std::vector<std::string> packs, mods;
  for (const std::string& word : words) {
    const std::optional<std::string_view> pack = assets::find_pack_folder(word);
    (pack ? packs : mods).emplace_back(pack.value_or(word));
  }
  packs.insert(packs.end(), mods.begin(), mods.end());
  return packs;
}

// The switch waits for the end of the frame's commands, like that of `game`.
void choose_source(Host& io_host, Arguments arguments) {
  const std::vector<GameSource>& sources = io_host.options.sources;
  if (arguments.size() < 2) {
    print_line(io_host, fmt::format("Playing {}", io_host.options.folders.base_folder.string()));
    for (const GameSource& source : sources)
      print_line(io_host, fmt::format("basedir {}: {}", command::join_words({source.name}), source.title));
    return;
  }
  if (arguments.size() > 2)
    return print_command_error(io_host, "basedir takes one folder. Put quotes around a name with spaces.");
  const auto found = std::find_if(sources.begin(), sources.end(),
                                  [&](const GameSource& source) { return source.name == arguments[1]; });
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::absolute(arguments[1], failure);
  io_host.game.requested_source =
      found != sources.end() ? *found : GameSource{folder.string(), folder.string(), folder};
}

constexpr std::string_view kSaveHelp =
    "save NAME [TITLE]: saves a single-player game; the menu shows the title.";

void save_command(Host& io_host, Arguments arguments) {
  if (arguments.size() < 2) return print_command_error(io_host, kSaveHelp);
  if (arguments.size() > 3)
    return print_command_error(io_host, "save: put quotes around a title with spaces");
  print_if_command_error(
      io_host, save_game(io_host, arguments[1], arguments.size() == 3 ? arguments[2] : std::string_view()));
}

void add_game_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  add_named(io_host, "map", "map NAME: starts a new game on a level. Type maps to list all levels.",
            start_map);
  add("save", std::string(kSaveHelp), save_command);
  add_named(io_host, "load", "load NAME: loads a saved game.", load_game);
  add_named(io_host, "connect", "connect HOST[:PORT]: joins a game on a server.", connect_to_server);
  add("stuffcmds",
      "Runs the commands of the command line again. In quake.rc it does nothing: they run after it.",
      run_command_line_again);
  add("reconnect", "Joins the last server again.", [](Host& host, Arguments) {
    const std::string address = host.game.last_server;
    if (address.empty()) return print_command_error(host, "reconnect: you have not joined a server yet");
    print_if_command_error(host, connect_to_server(host, address));
  });
  add("disconnect", "Leaves the game.", [](Host& host, Arguments) { disconnect(host); });
  add("killserver", "Ends the game on this machine.", [](Host& host, Arguments) {
    if (host.game.session->server() != nullptr) disconnect(host);
  });
  add("resetcfg", "Resets all variables to their defaults.",
      [](Host& host, Arguments) { host.console.commands.execute("resetall"); });
  add("quit", "Quits Temblor.", [](Host& host, Arguments) { quit(host); });
  add("maps", "Lists all levels.", [](Host& host, Arguments) { list_levels(host); });
  add("color", "color SHIRT [PANTS]: sets your colors, 0 to 13.", set_colors);
  add("game",
      "game FOLDER...: switches to these mods; -hipnotic, -quoth, or -rogue puts them on that mission pack. "
      "Without an argument: lists the folders in use.",
      [](Host& host, Arguments arguments) {
        // The switch waits for the end of the frame's commands: it replaces the files that this command may
        // come from, and the menu that may have sent it.
        if (arguments.size() > 1) {
          host.game.requested_games = list_games(arguments.subspan(1));
          return;
        }
        for (const std::filesystem::path& folder : host.game.data->library.files().folders())
          print_line(host, folder.string());
      });
  add("basedir",
      "basedir FOLDER: plays the game data in this folder, now and from the next start on; `basedir temblor` "
      "is Temblor's own game. Without an argument: lists the game data that was found.",
      choose_source);
  add("writeconfig", "writeconfig [FILE]: saves the settings now, or a copy of them in another .cfg file.",
      [](Host& host, Arguments arguments) {
        print_if_command_error(
            host, write_configuration(host, arguments.size() > 1 ? arguments[1] : kConfigurationFile));
      });
  add("cmd", "cmd TEXT: sends a command to the server as it is.", [](Host& host, Arguments arguments) {
    if (arguments.size() < 2) return print_command_error(host, "cmd TEXT: name a command of the server");
    if (client::Connection* const connection = host.game.session->connection())
      return connection->send_command(join_arguments(arguments.subspan(1)));
    print_command_error(host, "cmd: start or join a game first");
  });
}

}  // namespace

void add_host_commands(Host& io_host) {
  add_list_commands(io_host);
  add_location_command(io_host);
  add_view_commands(io_host);
  add_sound_commands(io_host);
  add_player_commands(io_host);
  add_server_commands(io_host);
  add_game_commands(io_host);
  add_lockstep_commands(io_host);
  add_demo_commands(io_host);
  add_screen_commands(io_host);
}

}  // namespace temblor::host
