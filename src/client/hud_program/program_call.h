// The context of a built-in function of the HUD program while it runs: the shared Call (builtins/call.h), and
// the state of the client that the function reads.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>

#include "builtins/call.h"
#include "client/hud_program/hud_program.h"
#include "client/hud_program/program_canvas.h"
#include "client/hud_program/program_pictures.h"

namespace temblor::client {

// The requests of CSQC_UpdateView; clearscene() resets them.
struct ProgramView {
  bool is_rendered = false;
  bool draws_bar = false, draws_crosshair = false;
};

struct ProgramContext {
  static constexpr std::size_t kMaxCommands = 256;                       // that registercommand() adds
  static constexpr std::size_t kMaxCommandBytes = std::size_t{1} << 14;  // of localcmd() in one call

  builtins::Context shared;
  const HudProgramServices& services;
  ProgramCanvas canvas;
  ProgramPictures pictures;
  const Game* game = nullptr;  // during a call
  HudMoment moment{};
  bool may_draw = false;  // drawing functions work only while a frame is drawn
  ProgramView view{};
  std::optional<math::Vec2> cursor{};             // in virtual pixels; nothing: the mouse turns the view
  bool wants_pings = false;                       // it has read the ping of a player
  bool runs_stuffed = false;                      // localcmd() runs what the server has sent
  std::set<std::string, std::less<>> commands{};  // in lower case
  std::set<std::uint32_t> free_entities{};
};

class ProgramCall : public builtins::Call {
 public:
  ProgramCall(ProgramContext& io_program, vm::Machine& io_machine, std::string_view name)
      : builtins::Call(io_program.shared, io_machine, name), program(io_program) {}

  ProgramContext& program;
  const Game& game() const { return *program.game; }
};

// The parameters "vector rgb, float alpha, float flag", of which the first has this number. Flag 1 adds, flag
// 2 multiplies, and flag 3 multiplies twice; other values, or none, blend.
inline ProgramColor read_color(const ProgramCall& call, int first) {
  constexpr float kAdditive = 1, kModulate = 2, kModulateTwice = 3;
  const float flag = call.number_or(first + 2, 0);
  return {call.vector(first), call.number(first + 1),
          flag == kAdditive        ? render::DrawMode::kAdd
          : flag == kModulate      ? render::DrawMode::kMultiply
          : flag == kModulateTwice ? render::DrawMode::kMultiplyTwice
                                   : render::DrawMode::kBlend};
}

// One row of a family's table. Number 0: QuakeC can declare it by name only.
struct ProgramEntry {
  int number;
  const char* name;
  base::Status (*function)(ProgramCall& io_call);
};

// Families of functions; each is the table at the end of its source file.
std::span<const ProgramEntry> program_drawing();
std::span<const ProgramEntry> program_text_drawing();
std::span<const ProgramEntry> program_state();    // stats, players, rules
std::span<const ProgramEntry> program_view();     // scene and view properties
std::span<const ProgramEntry> program_console();  // prints, commands, keys, errors
std::span<const ProgramEntry> program_entities();
std::span<const ProgramEntry> program_ignored();  // functions without an effect in a HUD

// Adds all built-in functions, including the shared ones. `io_program` must outlive the machine's calls.
void add_program_builtins(vm::Machine& io_machine, ProgramContext& io_program);

// The value of a stat as a number, whatever its type.
float stat_number(const Game& game, int stat);

// Sets the globals that a program may declare, by name: time, frametime, maxclients, intermission, ...
void set_program_globals(const Game& game, const HudMoment& moment, vm::Machine& io_machine);

// The number of a key in HUD programs, where keys beyond ASCII follow other engines' table; 0: it has none.
int program_key(platform::Key key);
platform::Key key_of_program(int number);

}  // namespace temblor::client
