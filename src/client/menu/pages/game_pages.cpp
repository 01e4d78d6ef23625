// Beginning, keeping and resuming games: single player, levels, saves, demos, game folders.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "client/menu/page.h"
#include "client/menu/rows/option_rows.h"
#include "client/menu/rows/plain_rows.h"
#include "command/text.h"

namespace temblor::client {
namespace {

constexpr std::string_view kSkills[] = {"easy", "normal", "hard", "nightmare"};

Outcome single_player_in(const PageContext& context, const std::string& level) {
  return unless_lost(
      context, "Begin another one all the same?",
      {.commands = {"maxplayers 1", "deathmatch 0", "coop 0", command::join_words({"map", level})},
       .leaving = Leaving::kClose});
}

std::string or_name(const std::string& title, const std::string& name) {
  return title.empty() ? name : title;
}

std::string minutes_and_seconds(double seconds) {
  constexpr double kMost = 359999;  // 99:59:59
  const int whole = std::isfinite(seconds) ? static_cast<int>(std::clamp(seconds, 0.0, kMost)) : 0;
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::unique_ptr<Row> make_save_row(const MenuContent& content, const MenuSave& save,
                                   std::function<Outcome()> choose) {
  return std::make_unique<ListRow>(ListEntry{
      .left = save.name,
      .middle = save.level_title,
      .details =
          [&content, save] {
            return RowDetails{asked(content.save_picture, std::string_view(save.name)),
                              {or_name(save.level_title, save.name),
                               fmt::format("{}, {} of {} monster{}", minutes_and_seconds(save.time_s),
                                           save.kills, save.monsters, save.monsters == 1 ? "" : "s")}};
          },
      .choose = std::move(choose)});
}

// The first of s0, s1, ... that is free.
std::string free_save_name(const std::vector<MenuSave>& saves) {
  std::set<std::string, std::less<>> taken;
  for (const MenuSave& save : saves) taken.insert(save.name);
  int number = 0;
  while (taken.contains(fmt::format("s{}", number))) ++number;
  return fmt::format("s{}", number);
}

Outcome save_as(const std::string& name) {
  return {.commands = {command::join_words({"save", name})}, .leaving = Leaving::kClose};
}

}  // namespace

std::unique_ptr<Row> make_level_row(const MenuContent& content, const MenuLevel& level,
                                    std::function<Outcome()> choose) {
  return std::make_unique<ListRow>(ListEntry{
      .left = level.name,
      .middle = level.title,
      .details =
          [&content, level] {
            return RowDetails{asked(content.level_picture, std::string_view(level.name)),
                              {or_name(level.title, level.name), level.title.empty() ? "" : level.name}};
          },
      .choose = std::move(choose)});
}

std::unique_ptr<Row> make_skill_row(const PageContext& context) {
  return make_option_row(context.variables, {.variable = "skill", .label = "Skill", .names = kSkills});
}

Page make_single_player_page(const PageContext& context) {
  Page page;
  page.title = "Single player";
  page.title_picture = "gfx/ttl_sgl.lmp";
  page.style = PageStyle::kLarge;
  page.rows.push_back(make_opener(context, "New game", MenuPage::kNewGame));
  page.rows.push_back(make_opener(context, "Load", MenuPage::kLoad));
  if (asked(context.content.can_save)) page.rows.push_back(make_opener(context, "Save", MenuPage::kSave));
  page.rows.push_back(make_opener(context, "Levels", MenuPage::kLevels));
  return page;
}

Outcome new_game(const PageContext& context) {
  constexpr std::string_view kStart = "start";
  if (!asked(context.content.episodes).empty()) return {.page = make_new_game_page};
  const std::vector<MenuLevel> levels = asked(context.content.levels);
  const bool has_start = levels.empty() || std::any_of(levels.begin(), levels.end(),
                                                       [&](const MenuLevel& l) { return l.name == kStart; });
  return has_start ? single_player_in(context, std::string(kStart)) : Outcome{.page = make_levels_page};
}

Page make_new_game_page(const PageContext& context) {
  Page page;
  page.title = "New game";
  page.add(make_skill_row(context));
  page.rows.push_back(std::make_unique<HeadingRow>("Begin with"));
  page.first_choice = page.rows.size();
  for (const MenuEpisode& episode : asked(context.content.episodes))
    page.rows.push_back(std::make_unique<ListRow>(
        ListEntry{.left = or_name(episode.title, episode.first_level),
                  .choose = [context, episode] { return single_player_in(context, episode.first_level); }}));
  return page;
}

Page make_levels_page(const PageContext& context) {
  Page page;
  page.title = "Levels";
  page.style = PageStyle::kDetails;
  page.searched = true;
  page.nothing = "No levels were found.";
  page.add(make_skill_row(context));
  page.first_choice = page.rows.size();
  for (const MenuLevel& level : asked(context.content.levels))
    if (!level.name.empty())
      page.rows.push_back(make_level_row(
          context.content, level, [context, name = level.name] { return single_player_in(context, name); }));
  return page;
}

Page make_load_page(const PageContext& context) {
  Page page;
  page.title = "Load";
  page.title_picture = "gfx/p_load.lmp";
  page.style = PageStyle::kDetails;
  page.searched = true;
  page.nothing = "There are no saved games.";
  for (const MenuSave& save : asked(context.content.saves))
    if (!save.name.empty())
      page.rows.push_back(make_save_row(context.content, save, [name = save.name] {
        return Outcome{.commands = {command::join_words({"load", name})}, .leaving = Leaving::kClose};
      }));
  return page;
}

Page make_save_page(const PageContext& context) {
  Page page;
  page.title = "Save";
  page.title_picture = "gfx/p_save.lmp";
  page.style = PageStyle::kDetails;
  page.searched = true;
  page.nothing = "There is no game that could be saved.";
  if (!asked(context.content.can_save)) return page;
  const std::vector<MenuSave> saves = asked(context.content.saves);
  page.rows.push_back(
      std::make_unique<ActionRow>("A new save", [name = free_save_name(saves)] { return save_as(name); }));
  for (const MenuSave& save : saves)
    if (!save.name.empty())
      page.rows.push_back(make_save_row(context.content, save, [save] {
        return Outcome{
            .page = ask(fmt::format("Save over {} ({})?", save.name, or_name(save.level_title, "no title")),
                        save_as(save.name))};
      }));
  return page;
}

Page make_demos_page(const PageContext& context) {
  Page page;
  page.title = "Demos";
  page.searched = true;
  page.nothing = "No demos were found.";
  for (const MenuDemo& demo : asked(context.content.demos))
    if (!demo.name.empty())
      page.rows.push_back(std::make_unique<ListRow>(ListEntry{
          .left = demo.name, .middle = demo.title, .choose = [context, name = demo.name] {
            return unless_lost(
                context, "Play the demo all the same?",
                {.commands = {command::join_words({"playdemo", name})}, .leaving = Leaving::kClose});
          }}));
  return page;
}

Page make_game_folders_page(const PageContext& context) {
  Page page;
  page.title = "Game folders";
  page.title_picture = "gfx/p_mods.lmp";
  page.searched = true;
  page.nothing = "No game folders were found.";
  for (const MenuGameFolder& folder : asked(context.content.game_folders)) {
    if (folder.name.empty()) continue;
    if (folder.in_use) page.first_choice = page.rows.size();
    page.rows.push_back(std::make_unique<ListRow>(ListEntry{
        .left = folder.name,
        .middle = folder.title,
        .right = folder.in_use ? "in use" : "",
        .choose = [context, name = folder.name] {
          return unless_lost(context, "Switch all the same?",
                             {.commands = {command::join_words({"game", name})}, .leaving = Leaving::kClose});
        }}));
  }
  return page;
}

}  // namespace temblor::client
