#include "world/entity_opacity.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace temblor::world {

// A missing or unreadable amount is 0, as in Half-Life.
std::optional<float> find_half_life_opacity(const formats::Entity& entity) {
  constexpr int kNormal = 0, kAlphaTested = 4, kOpaqueAmount = 255;
  const auto find_number = [&](std::string_view key) {
    const std::string text(entity.find(key).value_or(""));
    return static_cast<int>(std::clamp(std::strtol(text.c_str(), nullptr, 10), 0l, 255l));
  };
  const int mode = find_number("rendermode");
  if (mode == kNormal || mode == kAlphaTested) return std::nullopt;
  return static_cast<float>(find_number("renderamt")) / kOpaqueAmount;
}

float find_opacity(const formats::Entity& entity, bool is_half_life) {
  if (const auto opacity = is_half_life ? find_half_life_opacity(entity) : std::nullopt) return *opacity;
  const float alpha = entity.find_number("alpha").value_or(0);
  return alpha == 0 ? 1 : std::clamp(alpha, 0.0f, 1.0f);
}

}  // namespace temblor::world
