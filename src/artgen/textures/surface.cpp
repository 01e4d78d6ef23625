#include "artgen/textures/surface.h"

namespace temblor::artgen {

bool is_fullbright(Ramp ramp) {
  return ramp == Ramp::kFire || ramp == Ramp::kElectric;
}

std::vector<std::uint8_t> to_palette_indices(const Surface& surface) {
  std::vector<std::uint8_t> indices;
  indices.reserve(surface.cells.size());
  for (const Texel& texel : surface.cells)
    indices.push_back(texel.hole ? kTransparent : ramp_color(texel.ramp, texel.tone));
  return indices;
}

}  // namespace temblor::artgen
