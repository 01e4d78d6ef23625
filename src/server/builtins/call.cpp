#include "server/builtins/call.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::server {

base::Result<vm::EntityIndex> Call::player(int i) const {
  TRY(const vm::EntityIndex value, entity(i));
  if (!is_player(value))
    return error("parameter {} is entity {}, which is not a player", i + 1, base::to_size(value));
  return value;
}

std::vector<std::string> Call::localized_texts(int first) const {
  const formats::Localization none;
  const formats::Localization& known = game.localization == nullptr ? none : *game.localization;
  std::vector<std::string> texts;
  for (int i = first; i < machine.parameter_count(); ++i) texts.push_back(known.localize(text(i)));
  return texts;
}

std::string Call::localized_text(int first) const {
  const bool is_key = first < machine.parameter_count() && game.localization != nullptr &&
                      game.localization->has_text_for(text(first));
  const std::vector<std::string> texts = localized_texts(first);
  if (is_key && texts[0].find('{') != std::string::npos)
    return formats::fill_places(texts[0], std::span(texts).subspan(1));
  return fmt::format("{}", fmt::join(texts, ""));
}

// The search is linear: levels have at most a few hundred sounds, most of them found early.
std::optional<std::uint16_t> Call::sound_number(std::string_view sample) const {
  const std::vector<std::string>& sounds = game.precache.sounds;
  const auto found = std::find(sounds.begin() + 1, sounds.end(), sample);
  if (found != sounds.end()) return static_cast<std::uint16_t>(found - sounds.begin());
  warn_once(fmt::format("\"{}\" was not precached", base::quotable(sample)));
  return std::nullopt;
}

}  // namespace temblor::server
