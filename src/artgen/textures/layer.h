// A layer of a texture's script: a line under `texture`. There are two kinds.
//
// A layer word changes every texel:  noise by=0.2 lump=16
// A shape word covers some of them, and what is painted there is said by the color behind it, by its
// settings and by the layers indented under it, which then are seen only there:
//   disc gold 0.7 at=32,32 radius=10 raise=2
//     noise by=0.1
//
// Every shape word knows
//   RAMP TONE    by place: the color, or of the ramp alone, which keeps the tones
//   shade=BY over=TEXELS        adds to the tone, less so within so many texels of the edge (1)
//   ragged=TEXELS               within so many texels of the edge, covers by chance only
//   raise=TEXELS bevel=TEXELS   stands out (or lies deeper), reaching that so far from its edge
//   cut=yes      makes holes; a painted shape fills them
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "artgen/scripts/noise.h"
#include "artgen/scripts/script.h"
#include "artgen/textures/surface.h"
#include "base/result.h"

namespace temblor::artgen {

// What a layer is made from. Arguments that are wrong keep their defaults until the line is finished.
struct Layer {
  Arguments& arguments;
  std::uint64_t seed;  // of its own, the same each time
};

struct LayerWord {
  std::string_view word;
  void (*paint)(Layer& layer, Surface& io_surface);
};
struct ShapeWord {
  std::string_view word;
  Cover (*cover)(Layer& layer, const Surface& surface);
};

// Which words there are, by the file that has them.
std::span<const LayerWord> material_words();   // materials.cpp
std::span<const LayerWord> structure_words();  // structures.cpp
std::span<const LayerWord> relief_words();     // relief.cpp
std::span<const ShapeWord> drawn_words();      // drawn_shapes.cpp
std::span<const ShapeWord> grown_words();      // grown_shapes.cpp

// Paints lines of a script, in their order. `seed` decides all that looks random.
base::Status paint_layers(std::span<const ScriptLine> lines, std::uint64_t seed, Surface& io_surface);

// For settings of layers.
struct Point {
  double x = 0, y = 0;
};
Point point(Arguments& arguments, std::string_view name, Point otherwise);   // "X,Y"
Point extent(Arguments& arguments, std::string_view name, Point otherwise);  // "WxH", or one number for both
std::optional<Ramp> ramp_named(std::string_view name);
Ramp ramp(Arguments& arguments, std::string_view name, Ramp otherwise);
// lump=WxH octaves=N: as many lumps as fit, so that they repeat.
NoiseLumps noise_lumps(Arguments& arguments, const Surface& surface, Point usual_lump,
                       std::int32_t usual_octaves);
NoiseLumps noise_lumps(const Surface& surface, Point lump, std::int32_t octaves);

// How often a length fits into a side, about, and at least once.
std::int32_t times_in(double side, double length);
// From 0 to the period.
double wrapped(double value, double period);

}  // namespace temblor::artgen
