// The menus: pages of rows over the game's picture, for keyboard, mouse and gamepad.
//
// A Menu holds a stack of open pages. The top page is drawn and receives input:
//
//   InputEvent -> MenuSteps -> PageView (selection, search, pointer) -> Row -> Outcome
//                                                                              |
//                     console commands, sounds, another page, close  <---------+
//
// The menu knows nothing of windows, files, clocks or sockets. It reads the world through MenuContent,
// settings through command::Variables, and returns what should happen as console commands and sound names
// that the owner fetches each frame with take_commands() and take_sounds().
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/pictures.h"
#include "client/menu/menu_content.h"
#include "command/variables.h"
#include "platform/input_event.h"
#include "render/draw_list.h"

namespace temblor::client {

// The pages that commands and links can open.
enum class MenuPage {
  kMain,
  kSinglePlayer,
  kNewGame,
  kSkill,
  kLoad,
  kSave,
  kLevels,
  kMultiplayer,
  kJoin,
  kHost,
  kPlayer,
  kOptions,
  kVideo,
  kScreen,
  kSound,
  kControls,
  kKeys,
  kAccessibility,
  kLaboratory,
  kGameFolders,
  kGameData,
  kDemos,
  kHelp,
  kQuit,
  kCount
};

// A console command that opens a page: "menu_load", "menu_options", "help_menu", ...
struct MenuCommand {
  std::string_view name;
  MenuPage page;
};
// The console commands for all pages. Names follow stock Quake where it has the page.
std::vector<MenuCommand> menu_commands();

// A message to the player: a title such as "Connection failed", and the reason. Long lines are wrapped.
struct Notice {
  std::string title, text;
  // Buttons below "OK" that lead to helpful pages: label and page.
  std::vector<std::pair<std::string, MenuPage>> pages = {};
};

// Owns the stack of open pages and choices that are not applied yet (an address, a video mode).
class Menu {
 public:
  // The variables and pictures must outlive the menu. A page leaves out rows whose variable is not registered
  // when the page opens.
  Menu(command::Variables& io_variables, const assets::Pictures& pictures, MenuContent content);
  ~Menu();
  Menu(Menu&&) noexcept;
  Menu& operator=(Menu&&) noexcept;

  // Opens a page in place of all that are open. kQuit runs `quit` without a page if no progress would be
  // lost.
  void open(MenuPage page = MenuPage::kMain);
  // Shows a notice above the open page; opens the main page first if the menu is closed.
  void show_notice(Notice notice);
  void close();
  bool is_open() const;
  // Whether a row waits for a key or text. The owner must then pass all input to the menu.
  bool is_waiting() const;
  // Whether the window should send TextTyped events: while the menu is open, except while it waits for a key
  // to bind.
  bool wants_text() const;
  // Rebuilds the open page because a list of the content has changed. The selection stays.
  void refresh();

  // Returns whether the menu consumed the event. An open menu consumes key presses, stick pushes, text and
  // pointer moves. It also sees releases and window events, but leaves them to others.
  bool handle(const platform::InputEvent& event);

  // Appends draw commands to `io_list`; they refer to the menu and are valid until the next call of any other
  // member. `time_s` is on the clock of the events' timestamps; sticks and buttons that are held repeat by
  // it. The pointer refers to the page as it was last drawn. Draws nothing in a frame too small for a line of
  // text.
  void draw(int width, int height, double time_s, render::DrawList& io_list);

  // Return, in order, the console lines to run and the sounds to play ("misc/menu1.wav", below "sound/")
  // since the last call.
  std::vector<std::string> take_commands();
  std::vector<std::string> take_sounds();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::client
