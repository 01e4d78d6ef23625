// A stack of pages: the topmost one is drawn and gets what the player does; what its rows lead to is carried
// out here.
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

struct OpenPage {
  PageMaker make;
  std::unique_ptr<PageView> view;
};

std::string_view file_of(MenuSound sound) {
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

// What is pressed, pushed, typed or pointed at. A stick on its way back to the middle is one that is let go.
bool is_for_menu(const platform::InputEvent& event) {
  constexpr float kLetGo = 0.25f;
  if (const auto* const change = std::get_if<KeyChange>(&event.what)) return change->down;
  if (const auto* const moved = std::get_if<platform::PadAxisMoved>(&event.what))
    return std::abs(moved->value) > kLetGo;
  return std::holds_alternative<platform::TextTyped>(event.what) ||
         std::holds_alternative<platform::MouseMoved>(event.what) ||
         std::holds_alternative<platform::PointerMoved>(event.what);
}

bool is_function_key(const platform::InputEvent& event) {
  const auto* const change = std::get_if<KeyChange>(&event.what);
  return change != nullptr && change->key >= platform::Key::kF1 && change->key <= platform::Key::kF12;
}

int pixel_of(float fraction, int size) {
  // Beyond the window is beyond the window, however far.
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

  void carry_out(Outcome outcome);
  void play(MenuSound sound);
  void push(PageMaker make);
  void back();
  void make_top_anew();
  void catch_up_refresh();

  void take(const platform::InputEvent& event);
  void point(const platform::PointerMoved& moved);
  bool is_at_rest();
  void type(std::string_view text);
  void pick(char letter);
  bool take_mouse(const KeyChange& change);
  void step(MenuStep step);
  void erase();
  double number(std::string_view variable, double otherwise) const;

  MenuContent content;
  MenuChoices choices;
  PageContext context;
  std::vector<OpenPage> pages;
  MenuSteps steps;
  bool refresh_waits = false;  // until the row that is edited is done
  bool rests = false;          // the pointer, since the menu has opened
  std::optional<int> rest_x;   // where; nothing: not known yet
  int rest_y = 0;
  bool drop_text = false;    // what the key that was just taken types
  bool point_again = false;  // the rows have moved under the pointer
  int frame_width = 0, frame_height = 0;
  int pointer_x = -1, pointer_y = -1;
  std::vector<std::string> commands, sounds;
};

void Menu::State::play(MenuSound sound) {
  if (sound != MenuSound::kNone) sounds.emplace_back(file_of(sound));
}

void Menu::State::push(PageMaker make) {
  constexpr std::size_t kDeepest = 16;
  if (pages.size() >= kDeepest) pages.erase(pages.begin());
  auto view = std::make_unique<PageView>(make(context));
  pages.push_back({std::move(make), std::move(view)});
}

void Menu::State::make_top_anew() {
  refresh_waits = false;
  if (!pages.empty()) top().replace(pages.back().make(context));
}

void Menu::State::back() {
  pages.pop_back();
  make_top_anew();
}

void Menu::State::catch_up_refresh() {
  if (refresh_waits && !pages.empty() && waiting_row() == nullptr && !top().is_sliding()) make_top_anew();
}

void Menu::State::carry_out(Outcome outcome) {
  play(outcome.sound);
  for (std::string& line : outcome.commands) commands.push_back(std::move(line));
  if (outcome.leaving == Leaving::kClose) {
    pages.clear();
  } else if (outcome.leaving == Leaving::kBack && !pages.empty()) {
    back();
  }
  if (outcome.page) push(std::move(outcome.page));
  if (outcome.refresh) make_top_anew();
}

void Menu::State::erase() {
  std::string search = top().search();
  if (!search.empty()) {
    search.pop_back();
    return top().set_search(std::move(search));
  }
  Row* const row = top().selected_row();
  if (std::optional<Outcome> outcome = row == nullptr ? std::nullopt : row->clear())
    return carry_out(std::move(*outcome));
  step(MenuStep::kBack);
}

void Menu::State::step(MenuStep step) {
  PageView& view = top();
  Row* const row = view.selected_row();
  const auto moved = [&](bool has_moved) {
    if (has_moved) play(MenuSound::kMove);
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
      return moved(view.go_to_begin());
    case MenuStep::kEnd:
      return moved(view.go_to_end());
    case MenuStep::kLeft:
    case MenuStep::kRight:
      if (row != nullptr) carry_out(row->adjust(step == MenuStep::kLeft ? -1 : 1));
      return;
    case MenuStep::kAccept:
      if (row != nullptr) carry_out(row->activate());
      return;
    case MenuStep::kClear:
      if (std::optional<Outcome> outcome = row == nullptr ? std::nullopt : row->clear())
        carry_out(std::move(*outcome));
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

// A pointer that appears where the menu has opened, because the game let go of it, points at nothing yet.
bool Menu::State::is_at_rest() {
  constexpr int kTremble_px = 8;
  if (!rests) return false;
  if (!rest_x) {
    rest_x = pointer_x;
    rest_y = pointer_y;
  }
  rests = std::abs(pointer_x - *rest_x) <= kTremble_px && std::abs(pointer_y - rest_y) <= kTremble_px;
  return rests;
}

void Menu::State::point(const platform::PointerMoved& moved) {
  if (!std::isfinite(moved.x) || !std::isfinite(moved.y)) return;
  pointer_x = pixel_of(moved.x, frame_width);
  pointer_y = pixel_of(moved.y, frame_height);
  if (is_at_rest()) return;
  if (top().is_sliding())
    top().slide_to(pointer_x, pointer_y);
  else if (waiting_row() == nullptr)
    top().point_at(pointer_x, pointer_y);
}

// Whether it is of the mouse, but for the buttons that are steps.
bool Menu::State::take_mouse(const KeyChange& change) {
  constexpr int kWheelLines = 3;
  if (change.key == Key::kMouse1) {
    if (!change.down) {
      top().let_go();
      return true;
    }
    const PageView::Pressed pressed = top().press(pointer_x, pointer_y);
    if (pressed == PageView::Pressed::kRow) carry_out(top().selected_row()->activate());
    if (pressed == PageView::Pressed::kSlider) play(MenuSound::kAdjust);
    return true;
  }
  if (change.key != Key::kWheelUp && change.key != Key::kWheelDown) return false;
  if (change.down) top().scroll(change.key == Key::kWheelUp ? -kWheelLines : kWheelLines);
  point_again = true;
  return true;
}

void Menu::State::pick(char letter) {
  const Rows& rows = top().page().rows;
  const auto picked = std::find_if(rows.begin(), rows.end(), [&](const std::unique_ptr<Row>& row) {
    return row->letter() != 0 && row->letter() == base::to_lower(letter);
  });
  if (picked != rows.end()) carry_out((*picked)->activate());
}

void Menu::State::type(std::string_view text) {
  constexpr std::size_t kMaxSearch = 40;
  Row* const row = top().selected_row();
  if (text.empty() || (row != nullptr && row->type(text))) return;
  if (!top().page().searched) return pick(text.front());
  std::string search = top().search();
  for (const char c : text)
    if ((c > ' ' || (c == ' ' && !search.empty())) && c <= '~' && search.size() < kMaxSearch) search += c;
  if (search != top().search()) top().set_search(std::move(search));
}

void Menu::State::take(const platform::InputEvent& event) {
  const auto* const change = std::get_if<KeyChange>(&event.what);
  const bool is_pressed = change != nullptr && change->down;
  if (is_pressed) drop_text = false;
  if (Row* const row = waiting_row()) {
    Outcome outcome;
    if (row->take(event, outcome)) {
      drop_text = is_pressed && !row->is_waiting();
      return carry_out(std::move(outcome));
    }
  }
  if (const auto* const moved = std::get_if<platform::PointerMoved>(&event.what)) return point(*moved);
  if (const auto* const typed = std::get_if<platform::TextTyped>(&event.what)) {
    if (!std::exchange(drop_text, false)) type(typed->text);
    return;
  }
  if (std::holds_alternative<platform::FocusChanged>(event.what)) top().let_go();
  if (std::holds_alternative<platform::WindowChanged>(event.what)) refresh_waits = true;
  if (change != nullptr && take_mouse(*change)) return;
  if (const std::optional<MenuStep> taken = steps.take(event)) step(*taken);
}

double Menu::State::number(std::string_view variable, double otherwise) const {
  const command::Variable* const found = context.variables.find(variable);
  return found == nullptr ? otherwise : found->number;
}

std::vector<MenuCommand> menu_commands() {
  return {{"menu_main", MenuPage::kMain},
          {"menu_singleplayer", MenuPage::kSinglePlayer},
          {"menu_newgame", MenuPage::kNewGame},
          {"menu_load", MenuPage::kLoad},
          {"menu_save", MenuPage::kSave},
          {"menu_levels", MenuPage::kLevels},
          {"menu_multiplayer", MenuPage::kMultiplayer},
          {"menu_join", MenuPage::kJoin},
          {"menu_host", MenuPage::kHost},
          {"menu_setup", MenuPage::kPlayer},
          {"menu_options", MenuPage::kOptions},
          {"menu_video", MenuPage::kVideo},
          {"menu_screen", MenuPage::kScreen},
          {"menu_sound", MenuPage::kSound},
          {"menu_controls", MenuPage::kControls},
          {"menu_keys", MenuPage::kKeys},
          {"menu_accessibility", MenuPage::kAccessibility},
          {"menu_games", MenuPage::kGameFolders},
          {"menu_demos", MenuPage::kDemos},
          {"help_menu", MenuPage::kHelp},
          {"menu_quit", MenuPage::kQuit}};
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
    state_->rests = true;
    state_->rest_x.reset();
    state_->steps = {};
  }
  state_->pages.clear();
  Outcome outcome = opening(state_->context, page);
  if (!was_open && outcome.page) outcome.sound = MenuSound::kEnter;
  state_->carry_out(std::move(outcome));
}

void Menu::tell(Notice notice) {
  if (!is_open()) open();
  state_->carry_out({.sound = MenuSound::kEnter, .page = make_notice(std::move(notice))});
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
  state_->refresh_waits = true;
  state_->catch_up_refresh();
}

bool Menu::is_waiting() const {
  return is_open() && state_->waiting_row() != nullptr;
}

bool Menu::handle(const platform::InputEvent& event) {
  if (!is_open()) return false;
  // Bound to pages of the menus, most of them; a row that waits for a key may want it.
  if (is_function_key(event) && state_->waiting_row() == nullptr) return false;
  state_->take(event);
  state_->catch_up_refresh();
  return is_for_menu(event);
}

void Menu::draw(int width, int height, double time_s, render::DrawList& io_list) {
  State& state = *state_;
  state.frame_width = width;
  state.frame_height = height;
  if (is_open() && state.waiting_row() == nullptr)
    if (const std::optional<MenuStep> step = state.steps.repeated(time_s)) state.step(*step);
  if (!is_open()) return;
  const CanvasLook look{state.number("scr_textsize", 1), state.number("con_highcontrast", 0) != 0};
  const std::optional<Canvas> canvas = Canvas::fit(state.context.pictures, width, height, look, io_list);
  if (!canvas) return;
  canvas->dim();
  state.top().draw(*canvas, time_s);
  if (std::exchange(state.point_again, false)) state.top().point_at(state.pointer_x, state.pointer_y);
}

std::vector<std::string> Menu::take_commands() {
  return std::exchange(state_->commands, {});
}

std::vector<std::string> Menu::take_sounds() {
  return std::exchange(state_->sounds, {});
}

}  // namespace temblor::client
