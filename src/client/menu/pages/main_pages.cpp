// The main page, help, notices, questions, and quitting.
#include <fmt/format.h>

#include "client/menu/page.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {

namespace {

PageMaker find_page_maker(const PageContext& context, MenuPage page) {
  switch (page) {
    case MenuPage::kSinglePlayer:
      return make_single_player_page;
    case MenuPage::kNewGame:
      return find_new_game_page(context);
    case MenuPage::kSkill:
      return find_skill_page(context);
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
    case MenuPage::kLaboratory:
      return make_laboratory_page;
    case MenuPage::kGameFolders:
      return make_game_folders_page;
    case MenuPage::kGameData:
      return make_game_data_page;
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
  return confirm_if_unsaved(context, "Quit anyway?", {.commands = {"quit"}, .leaving = Leaving::kClose});
}

}  // namespace

// Quit may need no page. Opening the join page starts a search, so that servers answer while the
// player reads.
Outcome open_page(const PageContext& context, MenuPage page) {
  if (page == MenuPage::kQuit) return quit(context);
  if (page == MenuPage::kJoin && context.content.search_servers) context.content.search_servers();
  // Choices that were not applied are forgotten.
  if (page == MenuPage::kVideo) context.choices.video.reset();
  return {.page = find_page_maker(context, page)};
}

std::unique_ptr<Row> make_page_link(const PageContext& context, std::string label, MenuPage page,
                                    std::string help) {
  return std::make_unique<ActionRow>(
      std::move(label), [context, page] { return open_page(context, page); }, std::move(help));
}

PageMaker make_notice(Notice notice) {
  return [notice = std::move(notice)](const PageContext& context) {
    Page page;
    page.title = notice.title;
    page.text = notice.text;
    page.rows.push_back(std::make_unique<ActionRow>("OK", [] { return Outcome{.leaving = Leaving::kBack}; }));
    for (const auto& [label, helpful] : notice.pages)
      page.rows.push_back(make_page_link(context, label, helpful));
    return page;
  };
}

// "No" is selected, so that a key pressed too often does no harm.
PageMaker make_question(std::string question, Outcome yes) {
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

Outcome confirm_if_unsaved(const PageContext& context, std::string_view question, Outcome outcome) {
  const std::string lost = call_or_default(context.content.unsaved);
  if (lost.empty()) return outcome;
  return {.page = make_question(fmt::format("{}\n{}", lost, question), std::move(outcome))};
}

Page make_main_page(const PageContext& context) {
  Page page;
  page.title = "Temblor";
  page.title_picture = "gfx/ttl_main.lmp";
  page.style = PageStyle::kLarge;
  const auto add_link = [&](const char* label, MenuPage opened) {
    page.rows.push_back(make_page_link(context, label, opened));
  };
  add_link("Single player", MenuPage::kSinglePlayer);
  add_link("Multiplayer", MenuPage::kMultiplayer);
  add_link("Options", MenuPage::kOptions);
  add_link("Levels", MenuPage::kLevels);
  add_link("Mods", MenuPage::kGameFolders);
  add_link("Demos", MenuPage::kDemos);
  add_link("Help", MenuPage::kHelp);
  if (call_or_default(context.content.game_runs))
    page.rows.push_back(std::make_unique<ActionRow>("Leave game", [context] {
      return confirm_if_unsaved(context, "Leave anyway?", {.commands = {"disconnect"}, .refresh = true});
    }));
  if (call_or_default(context.content.demo_plays))
    page.rows.push_back(std::make_unique<ActionRow>(
        "Stop demo", [] { return Outcome{.commands = {"stopdemo"}, .refresh = true}; }));
  add_link("Quit", MenuPage::kQuit);
  return page;
}

Page make_help_page(const PageContext& context) {
  Page page;
  page.title = "Help";
  page.text = call_or_default(context.content.help_text);
  page.empty_text = "No help available.";
  return page;
}

}  // namespace temblor::client
