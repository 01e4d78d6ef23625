// What a model's skin is painted with: ramps of the palette, lightened, darkened and soiled by noise, by
// where the surface looks and by how deep it lies in creases.
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

// A second color over parts of a paint.
struct PaintLayer {
  Ramp ramp = Ramp::kGray;
  double low = 0, high = 1;
  double amount = 0.3;        // 0 to 1: how much of the surface
  double grain = 4;           // units: of spots
  double every = 0;           // units from stripe to stripe; 0: spots
  math::Vec3d axis{0, 0, 1};  // that stripes lie across
  double waver = 0;           // units that stripes stray
};

struct Paint {
  std::string name;
  Ramp ramp = Ramp::kGray;
  double low = 0, high = 1;  // brightness of its darkest and brightest parts
  double noise = 0.3;        // 0 to 1
  double grain = 4;          // units: of the noise
  double wear = 0;           // 0 to 1: crisp edges are bare and bright
  double shade = 1;          // 0 to 1: of creases and of what looks down
  std::vector<PaintLayer> layers;
};

// A part of a shape that has another paint.
struct Patch {
  std::size_t paint = 0;
  double along_low = 0, along_high = 1;
  double around_low_deg = -180, around_high_deg = 180;
};

struct ShapeLook {
  std::size_t paint = 0;
  std::vector<Patch> patches;  // later ones over earlier ones
};

// What every texel of a skin shows: found once, painted for each skin.
struct SkinTexel {
  bool used = false;
  std::uint32_t shape = 0;
  math::Vec3d place{0.0}, normal{0, 0, 1};  // at rest
  double along = 0, around_deg = 0;
  double hidden = 0;        // 0 to 1
  double edge_units = 1e9;  // to the nearest crisp edge that stands out
};

std::vector<SkinTexel> find_skin_texels(const Mesh& mesh, const Atlas& atlas);

// Palette indices, row by row; never the transparent one.
std::vector<std::uint8_t> paint_skin(const std::vector<SkinTexel>& texels, std::int32_t width,
                                     const std::vector<ShapeLook>& shapes, const std::vector<Paint>& paints);

}  // namespace temblor::artgen
