// Input handling of the console; draw_console.cpp draws it.
#include "client/console/console_ui.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "client/console/format_candidates.h"
#include "client/console/utf8.h"

namespace temblor::client {

using platform::Key;

namespace {

constexpr Key kBackquote{'`'};

// Keys that type characters arrive twice, as KeyChange and as TextTyped. The KeyChange must be used up, so
// that typing does not also run the key's binding.
bool is_typing_key(Key key) {
  constexpr auto kFirst = static_cast<int>(Key::kSpace), kLast = static_cast<int>(Key::kBackspace);
  const auto value = static_cast<int>(key);
  const bool is_keypad = key >= Key::kKeypad0 && key <= Key::kKeypadPlus;
  return (value >= kFirst && value <= kLast) || is_keypad;
}

bool is_modifier(Key key) {
  return key == Key::kShift || key == Key::kCtrl || key == Key::kAlt || key == Key::kCommand;
}

// Mouse buttons would fire, so the open console uses them up.
bool is_mouse_button(Key key) {
  return key >= Key::kMouse1 && key <= Key::kMouse8;
}

// Players of other games type "/map start". "//" begins a comment.
bool has_slash(std::string_view line) {
  return (line.starts_with('/') && !line.starts_with("//")) || line.starts_with('\\');
}

// Joins pasted lines to one line of commands. Line ends after the last one are dropped, so that pasting never
// runs anything.
std::string join_lines(std::string text) {
  while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ';');
  return text;
}

}  // namespace

void ConsoleUi::open() {
  entry_ = Entry::kConsole;
  ignores_text_ = true;
}

void ConsoleUi::close() {
  entry_ = Entry::kNone;
  search_.reset();
  scrollback_.scroll_to_end();
  clear_notify();
}

void ConsoleUi::begin_chat(bool to_team) {
  entry_ = to_team ? Entry::kTeamChat : Entry::kChat;
  chat_.clear();
  ignores_text_ = true;
}

// Modifiers are tracked even while the console is closed. A key that was released while another window had
// the focus sends no release here, so losing the focus clears them.
bool ConsoleUi::handle(const platform::InputEvent& event) {
  if (const auto* focus = std::get_if<platform::FocusChanged>(&event.what)) {
    if (!focus->focused) held_ = {};
    return false;
  }
  if (const auto* text = std::get_if<platform::TextTyped>(&event.what)) {
    if (!takes_text()) return false;
    if (!ignores_text_) type(text->text);
    return true;
  }
  const auto* change = std::get_if<platform::KeyChange>(&event.what);
  if (change == nullptr) return false;
  track_modifiers(*change);
  if (!change->down) return false;
  if (!change->repeated) ignores_text_ = false;
  return takes_text() && handle_key(change->key);
}

void ConsoleUi::track_modifiers(const platform::KeyChange& change) {
  if (change.key == Key::kCtrl || change.key == Key::kCommand) held_.ctrl = change.down;
  if (change.key == Key::kShift) held_.shift = change.down;
  if (change.key == Key::kAlt) held_.alt = change.down;
}

// The order matters: the search takes most keys, then come keys that close the console, shortcuts, and keys
// whose meaning depends on the line. Every other key edits the line or is used up.
bool ConsoleUi::handle_key(Key key) {
  // Ctrl and Alt together is AltGr, which types characters on some keyboards.
  const bool ctrl = held_.ctrl && !held_.alt;
  if (key == Key::kInsert && held_.shift) return paste(), true;
  if (search_ && handle_search_key(key)) return true;
  if (is_open() && (key == kBackquote || key == Key::kEscape)) return close_if_game_runs();
  if (ctrl && handle_ctrl_key(key)) return true;
  if (entry_ == Entry::kConsole ? handle_console_key(key) : handle_chat_key(key)) return true;
  return edit(key) || is_typing_key(key) || is_modifier(key) || (is_open() && is_mouse_button(key));
}

// Returns whether the key was used. Without a game it is left to the key bindings and the menu.
bool ConsoleUi::close_if_game_runs() {
  ignores_text_ = true;
  if (game_runs_) close();
  return game_runs_;
}

