#include "world/animation.h"

#include <algorithm>
#include <cmath>

namespace temblor::world {
namespace {

constexpr double kTicksPerSecond = 10;
constexpr std::size_t kTicksPerTextureFrame = 2;
constexpr int kLightPerLetter = 22;  // so 'm', the 12th letter after 'a', is 264
constexpr std::uint16_t kNormalLight = 256;

constexpr std::size_t kTestStyle = 63;
constexpr std::array<std::string_view, 12> kStandardPatterns = {
    "m",
    "mmnmmommommnonmmonqnmmo",
    "abcdefghijklmnopqrstuvwxyzyxwvutsrqponmlkjihgfedcba",
    "mmmmmaaaaammmmmaaaaaabcdefgabcdefg",
    "mamamamamama",
    "jklmnopqrstuvwxyzyxwvutsrqponmlkj",
    "nmonqnmomnmomomno",
    "mmmaaaabcdefgmmmmaaaammmaamm",
    "mmmaaammmaaammmabcdefaaaammmmabcdefmmmaaaa",
    "aaaaaaaazzzzzzzz",
    "mmamammmmammamamaaamammma",
    "abcdefghijklmnopqrrqponmlkjihgfedcba"};

// Returns the current tick in a cycle of `count` ticks that starts at time 0. Exact as long as a double can
// resolve tenths of a second (over a million years).
std::size_t find_tick(double time_s, std::size_t count) {
  const double ticks = std::floor(std::max(0.0, time_s) * kTicksPerSecond);
  return static_cast<std::size_t>(std::fmod(ticks, static_cast<double>(count)));
}

std::uint16_t compute_letter_light(char letter) {
  return static_cast<std::uint16_t>(std::clamp(letter - 'a', 0, 'z' - 'a') * kLightPerLetter);
}

std::uint16_t compute_constant_light(std::string_view pattern, LightStyleMode mode) {
  if (mode == LightStyleMode::kHighest) return compute_letter_light(*std::ranges::max_element(pattern));
  std::size_t sum = 0;
  for (const char letter : pattern) sum += compute_letter_light(letter);
  return static_cast<std::uint16_t>(sum / pattern.size());
}

}  // namespace

TextureIndex find_animated_texture(const Level& level, TextureIndex texture, double time_s,
                                   int entity_frame) {
  const Texture& base = level.texture(texture);
  const bool alternate = entity_frame != 0 && !base.alternate_frames.empty();
  const std::vector<TextureIndex>& frames = alternate ? base.alternate_frames : base.frames;
  if (frames.empty()) return texture;
  return frames[find_tick(time_s, frames.size() * kTicksPerTextureFrame) / kTicksPerTextureFrame];
}

LightStylePatterns make_standard_light_styles() {
  LightStylePatterns patterns;
  for (std::size_t i = 0; i < kStandardPatterns.size(); ++i) patterns[i] = std::string(kStandardPatterns[i]);
  patterns[kTestStyle] = std::string(1, 'a');
  return patterns;
}

LightStyleValues compute_light_styles(const LightStylePatterns& patterns, double time_s,
                                      LightStyleMode mode) {
  LightStyleValues values;
  for (std::size_t i = 0; i < kLightStyles; ++i) {
    const std::string& pattern = patterns[i];
    values[i] = pattern.empty() ? kNormalLight
                : mode == LightStyleMode::kFlickering
                    ? compute_letter_light(pattern[find_tick(time_s, pattern.size())])
                    : compute_constant_light(pattern, mode);
  }
  return values;
}

}  // namespace temblor::world
