#include "artgen/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace temblor::artgen {
namespace {

// The colors at the two ends and in the middle of a ramp. The middle one keeps the dark half from becoming
// gray, which a straight line from black would.
struct RampColors {
  formats::Rgb dark, middle, bright;
};

// In the order of Ramp.
constexpr std::array<RampColors, 16> kRamps = {{
    {{0, 0, 0}, {112, 112, 112}, {236, 236, 236}},
    {{10, 7, 4}, {98, 70, 43}, {196, 158, 116}},
    {{14, 6, 4}, {122, 58, 40}, {214, 140, 108}},
    {{14, 11, 7}, {138, 112, 74}, {232, 210, 164}},
    {{14, 1, 1}, {144, 18, 16}, {252, 92, 76}},
    {{8, 9, 3}, {82, 86, 38}, {172, 178, 104}},
    {{14, 10, 0}, {154, 116, 22}, {252, 228, 112}},
    {{2, 10, 10}, {30, 104, 104}, {124, 208, 200}},
    {{3, 5, 16}, {36, 66, 142}, {130, 172, 240}},
    {{9, 4, 13}, {88, 52, 118}, {188, 148, 220}},
    {{6, 8, 12}, {74, 86, 106}, {168, 184, 206}},
    {{12, 6, 2}, {118, 72, 38}, {208, 152, 100}},
    {{14, 8, 6}, {150, 100, 78}, {246, 204, 178}},
    {{3, 10, 4}, {44, 106, 48}, {140, 206, 122}},
    {{80, 8, 0}, {255, 128, 8}, {255, 255, 216}},
    {{8, 16, 96}, {32, 144, 255}, {224, 255, 255}},
}};

std::uint8_t mix(std::uint8_t from, std::uint8_t to, double fraction) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * fraction));
}

formats::Rgb mix(const formats::Rgb& from, const formats::Rgb& to, double fraction) {
  return {mix(from.r, to.r, fraction), mix(from.g, to.g, fraction), mix(from.b, to.b, fraction)};
}

}  // namespace

std::uint8_t ramp_color(Ramp ramp, double brightness) {
  const double steps = static_cast<double>(kRampColors - 1);
  const auto step = static_cast<std::size_t>(std::lround(std::clamp(brightness, 0.0, 1.0) * steps));
  const std::size_t index = static_cast<std::size_t>(ramp) * kRampColors + step;
  return static_cast<std::uint8_t>(std::min<std::size_t>(index, kTransparent - 1));
}

formats::Palette make_palette() {
  formats::Palette palette;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const RampColors& ramp = kRamps[i / kRampColors];
    const double along = 2.0 * static_cast<double>(i % kRampColors) / static_cast<double>(kRampColors - 1);
    palette[i] = along < 1 ? mix(ramp.dark, ramp.middle, along) : mix(ramp.middle, ramp.bright, along - 1);
  }
  // Purple, so that a texel that is drawn by mistake is conspicuous.
  palette[kTransparent] = {160, 40, 120};
  return palette;
}

}  // namespace temblor::artgen
