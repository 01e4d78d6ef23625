#include "client/prediction/level_environment.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "formats/levels/entities.h"

namespace temblor::client {
namespace {

// Finds a key with or without a leading underscore. Mappers add it so that engines without the key do not
// warn.
std::optional<std::string_view> find_key(const formats::Entity& entity, const std::string& key) {
  const auto plain = entity.find(key);
  return plain ? plain : entity.find("_" + key);
}

// Up to four numbers separated by spaces; stops at the first thing that is not a number. Numbers are parsed
// independently of the locale.
struct Numbers {
  std::array<float, 4> values{};
  std::size_t count = 0;
};
Numbers parse_numbers(std::string_view text) {
  Numbers numbers;
  while (numbers.count < numbers.values.size()) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    float value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || !(value >= -1e9f && value <= 1e9f)) break;
    numbers.values[numbers.count++] = value;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return numbers;
}

render::Fog parse_fog(const formats::Entity& worldspawn) {
  const auto text = find_key(worldspawn, "fog");
  if (!text) return {};
  const auto [values, count] = parse_numbers(*text);
  render::Fog fog;
  fog.density = std::max(values[0], 0.0f);
  fog.color = count == 4 ? glm::clamp(math::Vec3(values[1], values[2], values[3]), 0.0f, 1.0f)
                         : math::Vec3(0.3f);  // the gray that other engines use for a density alone
  return count == 0 ? render::Fog{} : fog;
}

std::optional<float> parse_number(const formats::Entity& worldspawn, const std::string& key, float max) {
  const auto text = find_key(worldspawn, key);
  const Numbers numbers = parse_numbers(text.value_or(""));
  if (numbers.count == 0) return std::nullopt;
  return std::clamp(numbers.values[0], 0.0f, max);
}

}  // namespace

render::LiquidAlpha LevelEnvironment::liquid_alpha(const render::LiquidAlpha& fallback) const {
  return {water_alpha.value_or(fallback.water), slime_alpha.value_or(fallback.slime),
          lava_alpha.value_or(fallback.lava), teleport_alpha.value_or(fallback.teleport)};
}

LevelEnvironment parse_environment(const world::Level& level) {
  LevelEnvironment environment;
  if (level.entities.empty()) return environment;
  const formats::Entity& worldspawn = level.entities[0];
  for (const char* key : {"sky", "skyname", "qlsky"})
    if (const auto name = find_key(worldspawn, key); name && environment.skybox.empty())
      environment.skybox = *name;
  environment.fog = parse_fog(worldspawn);
  environment.water_alpha = parse_number(worldspawn, "wateralpha", 1);
  environment.slime_alpha = parse_number(worldspawn, "slimealpha", 1);
  environment.lava_alpha = parse_number(worldspawn, "lavaalpha", 1);
  environment.teleport_alpha = parse_number(worldspawn, "telealpha", 1);
  constexpr float kMaxPar_s = 59999;  // the longest time on the screen at the end of a level
  environment.par_s = parse_number(worldspawn, "par", kMaxPar_s).value_or(0);
  return environment;
}

}  // namespace temblor::client
