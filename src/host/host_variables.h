// All console variables of a game: those of the renderer, the client, the server, and the host itself.
//
// The variables are in a command::Variables table, which the console reads and writes by name. The functions
// here convert groups of them to the settings structs of the engine's parts, which know no variables:
//
//   console, *.cfg, command line -> command::Variables -> HostVariables -> render::Settings, ...
//
// Each part registers its own variables (client/*_variables.h, server/server_variables.h,
// video/render_settings.h). Those of the window, the view and the player are registered here.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "command/variables.h"

namespace temblor::render {
struct Settings;
}
namespace temblor::client {
struct ConsoleSettings;
struct InputSettings;
struct PlayerSettings;
struct PresentationSettings;
}  // namespace temblor::client
namespace temblor::platform {
struct WindowSettings;
}
namespace temblor::server {
class ServerVariables;
}

namespace temblor::host {

class Overrides;
struct ReadoutSettings;
enum class StuffedTextRule;
struct ScreenSettings;
enum class GlWindowUse;

struct ZoomSettings {
  float fov_deg = 90, zoom_fov_deg = 30;  // without and with +zoom
  float speed = 8;                        // full zooms per second
};

class HostVariables {
 public:
  // Registers all variables. `variables` must outlive this object.
  explicit HostVariables(command::Variables& variables);
  ~HostVariables();

  command::Variables& variables() const { return *variables_; }
  // The server gets the variables themselves instead of a copy, because the game's code may set them.
  const server::ServerVariables& server() const;

  // The current values. Each call reads the table: copy them before other threads may set variables.
  render::Settings render() const;
  client::PresentationSettings presentation() const;
  client::InputSettings input() const;
  client::ConsoleSettings console() const;
  client::PlayerSettings player() const;
  platform::WindowSettings window() const;
  ScreenSettings screen() const;
  ZoomSettings zoom() const;
  float rumble() const;               // strength, 0 to 1
  double frames_per_second() const;   // maximum frame rate; 0: the display's refresh rate
  std::uint32_t max_players() const;  // of the next game that is started on this machine; 1: single player
  std::uint16_t port() const;         // UDP port of games that others may join; 0: any free port
  bool is_parallel() const;           // server ticks may run in parallel with drawing
  bool plays_start_demos() const;     // behind the menu, when the program starts
  double time_scale() const;          // wanted speed of a local game or demo; 1: normal
  bool pauses_unfocused() const;      // a single-player game halts while another window has the keyboard
  bool mutes_unfocused() const;       // no sound meanwhile
  ReadoutSettings readouts() const;
  // Whether OpenGL draws the view, not the CPU.
  bool uses_gl() const;
  GlWindowUse gl_window() const;
  // The number of the technique in lab::list_techniques(); 0 is the engine itself.
  std::size_t technique() const;
  StuffedTextRule stuffed_text() const;

  // Sets all variables to the defaults that were registered.
  void reset() const;
  // Makes the current values of the player's own variables their defaults, until reset(). Call it after the
  // game's default.cfg, so that to_text() contains what the player has changed since.
  void adopt_game_defaults() const;
  // Returns console commands, one per line, that set the player's own variables that differ from their
  // defaults. `own_values`: this table, or a copy of it without the changes of a server. A variable that the
  // command line overrides appears with the player's own value. Variables of the server are not included.
  std::string to_text(const command::Variables& own_values, const Overrides& overrides) const;

 private:
  struct Registered;
  command::Variables* variables_;
  std::unique_ptr<const Registered> registered_;
};

}  // namespace temblor::host
