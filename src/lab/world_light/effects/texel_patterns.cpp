#include "lab/world_light/effects/texel_patterns.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab {

namespace {

// Grain of stone or plaster, from large stains to single texels.
constexpr PatternStyle kNoise{{{{6, 6, 0.4, 0}, {4, 4, 0.35, 0}, {1, 1, 0.25, 0}}}, 0, 0, false, false};
// Streaks that run down.
constexpr PatternStyle kWater{{{{3, 6, 0.45, 48}, {2, 4, 0.35, 80}, {5, 5, 0.2, 24}}}, 0, 0, true, true};
// Flames of two sizes that rise and end at a height of about 100 units.
constexpr PatternStyle kFire{
    {{{5, 5, 0.4, -48}, {4, 4, 0.35, -80}, {2, 3, 0.25, -112}}}, 70, -2.2, true, true};

// The color of a pattern, and how much of the texel shows through it.
struct PatternInk {
  double keep;                // 0 to 1
  std::array<double, 3> add;  // red, green, blue, 0 to 1
};

double ramp(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

// The brightness of a texel changes by a quarter, up or down.
PatternInk find_noise_ink(double value) {
  const double light = (value - 0.5) * 1.2;
  return light < 0 ? PatternInk{1 + light, {}} : PatternInk{1, {light * 0.16, light * 0.16, light * 0.16}};
}

// Wet walls are darker; streaks shine.
PatternInk find_water_ink(double value) {
  const double wet = ramp(value, 0.35, 0.5), shine = ramp(value, 0.55, 0.9);
  return {1 - 0.35 * wet, {shine * 0.3, shine * 0.38, shine * 0.45}};
}

// From smoke over red and yellow to white.
PatternInk find_fire_ink(double value) {
  const double flame = ramp(value, 0.3, 0.5);
  return {1 - flame,
          {flame * ramp(value, 0.25, 0.55), flame * ramp(value, 0.42, 0.85), ramp(value, 0.7, 1.1)}};
}

PatternInk find_ink(PatternKind kind, double value) {
  switch (kind) {
    case PatternKind::kWater:
      return find_water_ink(value);
    case PatternKind::kFire:
      return find_fire_ink(value);
    case PatternKind::kNoise:
      break;
  }
  return find_noise_ink(value);
}

std::uint32_t to_byte(double part) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
}

// 0xKKRRGGBB, as the kernels use it.
std::uint32_t pack_ink(const PatternInk& ink) {
  const auto kept_256ths = static_cast<std::uint32_t>(std::lround(ink.keep * 256));
  return (std::max(kept_256ths, 1u) - 1) << 24 | to_byte(ink.add[0]) << 16 | to_byte(ink.add[1]) << 8 |
         to_byte(ink.add[2]);
}

formats::Rgb change_color(formats::Rgb color, std::uint32_t ink) {
  const auto change = [&](std::uint8_t channel, int shift) {
    return static_cast<std::uint8_t>(
        std::min((channel * ((ink >> 24) + 1) >> 8) + (ink >> shift & 255), 255u));
  };
  return {change(color.r, 16), change(color.g, 8), change(color.b, 0)};
}

}  // namespace

const PatternStyle& find_style(PatternKind kind) {
  switch (kind) {
    case PatternKind::kWater:
      return kWater;
    case PatternKind::kFire:
      return kFire;
    case PatternKind::kNoise:
      break;
  }
  return kNoise;
}

PatternColors make_pattern_colors(PatternKind kind, const render::ColorTables& tables) {
  PatternColors colors{};
  for (std::size_t pattern = 0; pattern < 256; ++pattern)
    colors.inks[pattern] = pack_ink(find_ink(kind, static_cast<double>(pattern) / 255));
  // The kernel reads words.
  colors.indices.resize(std::size_t{kIndexedPatterns} * 256 + 3);
  for (std::size_t row = 0; row < kIndexedPatterns; ++row) {
    const std::size_t pattern = row * 256 / kIndexedPatterns + 128 / kIndexedPatterns;
    const std::uint32_t ink = colors.inks[pattern];
    for (std::size_t index = 0; index < 256; ++index)
      colors.indices[row * 256 + index] =
          ink == kClearInk
              ? static_cast<std::uint8_t>(index)
              : tables.match(change_color(tables.palette[index], ink), tables.match.is_fullbright(index));
  }
  return colors;
}

}  // namespace temblor::lab
