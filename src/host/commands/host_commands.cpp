#include "host/commands/host_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/text.h"
#include "command/text.h"
#include "host/host.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

struct NamedHelp {
  std::string_view name, help;
  std::size_t least_words = 0;  // behind the name
};

// Said to the server, on the player's behalf.
constexpr std::array kPlayerCommands = {
    NamedHelp{"say", "say WORDS speaks to everybody.", 1},
    NamedHelp{"say_team", "say_team WORDS speaks to the own side.", 1},
    NamedHelp{"tell", "tell NAME WORDS speaks to one player.", 2},
    NamedHelp{"ping", "Shows how long everybody's way to the server is."},
    NamedHelp{"status", "Shows the level and who plays."},
    NamedHelp{"pause", "Stops time, or lets it go on."},
    NamedHelp{"kill", "Ends this life."},
    NamedHelp{"god", "Nothing hurts any more; again: it does."},
    NamedHelp{"notarget", "Monsters do not see the player; again: they do."},
    NamedHelp{"noclip", "Walks through everything; again: not."},
    NamedHelp{"fly", "Flies; again: walks."},
    NamedHelp{"give",
              "give all; give weapons, ammo, keys; give 2 to 8; give h 100: health, armor (a), shells (s), "
              "nails (n), rockets (r), cells (c).",
              1},
    NamedHelp{"rcon", "rcon PASSWORD COMMAND runs a command on the server.", 2},
};

// Run by the server that runs here.
constexpr std::array kServerCommands = {
    NamedHelp{"changelevel", "changelevel NAME goes on in another level with what players have."},
    NamedHelp{"restart", "Starts the level again."},
    NamedHelp{"reload", "Takes up the game's code and the level as they are on disk now."},
    NamedHelp{"kick", "kick NAME or #NUMBER, then a reason: lets go of a player."},
    NamedHelp{"ban", "ban ADDRESS, ADDRESS/BITS or a player: refuses them from now on; alone: lists them."},
    NamedHelp{"unban", "unban ADDRESS takes back a ban."},
    NamedHelp{"profile", "Functions of the game's code that took the most instructions since the last time."},
    NamedHelp{"edict", "edict NUMBER shows the fields of an entity."},
};

// What stock games have their players run: nothing of it changes settings or reaches files.
constexpr std::array<std::string_view, 8> kMayBeStuffed = {
    "play", "playvol", "stopsound", "centerview", "bf", "cd", "music", "force_centerview"};

// Whether a command was given what it takes, one name; else says so.
bool has_one_name(Host& io_host, Arguments arguments, std::string_view help) {
  if (arguments.size() == 2) return true;
  io_host.console().print_error(
      arguments.size() < 2
          ? std::string(help)
          : fmt::format("{} takes one name; quotes hold one with blanks together", arguments[0]));
  return false;
}

void print_error(Host& io_host, const base::Status& status) {
  if (!status.ok()) io_host.console().print_error(status.error().message());
}

std::string line_of(Arguments arguments) {
  return command::join_words(std::vector<std::string>(arguments.begin(), arguments.end()));
}

void add_player_commands(Host& io_host) {
  for (const NamedHelp& entry : kPlayerCommands)
    io_host.console().add_command(entry.name, entry.help, [host = &io_host, entry](Arguments arguments) {
      if (arguments.size() <= entry.least_words) return host->console().print_error(entry.help);
      if (client::Connection* const connection = host->session().connection())
        return connection->send_command(line_of(arguments));
      host->console().print_error(fmt::format("{}: not in a game", arguments[0]));
    });
}

void add_server_commands(Host& io_host) {
  for (const NamedHelp& entry : kServerCommands)
    io_host.console().add_command(entry.name, entry.help, [host = &io_host](Arguments arguments) {
      if (server::Server* const server = host->session().server())
        return server->console().execute(line_of(arguments));
      host->console().print_error(fmt::format("{}: no game runs here; `map NAME` begins one", arguments[0]));
    });
}

void color_command(Host& io_host, Arguments arguments) {
  if (arguments.size() < 2) return io_host.console().print_error("color SHIRT [TROUSERS]: 0 to 13");
  command::Variables& variables = io_host.variables().variables();
  print_error(io_host, variables.set("topcolor", arguments[1]));
  print_error(io_host, variables.set("bottomcolor", arguments[arguments.size() > 2 ? 2 : 1]));
}

void list_levels(Host& io_host) {
  for (const std::string& file : io_host.data().library.files().list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    if (!name.starts_with("b_")) io_host.print(name);
  }
}

