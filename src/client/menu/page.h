// A page's contents: title, rows and texts. Pages are values made by functions, one for each page, and made
// again whenever they open or what they show has changed. PageView draws and drives them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assets/pictures.h"
#include "client/menu/menu.h"
#include "client/menu/menu_content.h"
#include "client/menu/rows/row.h"
#include "command/variables.h"

namespace temblor::client {

enum class PageStyle {
  kLarge,    // a few rows of large characters
  kRows,     // labels and values
  kDetails,  // a list, and beside it a picture and text about the selected row
};

// A page's contents. Texts may contain any bytes.
struct Page {
  std::string title;
  // A picture that replaces the title if the game has it.
  std::string_view title_picture;
  PageStyle style = PageStyle::kRows;
  // Typing filters the rows.
  bool has_search = false;
  // Text above the rows; a page with only text scrolls it.
  std::string text;
  // Shown if no row can be selected.
  std::string empty_text;
  Rows rows;
  // Rows before this one, such as "New save", are not part of the list that is searched, so they do not
  // count.
  std::size_t first_entry = 0;
  // The row that is selected when the page opens.
  std::size_t first_choice = 0;
  // A picture below the rows, if there is room. It must live until the function is called again.
  std::function<const formats::Picture*()> picture;

  // Adds a row at the end. Ignores null, which functions return for variables that are not registered.
  void add(std::unique_ptr<Row> row) {
    if (row) rows.push_back(std::move(row));
  }
};

// The rows of the host page's game mode, in their order.
enum class HostMode { kDeathmatch, kTeams, kCaptureTheFlag, kCooperative };

// Choices that the player has made but not applied. They live as long as the menu, so that a page shows them
// again when it is rebuilt.
struct MenuChoices {
  // The address on the join page.
  std::string address;
  struct Host {
    std::string level;
    int players = 8;
    HostMode mode = HostMode::kDeathmatch;
    bool has_friendly_fire = false;  // in team games
    // The number of players that bots fill the game up to; nothing before the player has chosen it.
    std::optional<int> bot_fill = std::nullopt;
  } host;
  struct Video {
    std::string mode;
    int display = 0;
    platform::PixelSize size;
    bool operator==(const Video&) const = default;
  };
  // The choices on the video page, and the values of the variables when the page was made.
  std::optional<Video> video;
  std::optional<Video> video_before;
};

// The services for functions that make pages and rows. All of them outlive the pages.
struct PageContext {
  command::Variables& variables;
  const assets::Pictures& pictures;
  const MenuContent& content;
  MenuChoices& choices;
};

// Calls a function of the content; returns an empty value if the function is empty.
template <typename Result, typename... Parameters>
Result call_or_default(const std::function<Result(Parameters...)>& function, Parameters... parameters) {
  return function ? function(parameters...) : Result{};
}

// The outcome of opening a page; see Menu::open() for pages that may run a command instead.
Outcome open_page(const PageContext& context, MenuPage page);
// A row that opens a page.
std::unique_ptr<Row> make_page_link(const PageContext& context, std::string label, MenuPage page,
                                    std::string help = {});

PageMaker make_notice(Notice notice);
// A page that asks a question; "Yes" leads to the outcome `yes`, "No" back.
PageMaker make_question(std::string question, Outcome yes);
// Returns `outcome`, or a page that asks for confirmation first if unsaved progress would be lost. `question`
// follows the sentence about what would be lost (MenuContent::unsaved): "Quit anyway?".
Outcome confirm_if_unsaved(const PageContext& context, std::string_view question, Outcome outcome);

// Each makes the page of that name from the content and the variables as they are now.
Page make_main_page(const PageContext& context);
Page make_help_page(const PageContext& context);

Page make_single_player_page(const PageContext& context);
// Starts a game on a level; with the skill of the variable `skill` if none is given.
Outcome start_single_player(const PageContext& context, const std::string& level,
                            std::optional<std::size_t> skill = std::nullopt);
// The first page of a new game: the episodes if there are several, otherwise the page of find_skill_page().
PageMaker find_new_game_page(const PageContext& context);
// The choice of the skill for a game that begins in the level "start"; the list of levels, which has that
// choice, for data without that level.
PageMaker find_skill_page(const PageContext& context);
// A row of a list of levels, with the level's title and picture beside the list.
std::unique_ptr<Row> make_level_row(const MenuContent& content, const MenuLevel& level,
                                    std::function<Outcome()> choose);
// Null if the variable `skill` is not registered.
std::unique_ptr<Row> make_skill_row(const PageContext& context);
Page make_load_page(const PageContext& context);
Page make_save_page(const PageContext& context);
Page make_levels_page(const PageContext& context);
Page make_game_folders_page(const PageContext& context);
Page make_game_data_page(const PageContext& context);
Page make_demos_page(const PageContext& context);

Page make_multiplayer_page(const PageContext& context);
Page make_join_page(const PageContext& context);
Page make_host_page(const PageContext& context);
Page make_player_page(const PageContext& context);

Page make_options_page(const PageContext& context);
Page make_video_page(const PageContext& context);
Page make_screen_page(const PageContext& context);
Page make_sound_page(const PageContext& context);
Page make_controls_page(const PageContext& context);
Page make_keys_page(const PageContext& context);
Page make_accessibility_page(const PageContext& context);
// Chooses a technique, and closes the menu so that the player sees it.
Page make_laboratory_page(const PageContext& context);

}  // namespace temblor::client
