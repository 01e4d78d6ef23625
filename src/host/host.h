// The game in a window: it owns all parts of a running game and runs them frame by frame.
//
// A frame is a list of stages, always in this order (docs/architecture.md):
//
//   wait -> input -> console commands -> settings -> network -> look and move -> scene -> sound -> draw, show
//                                                                                                  |
//                                                                                  our own server's ticks,
//                                                                                  in parallel
//
// The program calls run_frame() in a loop until it returns false. All functions must be called from the
// thread that created the window. The parts and the stages are private to src/host (frame/host_parts.h,
// frame/frame_stages.h). This header does not include them, so that the program does not depend on the whole
// engine.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "host/game_folders.h"

namespace temblor::host {

struct Services;      // host/services.h
class HostVariables;  // host/host_variables.h

// Game data that the player can choose in the menu.
struct GameSource {
  std::string name;   // the argument of the command `basedir`
  std::string title;  // for people
  std::filesystem::path base_folder;
  bool is_installed = false;  // see GameFolders
};

struct HostOptions {
  GameFolders folders;
  // Game data to choose from; empty: there is no choice.
  std::vector<GameSource> sources{};
  // Opens the menu of the sources at the start, unless the command line starts a game.
  bool asks_for_source = false;
  // Stores the player's choice, an argument of `basedir`, for the next run. Null: it cannot be stored.
  std::function<base::Status(std::string_view name)> remember_source{};
  std::filesystem::path program_file{};  // the game's code; empty: progs.dat of the game folders
  std::vector<std::string> commands{};   // run after the configuration files
  // Run once, as soon as the player is in a game.
  std::vector<std::string> commands_in_game{};
  std::string version{};  // "Temblor 1.0", shown in the console
  // Sets the variables that the command line names. Called each time after the configuration files have run,
  // also when the player switches to another mod. The values hold for this run only and are not saved, unless
  // the player changes them (session/overrides.h). Null: the command line sets no variables.
  std::function<base::Status()> apply_overrides{};
};

// Measured in the last frame, in seconds.
struct FrameTimes {
  double frame_s = 0;    // from the start of the previous frame to the start of this one
  double drawing_s = 0;  // from the scene to the finished picture
  double present_s = 0;  // tone, scaling and the handover to the window, including any wait for vsync
  // Input-to-screen latency: from the frame's oldest input event until its picture is shown. 0: no event.
  double latency_s = 0;
};

// The running game. Opaque outside src/host.
struct Host;
struct HostDeleter {
  void operator()(Host* host) const;
};
using HostPointer = std::unique_ptr<Host, HostDeleter>;

// Opens the game folders and the window, and runs the configuration files. Fails if the game folders or the
// window cannot be used. `variables` must outlive the host.
base::Result<HostPointer> start_host(Services services, const HostVariables& variables, HostOptions options);

// Runs one frame. Returns false after the last one, when the game has been left and the configuration saved.
bool run_frame(Host& io_host);
// Makes the current frame the last one.
void quit(Host& io_host);
const FrameTimes& frame_times(const Host& host);

// Returns the name of the level that the player is in, such as "e1m1". Empty in menus, in demos, and while a
// level is loaded.
std::string find_played_level(const Host& host);

// Queues console commands, separated by newlines or semicolons. The next frame runs them.
void append_commands(Host& io_host, std::string_view lines);

}  // namespace temblor::host