// As `render --pos --angles` takes them, so that a place can be shown to others.
void tell_view(Host& io_host) {
  const std::optional<render::Camera> view = io_host.view();
  if (!view) return io_host.console().print_error("viewpos: there is no view; `map NAME` begins a game");
  const auto written = [](const math::Vec3& v, std::string_view between) {
    return fmt::format("{1}{0}{2}{0}{3}", between, std::lround(v.x), std::lround(v.y), std::lround(v.z));
  };
  const math::Vec3& eye = view->origin_world;
  const math::Vec3& angles = view->angles_deg;
  io_host.print(fmt::format("eyes at {} (units), looking {} (pitch, yaw, roll in degrees)", written(eye, " "),
                            written(angles, " ")));
  io_host.print(fmt::format("render --pos {} --angles {}", written(eye, ","), written(angles, ",")));
}

void change_view_size(Host& io_host, int step) {
  command::Variables& variables = io_host.variables().variables();
  const command::Variable& size = *variables.find("viewsize");
  const double wanted = std::clamp(size.number + step, size.min, size.max);
  print_error(io_host, variables.set("viewsize", std::to_string(static_cast<int>(wanted))));
}

// Commands are plain functions of host and words.
auto adder(Host& io_host) {
  return [&io_host](std::string_view name, std::string_view help, auto run) {
    io_host.console().add_command(name, help,
                                  [host = &io_host, run](Arguments arguments) { run(*host, arguments); });
  };
}

// The number behind the command's name; nothing where there is none, and says so.
std::optional<double> told_number(Host& io_host, Arguments arguments) {
  const auto number = arguments.size() == 2 ? command::parse_number(arguments[1]) : std::nullopt;
  if (!number) io_host.console().print_error(fmt::format("{}: give one number", arguments[0]));
  return number;
}

// The recording that plays; null where none does, and says so.
client::DemoSession* playing_demo(Host& io_host, Arguments arguments) {
  if (io_host.demo() == nullptr)
    io_host.console().print_error(fmt::format("{}: no recording is playing", arguments[0]));
  return io_host.demo();
}

void seek(Host& io_host, Arguments arguments) {
  const client::DemoSession* const demo = playing_demo(io_host, arguments);
  const std::optional<double> number_s = demo == nullptr ? std::nullopt : told_number(io_host, arguments);
  if (!number_s) return;
  const bool is_step = arguments[1].starts_with('+') || arguments[1].starts_with('-');
  print_error(io_host, io_host.seek_demo((is_step ? demo->time_s() : demo->begin_s()) + *number_s));
}

void add_demo_commands(Host& io_host) {
  const auto add = adder(io_host);
  const auto add_named = [&](std::string_view name, std::string_view help,
                             base::Status (Host::*run)(std::string_view)) {
    add(name, help, [run, help](Host& host, Arguments arguments) {
      if (!has_one_name(host, arguments, help)) return;
      print_error(host, (host.*run)(arguments[1]));
    });
  };
  add_named("playdemo",
            "playdemo NAME shows a recording: Space stops it, the arrows seek and change its speed.",
            &Host::play_demo);
  add_named("timedemo", "timedemo NAME draws every update of a recording as fast as it can.",
            &Host::time_demo);
  add_named("record", "record NAME records what is seen, until `stop`.", &Host::record);
  add("stop", "Ends the recording that is being made.",
      [](Host& host, Arguments) { print_error(host, host.stop_recording()); });
  add("startdemos", "startdemos NAME... shows recordings behind the menus, one after another, for ever.",
      [](Host& host, Arguments arguments) {
        if (arguments.size() < 2) return host.print("startdemos NAME...");
        host.attract({arguments.begin() + 1, arguments.end()});
      });
  add("stopdemo", "Leaves the recording that is playing.", [](Host& host, Arguments) { host.stop_demo(); });
  add("demo_pause", "Stops a recording, or lets it go on.", [](Host& host, Arguments arguments) {
    if (client::DemoSession* const demo = playing_demo(host, arguments)) demo->pause(!demo->is_paused());
  });
  add("demo_speed", "demo_speed TIMES: 0.1 to 8.", [](Host& host, Arguments arguments) {
    client::DemoSession* const demo = playing_demo(host, arguments);
    const std::optional<double> speed = demo == nullptr ? std::nullopt : told_number(host, arguments);
    if (speed) demo->set_speed(*speed);
  });
  add("demo_seek", "demo_seek SECONDS goes to that moment; +SECONDS and -SECONDS on and back.", seek);
}

