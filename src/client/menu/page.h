// Pages: what each of them has, made anew whenever it opens or what it shows has changed.
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
  kLarge,    // few rows of large characters
  kRows,     // labels and values
  kDetails,  // a list with a picture and text of what is selected beside it
};

struct Page {
  std::string title;
  std::string_view title_picture;  // in its place where the game has it
  PageStyle style = PageStyle::kRows;
  bool searched = false;  // typing finds rows
  std::string text;       // above the rows; alone on a page it scrolls
  std::string nothing;    // what stands in place of rows, where there are none to select
  Rows rows;
  std::size_t first_choice = 0;  // the row that is selected when it opens
  // Stands below the rows, where there is room; must live until it is asked for again.
  std::function<const formats::Picture*()> picture;

  void add(std::unique_ptr<Row> row) {  // null: none
    if (row) rows.push_back(std::move(row));
  }
};

// What players have chosen and not yet carried out: kept while the program runs.
struct MenuChoices {
  std::string address;
  struct Host {
    std::string level;
    int players = 8;
    int mode = 0;  // 0 deathmatch, 1 coop
  } host;
  struct Video {
    std::string mode;
    int display = 0;
    platform::PixelSize size;
    bool operator==(const Video&) const = default;
  };
  std::optional<Video> video, video_before;  // chosen, and what it was when that began
};

// All of it outlives the pages.
struct PageContext {
  command::Variables& variables;
  const assets::Pictures& pictures;
  const MenuContent& content;
  MenuChoices& choices;
};

// What the content says; without the function, nothing.
template <typename Result, typename... Parameters>
Result asked(const std::function<Result(Parameters...)>& function, Parameters... parameters) {
  return function ? function(parameters...) : Result{};
}

// What leads to a page, or to what happens in its place: see Menu::open().
Outcome opening(const PageContext& context, MenuPage page);
std::unique_ptr<Row> make_opener(const PageContext& context, std::string label, MenuPage page,
                                 std::string help = {});

PageMaker make_notice(Notice notice);
// A question with "Yes" and "No"; `yes` happens instead of it.
PageMaker ask(std::string question, Outcome yes);
// `outcome`, asked about first where it would lose something.
Outcome unless_lost(const PageContext& context, std::string_view doing, Outcome outcome);

Page make_main_page(const PageContext& context);
Page make_help_page(const PageContext& context);

Page make_single_player_page(const PageContext& context);
// Opens the page, or begins where there is nothing to choose.
Outcome new_game(const PageContext& context);
std::unique_ptr<Row> make_level_row(const MenuContent& content, const MenuLevel& level,
                                    std::function<Outcome()> choose);
std::unique_ptr<Row> make_skill_row(const PageContext& context);  // null without such a variable
Page make_new_game_page(const PageContext& context);
Page make_load_page(const PageContext& context);
Page make_save_page(const PageContext& context);
Page make_levels_page(const PageContext& context);
Page make_game_folders_page(const PageContext& context);
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

}  // namespace temblor::client
