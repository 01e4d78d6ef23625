// Pages that lead to a new game: where it starts, then the skill.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "client/menu/page.h"
#include "client/menu/rows/option_rows.h"
#include "client/menu/rows/plain_rows.h"
#include "command/text.h"

namespace temblor::client {
namespace {

constexpr std::string_view kSkill = "skill";
constexpr std::string_view kSkills[] = {"easy", "normal", "hard", "nightmare"};
constexpr std::array<std::string_view, std::size(kSkills)> kSkillLabels = {"Easy", "Normal", "Hard",
                                                                           "Nightmare"};

// A level in which the player chooses an episode.
constexpr std::string_view kStart = "start";

// Returns the index of the chosen skill.
std::size_t read_skill(const command::Variables& variables) {
  const command::Variable* const skill = variables.find(kSkill);
  const double number = skill == nullptr ? 0 : skill->number;
  return static_cast<std::size_t>(std::clamp(std::round(number), 0.0, double{kSkillLabels.size() - 1}));
}

PageMaker make_skill_page(std::string level) {
  return [level = std::move(level)](const PageContext& context) {
    Page page;
    page.title = "Skill";
    page.style = PageStyle::kLarge;
    for (std::size_t skill = 0; skill < kSkillLabels.size(); ++skill)
      page.rows.push_back(std::make_unique<ActionRow>(
          std::string(kSkillLabels[skill]),
          [context, skill, level] { return start_single_player(context, level, skill); }));
    page.first_choice = read_skill(context.variables);
    return page;
  };
}

Page make_episodes_page(const PageContext& context) {
  Page page;
  page.title = "New game";
  for (const MenuEpisode& episode : call_or_default(context.content.episodes))
    page.rows.push_back(std::make_unique<ListRow>(ListEntry{
        .left = episode.title.empty() ? episode.first_level : episode.title,
        .middle = episode.title.empty() ? "" : episode.level_title,
        .choose = [level = episode.first_level] { return Outcome{.page = make_skill_page(level)}; }}));
  return page;
}

}  // namespace

Outcome start_single_player(const PageContext& context, const std::string& level,
                            std::optional<std::size_t> skill) {
  Outcome started{.leaving = Leaving::kClose};
  if (skill) started.commands.push_back(fmt::format("{} {}", kSkill, *skill));
  // Sets the game mode too, as the last game may have been a multiplayer one.
  for (const char* const rule : {"maxplayers 1", "deathmatch 0", "coop 0"})
    started.commands.emplace_back(rule);
  started.commands.push_back(command::join_words({"map", level}));
  return confirm_if_unsaved(context, "Start a new game anyway?", std::move(started));
}

std::unique_ptr<Row> make_skill_row(const PageContext& context) {
  return make_option_row(context.variables, {.variable = kSkill, .label = "Skill", .names = kSkills});
}

PageMaker find_new_game_page(const PageContext& context) {
  if (!call_or_default(context.content.episodes).empty()) return make_episodes_page;
  return find_skill_page(context);
}

PageMaker find_skill_page(const PageContext& context) {
  const std::vector<MenuLevel> levels = call_or_default(context.content.levels);
  const bool has_start = levels.empty() || std::any_of(levels.begin(), levels.end(),
                                                       [](const MenuLevel& l) { return l.name == kStart; });
  return has_start ? make_skill_page(std::string(kStart)) : PageMaker(make_levels_page);
}

}  // namespace temblor::client
