// The menus: pages of rows over the picture, for keyboard, mouse and gamepad. Knows no window, files, clock
// or sockets: it is told what happened, and says what is to be drawn, run and played.
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

enum class MenuPage {
  kMain,
  kSinglePlayer,
  kNewGame,
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
  kGameFolders,
  kDemos,
  kHelp,
  kQuit,
  kCount
};

// The page that a stock console command opens: "menu_load", "menu_options", "help", ...
struct MenuCommand {
  std::string_view name;
  MenuPage page;
};
std::vector<MenuCommand> menu_commands();

// Something that the player has to know: text, in lines that are broken where they are too long, and pages
// that help, by what he would call them.
struct Notice {
  std::string title, text;
  std::vector<std::pair<std::string, MenuPage>> pages = {};
};

class Menu {
 public:
  // All of them must outlive the menu. Rows of variables that are not registered when their page opens are
  // left out.
  Menu(command::Variables& io_variables, const assets::Pictures& pictures, MenuContent content);
  ~Menu();
  Menu(Menu&&) noexcept;
  Menu& operator=(Menu&&) noexcept;

  // Opens a page, over those that are open. With kQuit nothing opens where nothing would be lost: `quit` is
  // run. Alike kNewGame, where there is nothing to choose.
  void open(MenuPage page = MenuPage::kMain);
  // Opens the main page and this above it; above what is open, where the menu is.
  void tell(Notice notice);
  void close();
  bool is_open() const;
  // A row waits for a key or a text: nothing else may have what is pressed.
  bool is_waiting() const;
  // Whether the window is to tell what is typed: while it is open, but not while it waits for a key to bind.
  bool wants_text() const;
  // The content's lists have changed: pages ask for them anew, and keep what is selected.
  void refresh();

  // Whether it was for the menu. An open one takes all that is pressed, pushed, typed and pointed at; what is
  // let go, and what happens to the window, it looks at and leaves to others.
  bool handle(const platform::InputEvent& event);

  // Appends to `io_list`, which refers to the menu until the next call of anything else. `time_s` is on the
  // clock that events are stamped with: held sticks move on. Where the pointer is counts for what was drawn
  // last. Frames too small for a line of text are left alone.
  void draw(int width, int height, double time_s, render::DrawList& io_list);

  // Lines for the console, in order; those of a file that play, without folders: "misc/menu1.wav". Each is
  // told once.
  std::vector<std::string> take_commands();
  std::vector<std::string> take_sounds();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::client
