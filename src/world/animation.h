// What moves by itself in a level: textures +0..+9 / +a..+j and light styles. Time is always a parameter, in
// double.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "world/level.h"

namespace temblor::world {

// The texture to draw in place of `texture` at `time_s` (finite; before 0 counts as 0): frames last 0.2 s;
// the other sequence plays when the entity's frame is not 0 and there is one.
TextureIndex animated_texture(const Level& level, TextureIndex texture, double time_s, int entity_frame);

constexpr std::size_t kLightStyles = 64;
// 256 = the light as stored ('m' gives 264, as the original has it).
using LightStyleValues = std::array<std::uint16_t, kLightStyles>;
constexpr LightStyleValues light_as_stored() {
  LightStyleValues values{};
  values.fill(256);
  return values;
}

// Patterns of letters, 10 a second: 'a' dark, 'm' normal, 'z' about double. Empty: constantly 256.
using LightStylePatterns = std::array<std::string, kLightStyles>;
// The twelve patterns every game starts with; 63 is "a" (tests); the rest empty.
LightStylePatterns standard_light_styles();
// At `time_s` (finite; before 0 counts as 0). Other characters count as the nearest letter.
LightStyleValues light_style_values(const LightStylePatterns& patterns, double time_s);

}  // namespace temblor::world
