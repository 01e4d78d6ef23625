#include "client/hud_program/hud_program.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "assets/new_file.h"
#include "base/text.h"
#include "client/hud/panel.h"
#include "client/hud_program/program_call.h"
#include "formats/game/progs.h"

namespace temblor::client {
namespace {

constexpr std::string_view kProgramFile = "csprogs.dat";

// The functions that the engine calls; kNoFunction for those that the program lacks.
struct EntryPoints {
  vm::FunctionIndex init, world_loaded, shutdown, draw_hud, draw_scores, update_view, input_event,
      console_command, parse_center_print, parse_print, parse_stuffed;

  explicit EntryPoints(const vm::Program& program)
      : init(program.find_function("CSQC_Init")),
        world_loaded(program.find_function("CSQC_WorldLoaded")),
        shutdown(program.find_function("CSQC_Shutdown")),
        draw_hud(program.find_function("CSQC_DrawHud")),
        draw_scores(program.find_function("CSQC_DrawScores")),
        update_view(program.find_function("CSQC_UpdateView")),
        input_event(program.find_function("CSQC_InputEvent")),
        console_command(program.find_function("CSQC_ConsoleCommand")),
        parse_center_print(program.find_function("CSQC_Parse_CenterPrint")),
        parse_print(program.find_function("CSQC_Parse_Print")),
        parse_stuffed(program.find_function("CSQC_Parse_StuffCmd")) {}

  bool can_draw() const { return draw_hud != vm::kNoFunction || update_view != vm::kNoFunction; }
};

// A built-in function is no entry point: calling it from outside would have no caller to name.
base::Result<std::shared_ptr<const vm::Program>> load_program(const base::ByteVector& bytes) {
  TRY(formats::Progs progs, formats::read_progs(bytes));
  return vm::Program::load(std::move(progs));
}

// An arrow of rows that become longer, white on black.
base::Status draw_cursor(const math::Vec2& place, ProgramCanvas& io_canvas) {
  constexpr int kRows = 8;
  io_canvas.reset_clip();
  for (const auto& [margin, rgb] : {std::pair(1.0f, math::Vec3(0.0f)), std::pair(0.0f, math::Vec3(1.0f))})
    for (int row = 0; row < kRows; ++row) {
      const auto length = static_cast<float>(row + 1);
      const math::Vec2 corner = place + math::Vec2(0, static_cast<float>(row));
      TRY_STATUS(io_canvas.fill({corner - margin, math::Vec2(length, 1) + 2 * margin}, {rgb}));
    }
  return base::Ok{};
}

}  // namespace

struct HudProgram::Running {
  // While an object of this class exists, the program sees this game; before and after, an empty one.
  class GameScope {
   public:
    GameScope(Running& io_running, const Game& game) : running_(io_running) {
      io_running.context.game = &game;
    }
    ~GameScope() { running_.context.game = &running_.no_game; }
    GameScope(const GameScope&) = delete;
    GameScope& operator=(const GameScope&) = delete;

   private:
    Running& running_;
  };

  Running(std::shared_ptr<const vm::Program> program, const HudProgramServices& services)
      : machine(std::move(program), kHudProgramLimits),
        entries(machine.program()),
        context{.shared = {.variables = services.variables,
                           .random = [this] { return next_random(); },
                           .time_s = [this] { return context.moment.time_s; },
                           .print = services.print,
                           .find_pack = [&files = services.library.files()](
                                            std::string_view file) { return files.where(file); }},
                .services = services,
                .canvas = ProgramCanvas(services.palette),
                .pictures = ProgramPictures(services.library, services.pictures, services.palette),
                .game = &no_game} {
    context.shared.files = builtins::ScriptFiles(
        {}, [&files = services.library.files()](std::string_view name) { return files.read(name); });
    add_program_builtins(machine, context);
  }

  // Not the server's: a HUD must not change the game. Linear congruential (Knuth, "The Art of Computer
  // Programming", volume 2, MMIX).
  float next_random() {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<float>(random >> 49) / 32767.0f;
  }

  // Calls a function with the parameters that are set. Does nothing if the program lacks it.
  base::Status call(vm::FunctionIndex function) {
    if (function == vm::kNoFunction) return base::Ok{};
    const base::Status status = machine.call(function);
    if (status.ok()) machine.collect_strings();
    return status;
  }
  base::Status set_text(int parameter, std::string_view text) {
    TRY(const vm::StringIndex string, machine.make_string(text));
    machine.set_parameter_string(parameter, string);
    return base::Ok{};
  }

