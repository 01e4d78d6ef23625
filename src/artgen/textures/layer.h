// A layer of a texture's script: a line under `texture`. There are two kinds of layers.
//
// A texel layer changes every texel:
//
//   noise by=0.2 lump=16
//
// A shape layer covers some texels. Its color follows the shape's own values; its settings and the layers
// indented under it apply only to the covered texels:
//
//   disc gold 0.7 at=32,32 radius=10 raise=2
//     noise by=0.1
//
// Every shape accepts
//
//   RAMP TONE                   the color; a ramp alone keeps the tones
//   shade=BY over=TEXELS        adds to the tone, rising from the edge over so many texels (1)
//   ragged=TEXELS               makes the edge random within so many texels
//   raise=TEXELS bevel=TEXELS   changes the height, rising from the edge over `bevel` texels
//   cut=yes                     makes a hole; a painted shape fills holes
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

// The input of a layer. Problems are recorded in `arguments`, and painting goes on with defaults.
struct Layer {
  Arguments& arguments;
  // Decides everything random in this layer; different for each line of a texture.
  std::uint64_t seed;
};

// A texel layer.
struct LayerKeyword {
  std::string_view keyword;
  void (*paint)(Layer& layer, Surface& io_surface);
};
// A shape layer: computes the texels that it covers.
struct ShapeKeyword {
  std::string_view keyword;
  Cover (*cover)(Layer& layer, const Surface& surface);
};

// All keywords, by the source file that implements them.
std::span<const LayerKeyword> material_keywords();   // materials.cpp
std::span<const LayerKeyword> structure_keywords();  // structures.cpp
std::span<const LayerKeyword> relief_keywords();     // relief.cpp
std::span<const ShapeKeyword> drawn_keywords();      // drawn_shapes.cpp
std::span<const ShapeKeyword> grown_keywords();      // grown_shapes.cpp

// Paints the lines of a script in their order. `seed` decides everything random.
base::Status paint_layers(std::span<const ScriptLine> lines, std::uint64_t seed, Surface& io_surface);

// A position or size in texels, x right and y down.
struct Point {
  double x = 0, y = 0;
};
// "X,Y"
Point read_point(Arguments& arguments, std::string_view name, Point fallback);
// "WxH", or one number for both. Both must be above 0.
Point read_extent(Arguments& arguments, std::string_view name, Point fallback);
// By its name in scripts: "gray", "brown", and so on.
std::optional<Ramp> find_ramp(std::string_view name);
Ramp read_ramp(Arguments& arguments, std::string_view name, Ramp fallback);
// Reads lump=WxH octaves=N. The lumps' size is rounded so that a whole number of them fits the texture.
NoiseLumps read_lumps(Arguments& arguments, const Surface& surface, Point default_lump,
                      std::int32_t default_octaves);
NoiseLumps make_lumps(const Surface& surface, Point lump, std::int32_t octaves);

// The whole number of times that `length` fits into `side`: rounded, at least 1.
std::int32_t count_repeats(double side, double length);
// `value` modulo `period`, from 0 up to the period, also for negative values.
double wrap(double value, double period);

}  // namespace temblor::artgen