bool ConsoleUi::handle_console_key(Key key) {
  switch (key) {
    case Key::kEnter:
    case Key::kKeypadEnter:
      enter_command();
      return true;
    case Key::kTab:
      complete();
      return true;
    case Key::kUpArrow:
      set_line(history_.older(line_.text()));
      return true;
    case Key::kDownArrow:
      set_line(history_.newer());
      return true;
    default:
      return scroll(key);
  }
}

bool ConsoleUi::handle_chat_key(Key key) {
  if (key == Key::kEnter || key == Key::kKeypadEnter) {
    enter_chat();
    return true;
  }
  if (key != Key::kEscape) return key == Key::kTab;
  entry_ = Entry::kNone;
  return true;
}

// Home and End move the cursor in a line with text. With an empty line, or with Ctrl, they scroll.
bool ConsoleUi::scroll(Key key) {
  constexpr int kWheelRows = 3;
  const bool is_for_page = held_.ctrl || line_.text().empty();
  if (key == Key::kPageUp)
    scrollback_.page_up(log_);
  else if (key == Key::kPageDown)
    scrollback_.page_down(log_);
  else if (key == Key::kWheelUp)
    scrollback_.scroll_up(log_, kWheelRows);
  else if (key == Key::kWheelDown)
    scrollback_.scroll_down(log_, kWheelRows);
  else if (key == Key::kHome && is_for_page)
    scrollback_.scroll_to_start(log_);
  else if (key == Key::kEnd && is_for_page)
    scrollback_.scroll_to_end();
  else
    return false;
  return true;
}

// Keys that edit whichever line has the focus; Ctrl makes them work on whole words.
bool ConsoleUi::edit(Key key) {
  EditLine& line = is_open() ? line_ : chat_;
  const bool by_words = held_.ctrl;
  if (key == Key::kBackspace)
    by_words ? line.erase_word_left() : line.erase_left();
  else if (key == Key::kDelete)
    by_words ? line.erase_word_right() : line.erase_right();
  else if (key == Key::kLeftArrow)
    by_words ? line.move_word_left() : line.move_left();
  else if (key == Key::kRightArrow)
    by_words ? line.move_word_right() : line.move_right();
  else if (key == Key::kHome)
    line.move_to_start();
  else if (key == Key::kEnd)
    line.move_to_end();
  else
    return false;
  return true;
}

// Shortcuts of the readline library and of desktop programs.
bool ConsoleUi::handle_ctrl_key(Key key) {
  struct Shortcut {
    Key key;
    void (EditLine::*edit)();
  };
  constexpr Shortcut kShortcuts[] = {{Key{'a'}, &EditLine::move_to_start},
                                     {Key{'e'}, &EditLine::move_to_end},
                                     {Key{'u'}, &EditLine::erase_to_start},
                                     {Key{'k'}, &EditLine::erase_to_end},
                                     {Key{'w'}, &EditLine::erase_word_left}};
  EditLine& line = is_open() ? line_ : chat_;
  for (const Shortcut& shortcut : kShortcuts)
    if (shortcut.key == key) return (line.*shortcut.edit)(), true;
  if (key == Key{'v'}) {
    paste();
  } else if (key == Key{'c'} || key == Key{'x'}) {
    copy();
    if (key == Key{'x'}) line.clear();
  } else if (key == Key{'l'} && is_open()) {
    clear();
  } else if (key == Key{'r'} && is_open()) {
    search_ = Search{"", line_.text(), history_.size()};
  } else {
    return false;
  }
  return true;
}

// Any other key ends the search with the line it found, and then acts as usual.
bool ConsoleUi::handle_search_key(Key key) {
  const bool ctrl = held_.ctrl && !held_.alt;
  if (key == Key::kEscape || (ctrl && key == Key{'g'})) {
    line_.set(search_->typed);
    search_.reset();
    return true;
  }
  if (ctrl && key == Key{'r'}) {
    if (!search_->text.empty()) find_match(search_->found);
    return true;
  }
  if (key == Key::kBackspace) {
    EditLine text;
    text.set(search_->text);
    text.erase_left();
    search_->text = text.text();
    find_match(history_.size());
    return true;
  }
  const bool is_typed = is_typing_key(key) && !ctrl;
  if (!is_typed && !is_modifier(key)) search_.reset();
  return is_typed;
}

