// Animated textures (+0..+9 and +a..+j) and light styles.
//
// Both depend on the time only, which is always a parameter in seconds, so frames can be drawn for any time
// and in any order. Rates and patterns are those of the original game: 10 ticks per second, without
// interpolation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "world/level.h"

namespace temblor::world {

// Returns the texture to draw instead of `texture` at `time_s` (finite; negative counts as 0). Frames last
// 0.2 s. If the entity's frame is not 0, the alternate sequence plays, if there is one.
TextureIndex find_animated_texture(const Level& level, TextureIndex texture, double time_s, int entity_frame);

// Styles 0 to 11 are standard patterns, 32 to 62 belong to lights that switch, and 63 is for tests.
constexpr std::size_t kLightStyles = 64;
// The factor of each light style, in 1/256: 256 draws light samples as they are stored. ('m', the normal
// level, is 264, as in the original.)
using LightStyleValues = std::array<std::uint16_t, kLightStyles>;
constexpr LightStyleValues make_stored_light_styles() {
  LightStyleValues values{};
  values.fill(256);
  return values;
}

// Patterns of letters, 10 per second, that repeat: 'a' is dark, 'm' normal, 'z' about double. An empty
// pattern is constantly 256. Servers send them, so that every client sees the same flicker.
using LightStylePatterns = std::array<std::string, kLightStyles>;
// Returns the twelve patterns that every game starts with. Style 63 is "a" (for tests); the rest are empty.
LightStylePatterns make_standard_light_styles();
// kMean and kHighest are constant, for players whom flicker disturbs.
enum class LightStyleMode { kFlickering, kMean, kHighest };
// Returns the values at `time_s` (finite; negative counts as 0). Other characters count as the nearest
// letter.
LightStyleValues compute_light_styles(const LightStylePatterns& patterns, double time_s,
                                      LightStyleMode mode = LightStyleMode::kFlickering);

}  // namespace temblor::world
