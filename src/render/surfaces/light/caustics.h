// Caustics: the net of light that waves throw on what lies under water, moving slowly (r_caustics). It
// multiplies the light of a face, so shadows stay dark.
//
// The net is a tile of cells with bright borders, computed once (cellular texture: Steven Worley, "A Cellular
// Texture Basis Function", SIGGRAPH 1996). Two layers of it drift apart, and the darker of the two shows:
// lines break up and join without ever repeating. The tile lies in world space, along slanted rays of light,
// so it continues from face to face.
//
// Blocks under water are built again for each step of the net. Faces take their steps at different times, so
// that this work is spread over the frames.
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "render/surfaces/light/light_samples.h"
#include "world/level.h"

namespace temblor::render {

// The faces of the world that lie under water: those that its leaves of water see.
class WaterFaces {
 public:
  WaterFaces() = default;
  explicit WaterFaces(const world::Level& level);
  bool contains(world::FaceIndex face) const {
    return base::to_size(face) < is_under_water_.size() && is_under_water_[base::to_size(face)];
  }

 private:
  std::vector<bool> is_under_water_;  // by face; empty: no level
};

// The step of the net on a face at a time: at least 1.
std::uint32_t find_caustic_step(world::FaceIndex face, double time_s);

// The samples on which the net shows: closer together than those of `grid`, which must be a tile's at `mip`.
SampleGrid refine_for_caustics(const SampleGrid& grid, int mip);

// Interpolates `light` on `grid` to the samples of `refined`, and multiplies it by the net. Ceilings only get
// the interpolated light. The result lives in `arena`.
LightSums add_caustics(const world::Level& level, const world::Face& face, std::uint32_t step,
                       const LightSums& light, const SampleGrid& grid, const SampleGrid& refined,
                       base::Arena& arena);

}  // namespace temblor::render
