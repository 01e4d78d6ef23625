// The console on the screen: output, an input line with history and completion, chat, and recent messages
// over the game.
//
//   platform events -> handle() -> edit line -> Enter -> take_commands() -> command::Console
//   game text ------> print() ---> ConsoleLog -> draw() -> render::DrawList
//
// The part has no window, files or clock of its own: the owner passes events and the time, and runs the
// entered lines. Editing follows the shells (Ctrl+A, E, U, K, W; Ctrl+R searches the history backward),
// completion is on Tab. At most one line has the input focus: the console's, or a chat line at the top of the
// screen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/pictures.h"
#include "client/console/console_log.h"
#include "client/console/edit_line.h"
#include "client/console/input_history.h"
#include "client/console/scrollback.h"
#include "command/completion.h"
#include "platform/input_event.h"
#include "render/draw_list.h"

namespace temblor::client {

class ConsoleCanvas;

// The values of the console variables that console_variables.h registers.
struct ConsoleSettings {
  // Original pixels per second; the screen has 200.
  double slide_speed = 300;
  // How long a message stays over the game, and how many rows of messages at most.
  double notify_time_s = 3;
  int notify_rows = 4;
  // Frame pixels per original pixel; 0: chosen from the frame's size.
  int scale = 0;
  // A factor on the scale.
  float text_size = 1;
  // Opacity of the background over a game, 0 to 1.
  float opacity = 1;
  // White on black, without colors or pictures.
  bool high_contrast = false;
};

// The inputs of drawing a frame.
struct ConsoleView {
  const assets::Pictures& pictures;
  // On the clock of print().
  double time_s = 0;
  // False: no game runs, and the console covers the whole frame, open or not.
  bool game_runs = true;
  // Shown in the lower right corner: "Temblor 0.1.0".
  std::string_view version;
  ConsoleSettings settings;
};

// Services that the owner provides; each may be empty.
struct ConsolePorts {
  std::function<command::Completion(std::string_view line)> complete;
  std::function<std::string()> read_clipboard;
  std::function<void(std::string_view text)> write_clipboard;
};

// Owns the log, the input lines and the history.
class ConsoleUi {
 public:
  explicit ConsoleUi(ConsolePorts ports) : ports_(std::move(ports)) {}

  // See ConsoleLog. `time_s` is on the clock of ConsoleView.
  void print(std::string_view text, double time_s) { log_.print(text, time_s); }
  void print_utf8(std::string_view text, double time_s) { log_.print_utf8(text, time_s); }
  void clear() { log_.clear(); }
  // Hides the messages that are over the game now; the log keeps them.
  void clear_notify() { notify_from_ = log_.end_line(); }
  // The whole log as plain ASCII; see ConsoleLog::text().
  std::string text() const { return log_.text(); }

  // Opening and closing starts a slide, which draw() carries out. Closing also ends a search, scrolls to the
  // end, and hides the messages that were just visible in the console.
  void open();
  void close();
  void toggle() { is_open() ? close() : open(); }
  // Opens an empty chat line at the top of the screen; `to_team` sends it only to the player's team.
  void begin_chat(bool to_team);
  bool is_open() const { return entry_ == Entry::kConsole; }
  // Whether keys are for typing; for Window::take_text().
  bool takes_text() const { return entry_ != Entry::kNone; }
  // Whether the console hides the game completely.
  bool covers_frame() const { return covers_frame_; }

  // Handles an event and returns whether it was used; the game must then ignore it. Every event must come
  // here first, open or not, as the console tracks Ctrl, Shift and Alt. Releases are never used up, so that a
  // key which was held when the console opened is still released in the game. The key that opened the console
  // types nothing. While no game runs there is nothing to return to, so Escape and the backquote key are not
  // used.
  bool handle(const platform::InputEvent& event);
  // Returns the lines entered since the last call, for Console::append(); chat as `say "TEXT"` or `say_team
  // "TEXT"`.
  std::vector<std::string> take_commands() { return std::exchange(commands_, {}); }

  // The history of input lines, which the owner saves between runs.
  void load_history(std::string_view text) { history_.load(text); }
  std::string history_text() const { return history_.text(); }

  // Advances the slide to the view's time and appends draw commands for a frame of `width` x `height` pixels.
  // The commands are valid while the pictures live.
  void draw(const ConsoleView& view, int width, int height, render::DrawList& io_list);

 private:
  enum class Entry { kNone, kConsole, kChat, kTeamChat };
  struct HeldKeys {
    bool ctrl = false, shift = false, alt = false;
  };
  // A backward search through the history, as Ctrl+R in a shell.
  struct Search {
    std::string text;  // what to find
    // The line before the search began; Escape restores it.
    std::string typed;
    // Number of the history line that was found; the history's size before the first match.
    std::size_t found = 0;
  };

  void track_modifiers(const platform::KeyChange& change);
  bool handle_key(platform::Key key);
  bool close_if_game_runs();
  bool handle_console_key(platform::Key key);
  bool handle_chat_key(platform::Key key);
  bool handle_ctrl_key(platform::Key key);
  bool handle_search_key(platform::Key key);
  bool edit(platform::Key key);
  bool scroll(platform::Key key);
  void type(std::string_view text);
  void paste();
  void copy();
  void enter_command();
  void enter_chat();
  void set_line(const std::optional<std::string>& line);
  void complete();
  void print_candidates(const command::Completion& completion);
  void find_match(std::size_t before);

  void advance_slide(const ConsoleView& view);
  void draw_page(const ConsoleCanvas& canvas, const ConsoleView& view);
  int draw_notify(const ConsoleCanvas& canvas, const ConsoleSettings& settings);
  std::string prompt() const;

  ConsolePorts ports_;
  ConsoleLog log_;
  Scrollback scrollback_;
  EditLine line_;
  InputHistory history_;
  std::optional<Search> search_;
  std::vector<std::string> commands_;
  Entry entry_ = Entry::kNone;
  EditLine chat_;
  HeldKeys held_;
  // The key that opened the console types a character too ('`'). Text is ignored until the next key press.
  bool ignores_text_ = false;
  bool game_runs_ = true;
  bool covers_frame_ = false;
  double time_s_ = 0;
  // The share of the frame's height that the console covers now, 0 to 1.
  double shown_ = 0;
  // The first log line that may appear over the game.
  std::uint64_t notify_from_ = 0;
  // Scratch space of draw(), kept to avoid allocations. The views refer to the log.
  std::vector<std::string_view> rows_, line_rows_;
};

}  // namespace temblor::client