// Shows the last match before history line `before`. Without a match the shown line stays, as in shells.
void ConsoleUi::find_match(std::size_t before) {
  if (search_->text.empty()) return line_.set(search_->typed);
  const std::optional<std::size_t> found = history_.find_before(before, search_->text);
  if (!found) return;
  search_->found = *found;
  line_.set(history_.line(*found));
}

void ConsoleUi::type(std::string_view text) {
  if (search_) {
    EditLine searched;
    searched.set(search_->text);
    searched.insert(text);
    search_->text = searched.text();
    // The current match may match the longer text too.
    return find_match(std::min(search_->found + 1, history_.size()));
  }
  (is_open() ? line_ : chat_).insert(text);
}

// Pasting ends a search and keeps the line that it found.
void ConsoleUi::paste() {
  if (ports_.read_clipboard == nullptr) return;
  search_.reset();
  const std::string text = join_lines(ports_.read_clipboard());
  const std::size_t dropped = (is_open() ? line_ : chat_).insert(text);
  if (dropped > 0)
    print(fmt::format("Pasted text is too long: {} of {} characters dropped (a line holds {})\n", dropped,
                      text.size(), EditLine::kMaxBytes),
          time_s_);
}

void ConsoleUi::copy() {
  const std::string& text = (is_open() ? line_ : chat_).text();
  if (ports_.write_clipboard != nullptr && !text.empty()) ports_.write_clipboard(text);
}

// Echoes the line with its prompt. Empty lines are echoed but not run, so that Enter makes space in the
// output.
void ConsoleUi::enter_command() {
  const std::string line = line_.text();
  line_.clear();
  scrollback_.scroll_to_end();
  print_utf8(fmt::format("]{}\n", line), time_s_);
  history_.add(line);
  if (!line.empty()) commands_.push_back(has_slash(line) ? line.substr(1) : line);
}

// Converts the text to the console's characters. A quoted string cannot contain quotes, so they become
// apostrophes.
void ConsoleUi::enter_chat() {
  std::string text = to_glyphs(chat_.text());
  std::replace(text.begin(), text.end(), '"', '\'');
  const bool to_team = entry_ == Entry::kTeamChat;
  entry_ = Entry::kNone;
  if (!text.empty()) commands_.push_back(fmt::format("{} \"{}\"", to_team ? "say_team" : "say", text));
}

void ConsoleUi::set_line(const std::optional<std::string>& line) {
  if (line) line_.set(*line);
}

// Completes the word before the cursor as far as all candidates agree. If that adds nothing, lists them.
// Replacing also corrects the case of what was typed.
void ConsoleUi::complete() {
  if (ports_.complete == nullptr) return;
  std::string_view typed = std::string_view(line_.text()).substr(0, line_.cursor());
  const std::size_t skipped = has_slash(typed) ? 1 : 0;
  typed.remove_prefix(skipped);
  const command::Completion completion = ports_.complete(typed);
  const std::size_t word_length = typed.size() - completion.begin;
  std::string common = find_common_prefix(completion.candidates);
  if (completion.candidates.size() == 1)
    common += ' ';
  else if (common.size() <= word_length)
    return print_candidates(completion);
  line_.replace_before_cursor(skipped + completion.begin, common);
}

// Prints what could follow; or, if nothing could, a hint about the command or variable in the line.
void ConsoleUi::print_candidates(const command::Completion& completion) {
  scrollback_.scroll_to_end();
  if (!completion.candidates.empty())
    print(format_candidates(completion.candidates), time_s_);
  else if (!completion.hint.empty())
    print_utf8(fmt::format("  {}\n", completion.hint), time_s_);
}

}  // namespace temblor::client
