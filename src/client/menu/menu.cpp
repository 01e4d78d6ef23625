// The stack of pages: passes input to the top page and applies the outcomes of its rows.
//
// Order of an event: a row that waits for a key or text sees it first, then the pointer and typed text, then
// the mouse buttons, and what is left becomes a step (up, accept, back).
#include "client/menu/menu.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "client/menu/page.h"
#include "client/menu/page_view.h"
#include "client/menu/steps.h"

namespace temblor::client {
namespace {

using platform::Key;
using platform::KeyChange;

// A page of the stack, and the function that makes it again when its contents change.
struct OpenPage {
  PageMaker make;
  std::unique_ptr<PageView> view;
};

// Sounds of stock Quake's menus, below "sound/".
std::string_view sound_file(MenuSound sound) {
  switch (sound) {
    case MenuSound::kMove:
      return "misc/menu1.wav";
    case MenuSound::kEnter:
      return "misc/menu2.wav";
    case MenuSound::kAdjust:
      return "misc/menu3.wav";
    case MenuSound::kNone:
      break;
  }
  return {};
}

// Whether an open menu uses this event up: presses, pushes, text and pointer moves. A stick near its center
// counts as released, so that the game sees the release.
bool is_for_menu(const platform::InputEvent& event) {
  constexpr float kReleased = 0.25f;
  if (const auto* const change = std::get_if<KeyChange>(&event.what)) return change->down;
  if (const auto* const moved = std::get_if<platform::PadAxisMoved>(&event.what))
    return std::abs(moved->value) > kReleased;
  return std::holds_alternative<platform::TextTyped>(event.what) ||
         std::holds_alternative<platform::MouseMoved>(event.what) ||
         std::holds_alternative<platform::PointerMoved>(event.what);
}

bool is_function_key(const platform::InputEvent& event) {
  const auto* const change = std::get_if<KeyChange>(&event.what);
  return change != nullptr && change->key >= platform::Key::kF1 && change->key <= platform::Key::kF12;
}

int to_pixel(float fraction, int size) {
  // Clamped far outside the window, so that the product fits an int.
  return static_cast<int>(std::floor(std::clamp(fraction, -1.0f, 2.0f) * static_cast<float>(size)));
}

}  // namespace

struct Menu::State {
  State(command::Variables& io_variables, const assets::Pictures& the_pictures, MenuContent the_content)
      : content(std::move(the_content)), context{io_variables, the_pictures, content, choices} {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  PageView& top() { return *pages.back().view; }
  Row* waiting_row() {
    Row* const row = pages.empty() ? nullptr : top().selected_row();
    return row != nullptr && row->is_waiting() ? row : nullptr;
  }

  // Input of a page's rows becomes outcomes; these change the stack.
  void apply_outcome(Outcome outcome);
  void play(MenuSound sound);
  void push(PageMaker make);
  void back();
  void rebuild_top();
  void apply_pending_refresh();

  void handle(const platform::InputEvent& event);
  void point(const platform::PointerMoved& moved);
  bool is_at_rest();
  void type(std::string_view text);
  void activate_by_letter(char letter);
  bool handle_mouse(const KeyChange& change);
  void step(MenuStep step);
  void erase();
  double number(std::string_view variable, double fallback) const;

  MenuContent content;
  MenuChoices choices;
  PageContext context;
  std::vector<OpenPage> pages;
  MenuSteps steps;
  // Waits until no row is being edited and no slider is held.
  bool refresh_pending = false;
  // The pointer has not been moved since the menu opened.
  bool pointer_rests = false;
  // Where the pointer rests, in frame pixels; nothing if not known yet.
  std::optional<int> rest_x;
  int rest_y = 0;
  // Ignore the text of a key press that was already used, for example by the row that it ended.
  bool drop_text = false;
  // The rows have moved under the pointer (mouse wheel), so it must select again after the next draw.
  bool repoint = false;
  int frame_width = 0, frame_height = 0;
  // In frame pixels, as of the last event.
  int pointer_x = -1, pointer_y = -1;
  std::vector<std::string> commands, sounds;
};

void Menu::State::play(MenuSound sound) {
  if (sound != MenuSound::kNone) sounds.emplace_back(sound_file(sound));
}

// Limits the depth: notices and page commands could otherwise pile up without end.
void Menu::State::push(PageMaker make) {
  constexpr std::size_t kMaxDepth = 16;
  if (pages.size() >= kMaxDepth) pages.erase(pages.begin());
  auto view = std::make_unique<PageView>(make(context));
  pages.push_back({std::move(make), std::move(view)});
}

void Menu::State::rebuild_top() {
  refresh_pending = false;
  if (!pages.empty()) top().replace(pages.back().make(context));
}

// The page below is made again, as its contents may have changed meanwhile.
void Menu::State::back() {
  pages.pop_back();
  rebuild_top();
}

void Menu::State::apply_pending_refresh() {
  if (refresh_pending && !pages.empty() && waiting_row() == nullptr && !top().is_sliding()) rebuild_top();
}

// The order is that of Outcome's members. Commands are only stored; the owner runs them after the event.
void Menu::State::apply_outcome(Outcome outcome) {
  play(outcome.sound);
  for (std::string& line : outcome.commands) commands.push_back(std::move(line));
  if (outcome.leaving == Leaving::kClose) {
    pages.clear();
  } else if (outcome.leaving == Leaving::kBack && !pages.empty()) {
    back();
  }
  if (outcome.page) push(std::move(outcome.page));
  if (outcome.refresh) rebuild_top();
}

// Backspace deletes from the search first, then clears the row, and otherwise leaves the page.
void Menu::State::erase() {
  std::string search = top().search();
  if (!search.empty()) {
    search.pop_back();
    return top().set_search(std::move(search));
  }
  Row* const row = top().selected_row();
  if (std::optional<Outcome> outcome = row == nullptr ? std::nullopt : row->clear())
    return apply_outcome(std::move(*outcome));
  step(MenuStep::kBack);
}

void Menu::State::step(MenuStep step) {
  PageView& view = top();
  Row* const row = view.selected_row();
  const auto moved = [&](bool moved_row) {
    if (moved_row) play(MenuSound::kMove);
  };
  switch (step) {
    case MenuStep::kUp:
      return moved(view.move(-1));
    case MenuStep::kDown:
      return moved(view.move(1));
    case MenuStep::kPageUp:
      return moved(view.move_pages(-1));
    case MenuStep::kPageDown:
      return moved(view.move_pages(1));
    case MenuStep::kHome:
      return moved(view.go_to_start());
    case MenuStep::kEnd:
      return moved(view.go_to_end());
    case MenuStep::kLeft:
    case MenuStep::kRight:
      if (row != nullptr) apply_outcome(row->adjust(step == MenuStep::kLeft ? -1 : 1));
      return;
    case MenuStep::kAccept:
      if (row != nullptr) apply_outcome(row->activate());
      return;
    case MenuStep::kClear:
      if (std::optional<Outcome> outcome = row == nullptr ? std::nullopt : row->clear())
        apply_outcome(std::move(*outcome));
      return;
    case MenuStep::kErase:
      return erase();
    case MenuStep::kBack:
      play(MenuSound::kEnter);
      if (!view.search().empty()) return view.set_search({});
      return back();
    case MenuStep::kClose:
      play(MenuSound::kEnter);
      return pages.clear();
  }
}

// When the menu opens, the game releases the pointer and it appears somewhere. It selects nothing until the
// player moves it; a few pixels do not count.
bool Menu::State::is_at_rest() {
  constexpr int kJitter_px = 8;
  if (!pointer_rests) return false;
  if (!rest_x) {
    rest_x = pointer_x;
    rest_y = pointer_y;
  }
  pointer_rests = std::abs(pointer_x - *rest_x) <= kJitter_px && std::abs(pointer_y - rest_y) <= kJitter_px;
  return pointer_rests;
}

void Menu::State::point(const platform::PointerMoved& moved) {
  if (!std::isfinite(moved.x) || !std::isfinite(moved.y)) return;
  pointer_x = to_pixel(moved.x, frame_width);
  pointer_y = to_pixel(moved.y, frame_height);
  if (is_at_rest()) return;
  if (top().is_sliding())
    top().slide_to(pointer_x, pointer_y);
  else if (waiting_row() == nullptr)
    top().point_at(pointer_x, pointer_y);
}

// Handles the left button and the wheel and returns true. Other buttons are menu steps.
bool Menu::State::handle_mouse(const KeyChange& change) {
  constexpr int kWheelLines = 3;
  if (change.key == Key::kMouse1) {
    if (!change.down) {
      top().release();
      return true;
    }
    const PageView::Pressed pressed = top().press(pointer_x, pointer_y);
    if (pressed == PageView::Pressed::kRow) apply_outcome(top().selected_row()->activate());
    if (pressed == PageView::Pressed::kSlider) play(MenuSound::kAdjust);
    return true;
  }
  if (change.key != Key::kWheelUp && change.key != Key::kWheelDown) return false;
  if (change.down) top().scroll(change.key == Key::kWheelUp ? -kWheelLines : kWheelLines);
  repoint = true;
  return true;
}

void Menu::State::activate_by_letter(char letter) {
  const Rows& rows = top().page().rows;
  const auto picked = std::find_if(rows.begin(), rows.end(), [&](const std::unique_ptr<Row>& row) {
    return row->letter() != 0 && row->letter() == base::to_lower(letter);
  });
  if (picked != rows.end()) apply_outcome((*picked)->activate());
}

// A selected text row takes typing as the start of an edit. On other rows text goes to the page's search, or
// picks a row by its letter ("y" for yes).
void Menu::State::type(std::string_view text) {
  constexpr std::size_t kMaxSearch = 40;
  Row* const row = top().selected_row();
  if (text.empty() || (row != nullptr && row->type(text))) return;
  if (!top().page().has_search) return activate_by_letter(text.front());
  std::string search = top().search();
  for (const char c : text)
    if ((c > ' ' || (c == ' ' && !search.empty())) && c <= '~' && search.size() < kMaxSearch) search += c;
  if (search != top().search()) top().set_search(std::move(search));
}

void Menu::State::handle(const platform::InputEvent& event) {
  const auto* const change = std::get_if<KeyChange>(&event.what);
  const bool is_pressed = change != nullptr && change->down;
  if (is_pressed) drop_text = false;
  if (Row* const row = waiting_row()) {
    Outcome outcome;
    if (row->handle(event, outcome)) {
      drop_text = is_pressed && !row->is_waiting();
      return apply_outcome(std::move(outcome));
    }
  }
  if (const auto* const moved = std::get_if<platform::PointerMoved>(&event.what)) return point(*moved);
  if (const auto* const typed = std::get_if<platform::TextTyped>(&event.what)) {
    if (!std::exchange(drop_text, false)) type(typed->text);
    return;
  }
  if (std::holds_alternative<platform::FocusChanged>(event.what)) top().release();
  if (std::holds_alternative<platform::WindowChanged>(event.what)) refresh_pending = true;
  if (change != nullptr && handle_mouse(*change)) return;
  if (const std::optional<MenuStep> taken = steps.translate(event)) step(*taken);
}

double Menu::State::number(std::string_view variable, double fallback) const {
  const command::Variable* const found = context.variables.find(variable);
  return found == nullptr ? fallback : found->number;
}

std::vector<MenuCommand> menu_commands() {
  return {{"menu_main", MenuPage::kMain},         {"menu_singleplayer", MenuPage::kSinglePlayer},
          {"menu_newgame", MenuPage::kNewGame},   {"menu_skill", MenuPage::kSkill},
          {"menu_load", MenuPage::kLoad},         {"menu_save", MenuPage::kSave},
          {"menu_levels", MenuPage::kLevels},     {"menu_multiplayer", MenuPage::kMultiplayer},
          {"menu_join", MenuPage::kJoin},         {"menu_host", MenuPage::kHost},
          {"menu_setup", MenuPage::kPlayer},      {"menu_options", MenuPage::kOptions},
          {"menu_video", MenuPage::kVideo},       {"menu_screen", MenuPage::kScreen},
          {"menu_sound", MenuPage::kSound},       {"menu_controls", MenuPage::kControls},
          {"menu_keys", MenuPage::kKeys},         {"menu_accessibility", MenuPage::kAccessibility},
          {"menu_lab", MenuPage::kLaboratory},    {"menu_games", MenuPage::kGameFolders},
          {"menu_gamedata", MenuPage::kGameData}, {"menu_demos", MenuPage::kDemos},
          {"help_menu", MenuPage::kHelp},         {"menu_quit", MenuPage::kQuit}};
}

Menu::Menu(command::Variables& io_variables, const assets::Pictures& pictures, MenuContent content)
    : state_(std::make_unique<State>(io_variables, pictures, std::move(content))) {}
Menu::~Menu() = default;
Menu::Menu(Menu&&) noexcept = default;
Menu& Menu::operator=(Menu&&) noexcept = default;

void Menu::open(MenuPage page) {
  const bool was_open = is_open();
  if (!was_open) {
    state_->drop_text = true;
    state_->pointer_rests = true;
    state_->rest_x.reset();
    state_->steps = {};
  }
  state_->pages.clear();
  Outcome outcome = open_page(state_->context, page);
  if (!was_open && outcome.page) outcome.sound = MenuSound::kEnter;
  state_->apply_outcome(std::move(outcome));
}

void Menu::show_notice(Notice notice) {
  if (!is_open()) open();
  state_->apply_outcome({.sound = MenuSound::kEnter, .page = make_notice(std::move(notice))});
}

void Menu::close() {
  state_->pages.clear();
}

bool Menu::is_open() const {
  return !state_->pages.empty();
}

bool Menu::wants_text() const {
  const Row* const row = state_->waiting_row();
  return is_open() && (row == nullptr || row->wants_text());
}

void Menu::refresh() {
  state_->refresh_pending = true;
  state_->apply_pending_refresh();
}

bool Menu::is_waiting() const {
  return is_open() && state_->waiting_row() != nullptr;
}

bool Menu::handle(const platform::InputEvent& event) {
  if (!is_open()) return false;
  // Function keys open pages, so they work here too, unless a row waits for a key to bind.
  if (is_function_key(event) && state_->waiting_row() == nullptr) return false;
  state_->handle(event);
  state_->apply_pending_refresh();
  return is_for_menu(event);
}

void Menu::draw(int width, int height, double time_s, render::DrawList& io_list) {
  State& state = *state_;
  state.frame_width = width;
  state.frame_height = height;
  if (is_open() && state.waiting_row() == nullptr)
    if (const std::optional<MenuStep> step = state.steps.repeat_held(time_s)) state.step(*step);
  if (!is_open()) return;
  const CanvasLook look{state.number("scr_textsize", 1), state.number("con_highcontrast", 0) != 0};
  const std::optional<Canvas> canvas = Canvas::fit(state.context.pictures, width, height, look, io_list);
  if (!canvas) return;
  canvas->dim();
  state.top().draw(*canvas, time_s);
  if (std::exchange(state.repoint, false)) state.top().point_at(state.pointer_x, state.pointer_y);
}

std::vector<std::string> Menu::take_commands() {
  return std::exchange(state_->commands, {});
}

std::vector<std::string> Menu::take_sounds() {
  return std::exchange(state_->sounds, {});
}

}  // namespace temblor::client
