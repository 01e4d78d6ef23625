// The looks of procedural texels: how a pattern (pattern_kernels.h) grows on a face, and how it changes the
// colors of texels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lab/world_light/effects/pattern_kernels.h"
#include "render/color/color_tables.h"

namespace temblor::lab {

enum class PatternKind : std::uint8_t { kNoise, kWater, kFire };

// A layer of smooth noise. Nodes lie `1 << shift` texels of mip 0 apart.
struct Octave {
  int shift_s, shift_t;
  double weight;             // of all octaves together: 1
  double texels_per_second;  // downward; below 0: upward
};

struct PatternStyle {
  std::array<Octave, kPatternOctaves> octaves;
  // Added to the pattern at the lower edge of a wall, and for each unit above it.
  double bias_at_bottom, bias_per_unit;
  bool only_walls;
  bool moves;
};

const PatternStyle& find_style(PatternKind kind);

// How a pattern changes colors, in the form of the kernels.
struct PatternColors {
  std::array<std::uint32_t, 256> inks;
  std::vector<std::uint8_t> indices;
};

// An ink that changes nothing.
constexpr std::uint32_t kClearInk = 0xff000000u;

// Takes some milliseconds.
PatternColors make_pattern_colors(PatternKind kind, const render::ColorTables& tables);

}  // namespace temblor::lab
