// The first page, help, and leaving the game.
#include <fmt/format.h>

#include "client/menu/page.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {

namespace {

PageMaker maker_of(MenuPage page) {
  switch (page) {
    case MenuPage::kSinglePlayer:
      return make_single_player_page;
    case MenuPage::kNewGame:
      return make_new_game_page;
    case MenuPage::kLoad:
      return make_load_page;
    case MenuPage::kSave:
      return make_save_page;
    case MenuPage::kLevels:
      return make_levels_page;
    case MenuPage::kMultiplayer:
      return make_multiplayer_page;
    case MenuPage::kJoin:
      return make_join_page;
    case MenuPage::kHost:
      return make_host_page;
    case MenuPage::kPlayer:
      return make_player_page;
    case MenuPage::kOptions:
      return make_options_page;
    case MenuPage::kVideo:
      return make_video_page;
    case MenuPage::kScreen:
      return make_screen_page;
    case MenuPage::kSound:
      return make_sound_page;
    case MenuPage::kControls:
      return make_controls_page;
    case MenuPage::kKeys:
      return make_keys_page;
    case MenuPage::kAccessibility:
      return make_accessibility_page;
    case MenuPage::kGameFolders:
      return make_game_folders_page;
    case MenuPage::kDemos:
      return make_demos_page;
    case MenuPage::kHelp:
      return make_help_page;
    case MenuPage::kMain:
    case MenuPage::kQuit:
    case MenuPage::kCount:
      break;
  }
  return make_main_page;
}

Outcome quit(const PageContext& context) {
  return unless_lost(context, "Quit all the same?", {.commands = {"quit"}, .leaving = Leaving::kClose});
}

}  // namespace

Outcome opening(const PageContext& context, MenuPage page) {
  if (page == MenuPage::kQuit) return quit(context);
  if (page == MenuPage::kNewGame) return new_game(context);
  if (page == MenuPage::kJoin && context.content.search_servers) context.content.search_servers();
  // What was chosen there and not applied is forgotten.
  if (page == MenuPage::kVideo) context.choices.video.reset();
  return {.page = maker_of(page)};
}

std::unique_ptr<Row> make_opener(const PageContext& context, std::string label, MenuPage page,
                                 std::string help) {
  return std::make_unique<ActionRow>(
      std::move(label), [context, page] { return opening(context, page); }, std::move(help));
}

PageMaker make_notice(Notice notice) {
  return [notice = std::move(notice)](const PageContext& context) {
    Page page;
    page.title = notice.title;
    page.text = notice.text;
    page.rows.push_back(std::make_unique<ActionRow>("OK", [] { return Outcome{.leaving = Leaving::kBack}; }));
    for (const auto& [label, helpful] : notice.pages)
      page.rows.push_back(make_opener(context, label, helpful));
    return page;
  };
}

PageMaker ask(std::string question, Outcome yes) {
  return [question = std::move(question), yes = std::move(yes)](const PageContext&) {
    Page page;
    page.title = "Are you sure?";
    page.text = question;
    page.rows.push_back(std::make_unique<ActionRow>(
        "Yes",
        [yes] {
          Outcome outcome = yes;
          if (outcome.leaving == Leaving::kStay) outcome.leaving = Leaving::kBack;
          return outcome;
        },
        "", 'y'));
    page.rows.push_back(std::make_unique<ActionRow>(
        "No", [] { return Outcome{.leaving = Leaving::kBack}; }, "", 'n'));
    page.first_choice = 1;
    return page;
  };
}

Outcome unless_lost(const PageContext& context, std::string_view doing, Outcome outcome) {
  const std::string lost = asked(context.content.unsaved);
  if (lost.empty()) return outcome;
  return {.page = ask(fmt::format("{}\n{}", lost, doing), std::move(outcome))};
}

Page make_main_page(const PageContext& context) {
  Page page;
  page.title = "Temblor";
  page.title_picture = "gfx/ttl_main.lmp";
  page.style = PageStyle::kLarge;
  const auto add_opener = [&](const char* label, MenuPage opened) {
    page.rows.push_back(make_opener(context, label, opened));
  };
  add_opener("Single player", MenuPage::kSinglePlayer);
  add_opener("Multiplayer", MenuPage::kMultiplayer);
  add_opener("Options", MenuPage::kOptions);
  add_opener("Levels", MenuPage::kLevels);
  add_opener("Game folders", MenuPage::kGameFolders);
  add_opener("Demos", MenuPage::kDemos);
  add_opener("Help", MenuPage::kHelp);
  if (asked(context.content.game_runs))
    page.rows.push_back(std::make_unique<ActionRow>("Leave game", [context] {
      return unless_lost(context, "Leave all the same?", {.commands = {"disconnect"}, .refresh = true});
    }));
  add_opener("Quit", MenuPage::kQuit);
  return page;
}

Page make_help_page(const PageContext& context) {
  Page page;
  page.title = "Help";
  page.text = asked(context.content.help_text);
  page.nothing = "There is no help text.";
  return page;
}

}  // namespace temblor::client
