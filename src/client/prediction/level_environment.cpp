#include "client/prediction/level_environment.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "formats/levels/entities.h"

namespace temblor::client {
namespace {

std::optional<std::string_view> find_either(const formats::Entity& entity, const std::string& key) {
  const auto plain = entity.find(key);
  return plain ? plain : entity.find("_" + key);
}

// Numbers with spaces between, as many as there are, at most four.
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

render::Fog fog_of(const formats::Entity& worldspawn) {
  const auto text = find_either(worldspawn, "fog");
  if (!text) return {};
  const auto [values, count] = parse_numbers(*text);
  render::Fog fog;
  fog.density = std::max(values[0], 0.0f);
  fog.color = count == 4 ? glm::clamp(math::Vec3(values[1], values[2], values[3]), 0.0f, 1.0f)
                         : math::Vec3(0.3f);  // as other engines have it for a density alone
  return count == 0 ? render::Fog{} : fog;
}

std::optional<float> alpha_of(const formats::Entity& worldspawn, const std::string& key) {
  const auto text = find_either(worldspawn, key);
  const Numbers numbers = parse_numbers(text.value_or(""));
  if (numbers.count == 0) return std::nullopt;
  return std::clamp(numbers.values[0], 0.0f, 1.0f);
}

}  // namespace

render::LiquidAlpha LevelEnvironment::liquid_alpha(const render::LiquidAlpha& otherwise) const {
  return {water_alpha.value_or(otherwise.water), slime_alpha.value_or(otherwise.slime),
          lava_alpha.value_or(otherwise.lava), teleport_alpha.value_or(otherwise.teleport)};
}

LevelEnvironment environment_of(const world::Level& level) {
  LevelEnvironment environment;
  if (level.entities.empty()) return environment;
  const formats::Entity& worldspawn = level.entities[0];
  for (const char* key : {"sky", "skyname", "qlsky"})
    if (const auto name = find_either(worldspawn, key); name && environment.skybox.empty())
      environment.skybox = *name;
  environment.fog = fog_of(worldspawn);
  environment.water_alpha = alpha_of(worldspawn, "wateralpha");
  environment.slime_alpha = alpha_of(worldspawn, "slimealpha");
  environment.lava_alpha = alpha_of(worldspawn, "lavaalpha");
  environment.teleport_alpha = alpha_of(worldspawn, "telealpha");
  return environment;
}

}  // namespace temblor::client
