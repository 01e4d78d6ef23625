// A HUD that a game's own QuakeC draws: csprogs.dat in the game folders. docs/modding.md describes how to
// write one.
//
//   csprogs.dat -> vm::Program -> vm::Machine (of its own, with its own limits)
//   Game, HudMoment --draw()--> CSQC_DrawHud, CSQC_DrawScores, or CSQC_UpdateView --> HudDrawing
//
// It knows neither the server nor its program. After an error the program rests until the next level, and the
// built-in HUD draws instead; each error is printed once.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "assets/library.h"
#include "assets/pictures.h"
#include "client/hud/hud_parts.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"
#include "command/variables.h"
#include "formats/images/palette.h"
#include "platform/input_event.h"
#include "render/draw_list.h"
#include "vm/machine.h"

namespace temblor::client {

// Everything that the program acts on. References must outlive it; functions may be empty.
struct HudProgramServices {
  const assets::Library& library;
  const assets::Pictures& pictures;
  formats::Palette palette;
  command::Variables& variables;
  std::function<void(std::string_view text)> print{};          // in the game's character set
  std::function<void(std::string_view lines)> run_commands{};  // console lines, to be run later
  std::function<void(std::string_view lines)> run_stuffed{};  // the same, by the rules for the server's lines
  std::function<bool(std::string_view name)> has_command{};
  std::function<std::string(platform::Key key)> binding{};
  std::function<void(std::string_view sample)> play_sound{};
};

// The limits of the program in one call; see ProgramCanvas for those of a frame.
constexpr vm::Limits kHudProgramLimits{.call_depth = 256,
                                       .saved_words = 1 << 16,
                                       .instructions = 4'000'000,
                                       .string_bytes = 8 << 20,
                                       .entities = 4096,
                                       .entity_bytes = 16 << 20};

// The frame to draw.
struct HudMoment {
  double time_s = 0;        // of the server
  double frame_time_s = 0;  // since the last frame
  int width = 0, height = 0;
  HudSize size{};
  bool shows_scores = false;
  bool is_menu_open = false;
  bool is_demo = false, is_own_server = false;
  math::Vec3 view_angles_deg{0.0f}, view_origin{0.0f};
  float fov_deg = 90;
};

// The program's part of a frame.
struct HudDrawing {
  bool is_active = false;  // the program has drawn; otherwise the built-in HUD draws everything
  HudParts parts{};        // of the built-in HUD that the program leaves to it
  bool shows_view = true;  // false: the program did not ask for the view, so the background is black
};

class HudProgram {
 public:
  explicit HudProgram(HudProgramServices services);
  ~HudProgram();
  HudProgram(const HudProgram&) = delete;
  HudProgram& operator=(const HudProgram&) = delete;

  // Whether the game folders have a program.
  bool exists() const;
  // Ends the running program. The next draw() loads it again, and calls CSQC_Init.
  void begin_level();
  // Runs the program for a frame. Without a program, nothing is active.
  void draw(const Game& game, const HudMoment& moment);
  // The result of the last draw(), until the next one.
  const HudDrawing& drawing() const { return drawing_; }
  const render::DrawList& draw_list() const;
  // Forgets the last frame: the built-in HUD draws until the next draw().
  void rest() { drawing_ = {}; }

  // Whether the program has read the ping of a player since the last call.
  bool take_ping_request();

  // CSQC_Parse_Print: offers a text that the server has sent for the console. Returns whether the program has
  // taken it, and prints what it wants itself.
  bool take_print(const Game& game, std::string_view text);
  // CSQC_Parse_StuffCmd: offers a console line of the server, without its end. Returns whether the program
  // has taken it; its localcmd() then runs what it wants to keep.
  bool take_stuffed(const Game& game, std::string_view line);

  // CSQC_InputEvent: returns whether the program consumed the event.
  bool handle_event(const Game& game, const platform::InputEvent& event);
  // CSQC_ConsoleCommand: `line` is a command that the console does not know. Loads the program if this level
  // has no draw() yet. Returns whether the program has registered the command, and handled it.
  bool run_command(const Game& game, std::string_view line);

 private:
  struct Running;

  void start(const Game& game);
  base::Status draw_frame(const Game& game, const HudMoment& moment);
  base::Status draw_hud(const HudMoment& moment);
  base::Status draw_view(const HudMoment& moment);
  base::Status pass_center_print(const Game& game);
  base::Result<bool> pass_event(const Game& game, const platform::InputEvent& event);
  base::Status pass_command(const Game& game, std::string_view line);
  base::Status pass_print(const Game& game, std::string_view text);
  base::Status pass_stuffed(const Game& game, std::string_view line);
  // Ends the program and prints why, if that was not printed before.
  void fail(const base::Error& error);

  HudProgramServices services_;
  std::unique_ptr<Running> running_;
  bool is_loaded_ = false;  // or was tried to, in this level
  std::string last_failure_;
  HudDrawing drawing_;
};

}  // namespace temblor::client