  const Game no_game;
  vm::Machine machine;
  EntryPoints entries;
  ProgramContext context;
  std::uint64_t random = 1;
  // The center text that the program has seen.
  std::string center_text;
  double center_text_since_s = -1;
  bool owns_center_text = false;
};

HudProgram::HudProgram(HudProgramServices services) : services_(std::move(services)) {}

HudProgram::~HudProgram() {
  begin_level();
}

void HudProgram::begin_level() {
  // An error at this point no longer matters.
  if (running_)
    if (const base::Status status = running_->call(running_->entries.shutdown); !status.ok())
      running_.reset();
  running_.reset();
  is_loaded_ = false;
  drawing_ = {};
}

const render::DrawList& HudProgram::draw_list() const {
  static const render::DrawList kEmpty;
  return running_ ? running_->context.canvas.list() : kEmpty;
}

void HudProgram::fail(const base::Error& error) {
  running_.reset();
  drawing_ = {};
  const std::string text = error.message();
  if (text == last_failure_ || !services_.print) return;
  last_failure_ = text;
  services_.print(
      fmt::format("{}: {}\nThe built-in HUD draws instead. cl_nocsqc 1 turns such programs off.\n",
                  services_.library.files().describe(kProgramFile), text));
}

bool HudProgram::exists() const {
  return services_.library.files().contains(kProgramFile);
}

// A game without the file has no program, which is no error.
void HudProgram::start(const Game& game) {
  is_loaded_ = true;
  const base::Result<base::ByteVector> bytes =
      assets::read_new_file(services_.library.files(), std::string(kProgramFile));
  if (!bytes.ok()) return fail(bytes.error());
  if (bytes->empty()) return;
  base::Result<std::shared_ptr<const vm::Program>> program = load_program(*bytes);
  if (!program.ok()) return fail(program.error());
  running_ = std::make_unique<Running>(*std::move(program), services_);
  if (!running_->entries.can_draw()) {
    running_.reset();
    return;
  }
  constexpr float kApiVersion = 1, kEngineVersion = 1;
  vm::Machine& machine = running_->machine;
  const auto initialize = [&]() -> base::Status {
    const Running::GameScope scope(*running_, game);
    machine.set_parameter_float(0, kApiVersion);
    TRY_STATUS(running_->set_text(1, "Temblor"));
    machine.set_parameter_float(2, kEngineVersion);
    TRY_STATUS(running_->call(running_->entries.init));
    return running_->call(running_->entries.world_loaded);
  };
  if (const base::Status status = initialize(); !status.ok()) fail(status.error());
}

// A new text is offered to the program once. If it takes the text, the built-in HUD does not show it.
base::Status HudProgram::pass_center_print(const Game& game) {
  Running& program = *running_;
  if (program.center_text_since_s == game.center_text_since_s && program.center_text == game.center_text)
    return base::Ok{};
  program.center_text = game.center_text;
  program.center_text_since_s = game.center_text_since_s;
  program.owns_center_text = false;
  if (game.center_text.empty() || program.entries.parse_center_print == vm::kNoFunction) return base::Ok{};
  TRY_STATUS(program.set_text(0, game.center_text));
  TRY_STATUS(program.call(program.entries.parse_center_print));
  program.owns_center_text = program.machine.returned_float() != 0;
  return base::Ok{};
}

bool HudProgram::take_ping_request() {
  return running_ && std::exchange(running_->context.wants_pings, false);
}

base::Status HudProgram::pass_print(const Game& game, std::string_view text) {
  constexpr char kChat = 1;  // begins what a player says
  constexpr float kEventLevel = 2, kChatLevel = 3;
  const Running::GameScope scope(*running_, game);
  TRY_STATUS(running_->set_text(0, text));
  running_->machine.set_parameter_float(1, text.starts_with(kChat) ? kChatLevel : kEventLevel);
  return running_->call(running_->entries.parse_print);
}

bool HudProgram::take_print(const Game& game, std::string_view text) {
  if (!running_ || running_->entries.parse_print == vm::kNoFunction) return false;
  const base::Status status = pass_print(game, text);
  if (!status.ok()) fail(status.error());
  return status.ok();
}

base::Status HudProgram::pass_stuffed(const Game& game, std::string_view line) {
  const Running::GameScope scope(*running_, game);
  TRY_STATUS(running_->set_text(0, fmt::format("{}\n", line)));
  running_->context.runs_stuffed = true;
  const base::Status status = running_->call(running_->entries.parse_stuffed);
  running_->context.runs_stuffed = false;
  return status;
}

bool HudProgram::take_stuffed(const Game& game, std::string_view line) {
  if (!running_ || running_->entries.parse_stuffed == vm::kNoFunction) return false;
  const base::Status status = pass_stuffed(game, line);
  if (!status.ok()) fail(status.error());
  return status.ok();
}

base::Status HudProgram::draw_hud(const HudMoment& moment) {
  Running& program = *running_;
  const math::Vec2 size = program.context.canvas.virtual_size();
  const auto draw = [&](vm::FunctionIndex function) {
    program.machine.set_parameter_vector(0, math::Vec3(size, 0));
    program.machine.set_parameter_float(1, moment.shows_scores ? 1 : 0);
    return program.call(function);
  };
  const Game& game = *program.context.game;
  const bool has_scores = program.entries.draw_scores != vm::kNoFunction;
  drawing_.parts.bars = false;
  drawing_.parts.scores = !has_scores;
  bool needs_scores = moment.shows_scores || (game.deathmatch && game.stat(Stat::kHealth) <= 0);
  if (game.ending == Ending::kNone) {
    TRY_STATUS(draw(program.entries.draw_hud));
  } else {
    // The scores are the screen after a level. The built-in screens of a finale stay.
    needs_scores = game.ending == Ending::kIntermission;
    drawing_.parts.ending = !(needs_scores && has_scores);
  }
  return needs_scores && has_scores ? draw(program.entries.draw_scores) : base::Status(base::Ok{});
}

base::Status HudProgram::draw_view(const HudMoment& moment) {
  Running& program = *running_;
  const math::Vec2 size = program.context.canvas.virtual_size();
  program.context.view = {};
  program.machine.set_parameter_float(0, size.x);
  program.machine.set_parameter_float(1, size.y);
  program.machine.set_parameter_float(2, moment.is_menu_open ? 0 : 1);
  TRY_STATUS(program.call(program.entries.update_view));
  const ProgramView& view = program.context.view;
  drawing_.shows_view = view.is_rendered;
  drawing_.parts.crosshair = view.draws_crosshair;
  drawing_.parts.bars = drawing_.parts.scores = drawing_.parts.hints = view.draws_bar;
  drawing_.parts.ending = view.draws_bar || program.context.game->ending != Ending::kIntermission;
  return base::Ok{};
}

base::Status HudProgram::draw_frame(const Game& game, const HudMoment& moment) {
  Running& program = *running_;
  ProgramContext& context = program.context;
  const Running::GameScope scope(program, game);
  context.moment = moment;
  set_program_globals(game, moment, program.machine);
  context.canvas.begin(moment.width, moment.height, choose_scale(moment.width, moment.height, moment.size));
  TRY_STATUS(pass_center_print(game));
  drawing_.is_active = true;
  context.may_draw = true;
  const base::Status status =
      program.entries.draw_hud != vm::kNoFunction ? draw_hud(moment) : draw_view(moment);
  if (status.ok() && context.cursor) TRY_STATUS(draw_cursor(*context.cursor, context.canvas));
  context.may_draw = false;
  drawing_.parts.center_text = !program.owns_center_text;
  return status;
}

void HudProgram::draw(const Game& game, const HudMoment& moment) {
  drawing_ = {};
  if (!is_loaded_) start(game);
  if (!running_) return;
  if (const base::Status status = draw_frame(game, moment); !status.ok()) fail(status.error());
}

base::Result<bool> HudProgram::pass_event(const Game& game, const platform::InputEvent& event) {
  constexpr float kKeyDown = 0, kKeyUp = 1, kMouseMoved = 2, kMouseAt = 3;
  vm::Machine& machine = running_->machine;
  std::optional<math::Vec2>& cursor = running_->context.cursor;
  bool moves_cursor = false;
  const Running::GameScope scope(*running_, game);
  const auto set = [&](float type, float a, float b) {
    machine.set_parameter_float(0, type);
    machine.set_parameter_float(1, a);
    machine.set_parameter_float(2, b);
    machine.set_parameter_float(3, 0);  // the device
  };
  if (const auto* key = std::get_if<platform::KeyChange>(&event.what)) {
    const int number = program_key(key->key);
    if (number == 0 || key->repeated) return false;
    const int character = number >= ' ' && number < 127 ? number : 0;
    set(key->down ? kKeyDown : kKeyUp, static_cast<float>(number), static_cast<float>(character));
  } else if (const auto* mouse = std::get_if<platform::MouseMoved>(&event.what)) {
    moves_cursor = cursor.has_value();
    if (cursor) *cursor = running_->context.canvas.move_point(*cursor, mouse->right, mouse->down);
    if (cursor)
      set(kMouseAt, cursor->x, cursor->y);
    else
      set(kMouseMoved, mouse->right, mouse->down);
  } else {
    return false;
  }
  TRY_STATUS(running_->call(running_->entries.input_event));
  return moves_cursor || machine.returned_float() != 0;
}

bool HudProgram::handle_event(const Game& game, const platform::InputEvent& event) {
  if (!running_ || running_->entries.input_event == vm::kNoFunction) return false;
  const base::Result<bool> is_consumed = pass_event(game, event);
  if (!is_consumed.ok()) fail(is_consumed.error());
  return is_consumed.ok() && *is_consumed;
}

base::Status HudProgram::pass_command(const Game& game, std::string_view line) {
  const Running::GameScope scope(*running_, game);
  TRY_STATUS(running_->set_text(0, line));
  return running_->call(running_->entries.console_command);
}

bool HudProgram::run_command(const Game& game, std::string_view line) {
  if (!is_loaded_) start(game);
  if (!running_ || running_->entries.console_command == vm::kNoFunction) return false;
  const std::string name = base::to_lower(line.substr(0, line.find(' ')));
  if (!running_->context.commands.contains(name)) return false;
  if (const base::Status status = pass_command(game, line); !status.ok()) fail(status.error());
  return true;
}

}  // namespace temblor::client
