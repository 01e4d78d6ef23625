// The console on the screen: what was printed, the line that is typed, and the last lines over the game. An
// object without window, files or clock; what is entered is taken from it as text.
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

struct ConsoleSettings {
  double slide_speed = 300;    // of the original's 200 rows of pixels a second
  double notify_time_s = 3;    // how long a line stays over the game
  int notify_rows = 4;         // and how many at most
  int scale = 0;               // frame pixels for each of the original's; 0: what suits the frame's size
  float text_size = 1;         // times as large
  float opacity = 1;           // of its background over the game
  bool high_contrast = false;  // white on black, without colors
};

// What it shows, and when.
struct ConsoleView {
  const assets::Pictures& pictures;
  double time_s = 0;         // on the clock of print()
  bool game_runs = true;     // false: the console takes the whole frame, open or not
  std::string_view version;  // "Temblor 0.1.0"
  ConsoleSettings settings;
};

// What it needs of others. Each may be null.
struct ConsolePorts {
  std::function<command::Completion(std::string_view line)> complete;
  std::function<std::string()> read_clipboard;
  std::function<void(std::string_view text)> write_clipboard;
};

class ConsoleUi {
 public:
  explicit ConsoleUi(ConsolePorts ports) : ports_(std::move(ports)) {}

  // See ConsoleLog. `time_s`: on the clock of ConsoleView.
  void print(std::string_view text, double time_s) { log_.print(text, time_s); }
  void print_utf8(std::string_view text, double time_s) { log_.print_utf8(text, time_s); }
  void clear() { log_.clear(); }
  // Lines printed so far are no longer shown over the game.
  void clear_notify() { notify_from_ = log_.end_line(); }
  std::string text() const { return log_.text(); }

  void open();
  void close();
  void toggle() { is_open() ? close() : open(); }
  // A line at the top to say something; `to_team` only to the own team.
  void begin_chat(bool to_team);
  bool is_open() const { return entry_ == Entry::kConsole; }
  // Keys are for typing: Window::take_text().
  bool takes_text() const { return entry_ != Entry::kNone; }
  // Nothing of the game is to be seen.
  bool covers_frame() const { return covers_frame_; }

  // Whether it was for the console. Every event has to come here first, open or not; that a key was let go is
  // never the console's alone. The key that opened it (its text follows) types nothing. Escape is not taken
  // where no game runs: there is nothing to close it for.
  bool handle(const platform::InputEvent& event);
  // Lines that were entered since the last time, as Console::append() takes them; chat as `say "TEXT"`.
  std::vector<std::string> take_commands() { return std::exchange(commands_, {}); }

  // The lines entered, to be kept between runs.
  void load_history(std::string_view text) { history_.load(text); }
  std::string history_text() const { return history_.text(); }

  // Lets time pass, and appends what there is to see in a frame of that size. Valid while the pictures live.
  void draw(const ConsoleView& view, int width, int height, render::DrawList& io_list);

 private:
  enum class Entry { kNone, kConsole, kChat, kTeamChat };
  struct HeldKeys {
    bool ctrl = false, shift = false, alt = false;
  };
  // Going back through the history for what has a text in it.
  struct Search {
    std::string text;
    std::string typed;  // what stood there before
    std::size_t found = 0;
  };

  void hold(const platform::KeyChange& change);
  bool press(platform::Key key);
  bool leave();
  bool press_in_console(platform::Key key);
  bool press_in_chat(platform::Key key);
  bool press_with_ctrl(platform::Key key);
  bool press_in_search(platform::Key key);
  bool edit(platform::Key key);
  bool scroll(platform::Key key);
  void type(std::string_view text);
  void paste();
  void copy();
  void enter_command();
  void enter_chat();
  void show_line(const std::optional<std::string>& line);
  void complete();
  void list(const command::Completion& completion);
  void search_on(std::size_t before);

  void slide(const ConsoleView& view);
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
  bool ignores_text_ = false;  // until another key is pressed
  bool game_runs_ = true;
  bool covers_frame_ = false;
  double time_s_ = 0;
  double shown_ = 0;  // of the frame's height
  std::uint64_t notify_from_ = 0;
  std::vector<std::string_view> rows_, line_rows_;  // of a frame
};

}  // namespace temblor::client