void add_screen_commands(Host& io_host) {
  const auto add = adder(io_host);
  for (const client::MenuCommand& menu : client::menu_commands())
    io_host.console().add_command(menu.name, "Opens a page of the menus.",
                                  [host = &io_host, page = menu.page](Arguments) { host->open_menu(page); });
  add("togglemenu", "Opens the menus, or closes them.", [](Host& host, Arguments) { host.toggle_menu(); });
  add("toggleconsole", "Opens the console, or closes it.",
      [](Host& host, Arguments) { host.console_ui().toggle(); });
  add("messagemode", "Says something to everybody.",
      [](Host& host, Arguments) { host.console_ui().begin_chat(false); });
  add("messagemode2", "Says something to the own side.",
      [](Host& host, Arguments) { host.console_ui().begin_chat(true); });
  add("clear", "Empties the console.", [](Host& host, Arguments) { host.console_ui().clear(); });
  add("condump", "condump [FILE] writes what the console has shown to a file.",
      [](Host& host, Arguments arguments) {
        print_error(host, host.dump_console(arguments.size() > 1 ? arguments[1] : "condump.txt"));
      });
  add("bind_defaults", "Gives all keys what they run at first.", [](Host& host, Arguments) {
    host.bindings().unbind_all();
    host.bindings().add_defaults();
  });
}

void add_game_commands(Host& io_host) {
  const auto add = adder(io_host);
  // Those with one name behind them.
  const auto add_named = [&](std::string_view name, std::string_view help,
                             base::Status (Host::*run)(std::string_view)) {
    io_host.console().add_command(name, help, [host = &io_host, run, help](Arguments arguments) {
      if (!has_one_name(*host, arguments, help)) return;
      print_error(*host, (host->*run)(arguments[1]));
    });
  };
  add_named("map", "map NAME begins a new game on a level; maps lists them.", &Host::start_map);
  add_named("save", "save NAME keeps the game of a single player.", &Host::save_game);
  add_named("load", "load NAME goes on from a saved game.", &Host::load_game);
  add_named("connect", "connect HOST[:PORT] joins a game on another machine.", &Host::connect);
  add("disconnect", "Leaves the game.", [](Host& host, Arguments) { host.disconnect(); });
  add("quit", "Ends the program.", [](Host& host, Arguments) { host.quit(); });
  add("maps", "Lists the levels that there are.", [](Host& host, Arguments) { list_levels(host); });
  add("viewpos", "Tells where the eyes are, in units, and where they look, in degrees.",
      [](Host& host, Arguments) { tell_view(host); });
  add("color", "color SHIRT [TROUSERS] of the player, 0 to 13.", color_command);
  add("sizeup", "Shows less of the status bar.", [](Host& host, Arguments) { change_view_size(host, 10); });
  add("sizedown", "Shows more of the status bar.",
      [](Host& host, Arguments) { change_view_size(host, -10); });
  add("game", "game FOLDER... plays other game folders besides id1; alone: says which ones.",
      [](Host& host, Arguments arguments) {
        if (arguments.size() > 1) return host.ask_for_games({arguments.begin() + 1, arguments.end()});
        for (const std::filesystem::path& folder : host.data().library.files().folders())
          host.print(folder.string());
      });
  add("screenshot", "screenshot [FILE] writes the picture as a PNG; without a name: the next free number.",
      [](Host& host, Arguments arguments) {
        print_error(host, host.screenshot(arguments.size() > 1 ? arguments[1] : ""));
      });
  add("writeconfig", "Saves the settings now instead of at the end.",
      [](Host& host, Arguments) { print_error(host, host.save_configuration()); });
  add("play", "play FILE sounds once: misc/menu1.wav.", [](Host& host, Arguments arguments) {
    if (arguments.size() < 2) return host.console().print_error("play FILE: name a sound");
    for (const std::string& name : arguments.subspan(1)) host.play_sound(name);
  });
  // Said by games' code to stock clients, which change the track or the view's color by them.
  for (const char* const name : {"playvol", "stopsound", "cd", "music", "v_cshift"})
    add(name, "Of stock games; does nothing here.", [](Host&, Arguments) {});
  add("cmd", "cmd WORDS says them to the server as they are.", [](Host& host, Arguments arguments) {
    if (arguments.size() < 2) return host.console().print_error("cmd WORDS: what to say to the server");
    if (client::Connection* const connection = host.session().connection())
      return connection->send_command(line_of(arguments.subspan(1)));
    host.console().print_error("cmd: not in a game");
  });
}

}  // namespace

void add_host_commands(Host& io_host) {
  add_player_commands(io_host);
  add_server_commands(io_host);
  add_game_commands(io_host);
  add_demo_commands(io_host);
  add_screen_commands(io_host);
}

bool may_be_stuffed(std::string_view line) {
  const std::vector<std::string> words = command::split_words(line);
  // One command: what follows a ';' would be run as well.
  return !words.empty() && command::command_length(line) == line.size() &&
         std::find(kMayBeStuffed.begin(), kMayBeStuffed.end(), base::to_lower(words[0])) !=
             kMayBeStuffed.end();
}

}  // namespace temblor::host
