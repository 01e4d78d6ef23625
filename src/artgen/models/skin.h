// Paints the skins of a model. Each texel knows its position, normal, and surroundings on the model at rest;
// a paint combines a palette ramp with noise in space, patterns, light from above, worn edges, and ambient
// occlusion.
//
//   Mesh + Atlas -> find_skin_texels, once -> SkinTexels -> paint_skin, for each skin -> palette indices
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "artgen/models/atlas.h"
#include "artgen/models/mesh.h"
#include "artgen/palette.h"

namespace temblor::artgen {

// A pattern of spots or stripes in another color on a paint.
struct PaintLayer {
  Ramp ramp = Ramp::kGray;
  // The brightness on the ramp of its darkest and brightest parts.
  double low = 0, high = 1;
  // The fraction of the surface that it covers, 0 to 1.
  double amount = 0.3;
  // The size of spots in units.
  double grain = 4;
  // The distance between stripes in units; 0: spots.
  double every = 0;
  // Stripes are perpendicular to this direction.
  math::Vec3d axis{0, 0, 1};
  // How far stripes deviate from planes, in units.
  double waver = 0;
};

// A material of a model.
struct Paint {
  std::string name;
  Ramp ramp = Ramp::kGray;
  // The brightness on the ramp of its darkest and brightest parts.
  double low = 0, high = 1;
  // The strength of the noise, 0 to 1.
  double noise = 0.3;
  // The size of the noise in units.
  double grain = 4;
  // How bright sharp edges are worn, 0 to 1.
  double wear = 0;
  // How much creases and undersides are darkened, 0 to 1.
  double shade = 1;
  std::vector<PaintLayer> layers;
};

// A part of a shape with another paint. Ranges as in MeshCorner.
struct Patch {
  std::size_t paint = 0;
  double along_low = 0, along_high = 1;
  double around_low_deg = -180, around_high_deg = 180;
};

// The paints of a shape.
struct ShapeLook {
  std::size_t paint = 0;
  // Later ones cover earlier ones.
  std::vector<Patch> patches;
};

// The point of the model that a texel of the skin shows; the same for all skins of a model.
struct SkinTexel {
  // Whether any triangle covers it.
  bool used = false;
  std::uint32_t shape = 0;
  // At rest.
  math::Vec3d position{0.0}, normal{0, 0, 1};
  // The position on its shape, as in MeshCorner.
  double along = 0, around_deg = 0;
  // Ambient occlusion, 0 to 1.
  double hidden = 0;
  // The distance to the nearest sharp convex edge.
  double edge_units = 1e9;
};

// Row by row. Mirror images share the texels of their original.
std::vector<SkinTexel> find_skin_texels(const Mesh& mesh, const Atlas& atlas);

// Palette indices, row by row; never the transparent one. Unused texels are 0.
std::vector<std::uint8_t> paint_skin(const std::vector<SkinTexel>& texels, std::int32_t width,
                                     const std::vector<ShapeLook>& shapes, const std::vector<Paint>& paints);

}  // namespace temblor::artgen
