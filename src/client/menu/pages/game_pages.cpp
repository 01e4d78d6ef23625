// Pages that start, save and load games: single player, levels, saves, demos and mods.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "client/menu/page.h"
#include "client/menu/rows/plain_rows.h"
#include "client/menu/rows/text_row.h"
#include "command/text.h"

namespace temblor::client {
namespace {

std::string title_or_name(const std::string& title, const std::string& name) {
  return title.empty() ? name : title;
}

// Returns "1:05", or "1:02:03" from one hour on.
std::string format_time(double seconds) {
  constexpr double kMaxTime_s = 359999;  // 99:59:59
  const int whole = std::isfinite(seconds) ? static_cast<int>(std::clamp(seconds, 0.0, kMaxTime_s)) : 0;
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

// Short lines, so that they fit beside the list: name, level, date, and what was played.
std::vector<std::string> describe_save(const MenuSave& save) {
  constexpr std::string_view kSkills[] = {"easy", "normal", "hard", "nightmare"};
  const bool has_skill = save.skill >= 0 && save.skill < std::ssize(kSkills);
  std::vector<std::string> lines;
  if (!save.title.empty()) lines.push_back(save.title);  // the list may have no room for all of it
  lines.push_back(title_or_name(save.level_title, save.name));
  if (!save.date.empty()) lines.push_back(save.date);
  lines.push_back(fmt::format("{} played", format_time(save.time_s)));
  if (has_skill) lines.push_back(fmt::format("{} skill", kSkills[save.skill]));
  lines.push_back(
      fmt::format("{} of {} monster{}", save.kills, save.monsters, save.monsters == 1 ? "" : "s"));
  if (!save.title.empty()) lines.push_back(fmt::format("File: {}", save.name));
  return lines;
}

std::unique_ptr<Row> make_save_row(const MenuContent& content, const MenuSave& save,
                                   std::function<Outcome()> choose) {
  return std::make_unique<ListRow>(
      ListEntry{.left = title_or_name(save.title, save.name),
                .middle = save.title.empty() ? save.level_title : "",
                .details =
                    [&content, save] {
                      return RowDetails{{call_or_default(content.save_picture, std::string_view(save.name))},
                                        describe_save(save)};
                    },
                .choose = std::move(choose)});
}

// Returns the first of s0, s1, ... that no save uses.
std::string find_free_save_name(const std::vector<MenuSave>& saves) {
  std::set<std::string, std::less<>> used;
  for (const MenuSave& save : saves) used.insert(save.name);
  int number = 0;
  while (used.contains(fmt::format("s{}", number))) ++number;
  return fmt::format("s{}", number);
}

Outcome save_as(const std::string& name, std::string title) {
  while (title.ends_with(' ')) title.pop_back();
  std::vector<std::string> words = {"save", name};
  if (!title.empty()) words.push_back(title);
  return {.commands = {command::join_words(words)}, .leaving = Leaving::kClose};
}

// Edits `title`, which other rows of the page use, too.
std::unique_ptr<Row> make_title_row(std::shared_ptr<std::string> title,
                                    std::function<Outcome()> after_enter) {
  return std::make_unique<TextRow>(
      "Name", TextRow::Parts{.read = [title] { return *title; },
                             .write =
                                 [title, after_enter](std::string text) {
                                   *title = std::move(text);
                                   return after_enter();
                                 },
                             .help = "Type a name for the save. Without one, it shows the level's title.",
                             .max_chars = kMaxSaveTitle});
}

// Asks for the name of a new save in the file `name`. Enter after the name saves.
PageMaker make_new_save_page(std::string name) {
  return [name = std::move(name), title = std::make_shared<std::string>()](const PageContext&) {
    const auto save = [name, title] { return save_as(name, *title); };
    Page page;
    page.title = "New save";
    page.rows.push_back(make_title_row(title, save));
    page.rows.push_back(std::make_unique<ActionRow>("Save", save));
    page.rows.push_back(
        std::make_unique<ActionRow>("Cancel", [] { return Outcome{.leaving = Leaving::kBack}; }));
    return page;
  };
}

// "No" is selected, as on other questions. The save can get another name.
PageMaker make_overwrite_page(const MenuSave& save) {
  return [save, title = std::make_shared<std::string>(save.title)](const PageContext&) {
    Page page;
    page.title = "Are you sure?";
    page.text = fmt::format("Overwrite {} ({})?", title_or_name(save.title, save.name),
                            title_or_name(save.level_title, "untitled"));
    page.rows.push_back(make_title_row(title, [] { return Outcome{}; }));
    page.rows.push_back(std::make_unique<ActionRow>(
        "Yes", [name = save.name, title] { return save_as(name, *title); }, "", 'y'));
    page.rows.push_back(std::make_unique<ActionRow>(
        "No", [] { return Outcome{.leaving = Leaving::kBack}; }, "", 'n'));
    page.first_choice = 2;
    return page;
  };
}

}  // namespace

std::unique_ptr<Row> make_level_row(const MenuContent& content, const MenuLevel& level,
                                    std::function<Outcome()> choose) {
  return std::make_unique<ListRow>(ListEntry{.left = level.name,
                                             .middle = level.title,
                                             .details =
                                                 [&content, level] {
                                                   const MenuLevelPictures pictures = call_or_default(
                                                       content.level_pictures, std::string_view(level.name));
                                                   return RowDetails{{pictures.room, pictures.overview},
                                                                     {title_or_name(level.title, level.name),
                                                                      level.title.empty() ? "" : level.name}};
                                                 },
                                             .choose = std::move(choose)});
}

Page make_single_player_page(const PageContext& context) {
  Page page;
  page.title = "Single player";
  page.title_picture = "gfx/ttl_sgl.lmp";
  page.style = PageStyle::kLarge;
  page.rows.push_back(make_page_link(context, "New game", MenuPage::kNewGame));
  page.rows.push_back(make_page_link(context, "Load game", MenuPage::kLoad));
  if (call_or_default(context.content.can_save))
    page.rows.push_back(make_page_link(context, "Save game", MenuPage::kSave));
  page.rows.push_back(make_page_link(context, "Levels", MenuPage::kLevels));
  return page;
}

Page make_levels_page(const PageContext& context) {
  Page page;
  page.title = "Levels";
  page.style = PageStyle::kDetails;
  page.has_search = true;
  page.empty_text = "No levels found.";
  page.add(make_skill_row(context));
  page.first_choice = page.first_entry = page.rows.size();
  for (const MenuLevel& level : call_or_default(context.content.levels))
    if (!level.name.empty())
      page.rows.push_back(make_level_row(context.content, level, [context, name = level.name] {
        return start_single_player(context, name);
      }));
  return page;
}

Page make_load_page(const PageContext& context) {
  Page page;
  page.title = "Load game";
  page.title_picture = "gfx/p_load.lmp";
  page.style = PageStyle::kDetails;
  page.has_search = true;
  page.empty_text = "No saved games yet.";
  for (const MenuSave& save : call_or_default(context.content.saves))
    if (!save.name.empty())
      page.rows.push_back(make_save_row(context.content, save, [name = save.name] {
        return Outcome{.commands = {command::join_words({"load", name})}, .leaving = Leaving::kClose};
      }));
  return page;
}

Page make_save_page(const PageContext& context) {
  Page page;
  page.title = "Save game";
  page.title_picture = "gfx/p_save.lmp";
  page.style = PageStyle::kDetails;
  page.has_search = true;
  page.empty_text = "You can't save right now.";
  if (!call_or_default(context.content.can_save)) return page;
  const std::vector<MenuSave> saves = call_or_default(context.content.saves);
  page.rows.push_back(std::make_unique<ActionRow>(
      "New save", [name = find_free_save_name(saves)] { return Outcome{.page = make_new_save_page(name)}; }));
  page.first_entry = page.rows.size();
  for (const MenuSave& save : saves)
    if (!save.name.empty())
      page.rows.push_back(make_save_row(context.content, save,
                                        [save] { return Outcome{.page = make_overwrite_page(save)}; }));
  return page;
}

Page make_demos_page(const PageContext& context) {
  Page page;
  page.title = "Demos";
  page.has_search = true;
  page.empty_text = "No demos found.";
  for (const MenuDemo& demo : call_or_default(context.content.demos))
    if (!demo.name.empty())
      page.rows.push_back(std::make_unique<ListRow>(ListEntry{
          .left = demo.name, .middle = demo.title, .choose = [context, name = demo.name] {
            return confirm_if_unsaved(
                context, "Play the demo anyway?",
                {.commands = {command::join_words({"playdemo", name})}, .leaving = Leaving::kClose});
          }}));
  return page;
}

Page make_game_folders_page(const PageContext& context) {
  Page page;
  page.title = "Mods";
  page.title_picture = "gfx/p_mods.lmp";
  page.has_search = true;
  page.empty_text = "No mods found.";
  for (const MenuGameFolder& folder : call_or_default(context.content.game_folders)) {
    if (folder.name.empty()) continue;
    if (folder.in_use) page.first_choice = page.rows.size();
    page.rows.push_back(std::make_unique<ListRow>(
        ListEntry{.left = folder.name,
                  .middle = folder.title,
                  .right = folder.in_use ? "active" : "",
                  .choose = [context, name = folder.name] {
                    return confirm_if_unsaved(
                        context, "Switch anyway?",
                        {.commands = {command::join_words({"game", name})}, .leaving = Leaving::kClose});
                  }}));
  }
  return page;
}

Page make_game_data_page(const PageContext& context) {
  Page page;
  page.title = "Choose your game";
  page.empty_text = "No other game found. Start Temblor with --basedir FOLDER.";
  for (const MenuGameData& data : call_or_default(context.content.game_data)) {
    if (data.in_use) page.first_choice = page.rows.size();
    page.rows.push_back(std::make_unique<ActionRow>(
        data.title,
        [context, name = data.name] {
          return confirm_if_unsaved(
              context, "Switch anyway?",
              {.commands = {command::join_words({"basedir", name})}, .leaving = Leaving::kClose});
        },
        fmt::format("{}. You can change this later under Options, Game data.", data.folder)));
  }
  return page;
}

}  // namespace temblor::client
