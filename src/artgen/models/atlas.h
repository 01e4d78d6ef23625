// Places the charts of a mesh on a skin. All charts have the same density in texels per unit, with an unused
// texel around each, so that texels do not bleed into other charts.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/models/mesh.h"
#include "math/vec.h"

namespace temblor::artgen {

// The transform from a chart to the skin.
struct ChartPlacement {
  // texels = units * density + shift
  math::Vec2d shift{0.0};
  // The chart's axes are exchanged, so that its longer side is horizontal.
  bool swapped = false;
};

// The layout of a skin.
struct Atlas {
  // In texels; the width is a power of two.
  std::int32_t width = 0, height = 0;
  // Texels per unit.
  double density = 1;
  std::vector<ChartPlacement> charts;

  // The texel for a position on a chart, rounded.
  math::Vec2d texel(std::uint32_t chart, const math::Vec2d& position) const;
};

// Uses the requested density unless the skin would exceed the largest allowed size; then it is reduced until
// all charts fit.
Atlas lay_out_charts(const Mesh& mesh, double density);

}  // namespace temblor::artgen
