// Where a mesh's charts lie on the skin.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/models/mesh.h"
#include "math/vec.h"

namespace temblor::artgen {

struct AtlasPlace {
  math::Vec2d shift{0.0};  // texels = units * density + shift
  bool swapped = false;    // a chart that lies on its side
};

struct Atlas {
  std::int32_t width = 0, height = 0;  // texels; the width a power of two
  double density = 1;                  // texels a unit
  std::vector<AtlasPlace> charts;

  // The texel whose middle a corner lies on.
  math::Vec2d texel(std::uint32_t chart, const math::Vec2d& place) const;
};

// Every chart with a texel free around it, as densely as asked for unless that takes more than a skin may
// have.
Atlas lay_out_charts(const Mesh& mesh, double density);

}  // namespace temblor::artgen
