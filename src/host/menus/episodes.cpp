#include "host/menus/episodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <tuple>

namespace temblor::host {
namespace {

constexpr std::string_view kStart = "start";

struct Episode {
  std::string_view series;  // "e" for e1m1
  int number = 0;
  const client::MenuLevel* first_level = nullptr;
};

std::optional<Episode> find_episode(const client::MenuLevel& level) {
  constexpr std::string_view kFirst = "m1", kDigits = "0123456789";
  std::string_view name = level.name;
  if (!name.ends_with(kFirst)) return std::nullopt;
  name.remove_suffix(kFirst.size());
  const std::size_t end_of_series = name.find_last_not_of(kDigits) + 1;
  Episode episode{name.substr(0, end_of_series), 0, &level};
  const std::string_view digits = name.substr(end_of_series);
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), episode.number);
  return failure == std::errc() ? std::optional(episode) : std::nullopt;
}

}  // namespace

std::vector<client::MenuEpisode> find_episodes(std::span<const client::MenuLevel> levels) {
  std::vector<Episode> episodes;
  std::vector<client::MenuEpisode> places;
  for (const client::MenuLevel& level : levels) {
    if (level.name == kStart) places.push_back({level.title, level.name});
    if (const std::optional<Episode> episode = find_episode(level)) episodes.push_back(*episode);
  }
  if (episodes.size() < 2) return {};
  std::ranges::sort(episodes, {}, [](const Episode& e) { return std::tuple(e.series, e.number); });
  for (const Episode& episode : episodes)
    places.push_back(
        {fmt::format("Episode {}", episode.number), episode.first_level->name, episode.first_level->title});
  return places;
}

}  // namespace temblor::host
