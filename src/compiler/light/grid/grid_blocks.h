// The samples of a light grid while it is computed: cubes of kBlockSide samples along each axis, each of
// which one thread lights.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "formats/levels/light_grid.h"
#include "math/vec.h"

namespace temblor::compiler {

constexpr std::int32_t kBlockSide = 4;

// Samples beyond the grid's size count as occluded.
struct GridBlock {
  static constexpr std::size_t kSamples = kBlockSide * kBlockSide * kBlockSide;
  std::vector<formats::GridSample> samples;  // x first; empty: all are occluded
  std::vector<formats::GridLight> lights;
};

struct GridBlocks {
  math::Vec3 mins{0.0f}, step{32.0f};
  std::array<std::int32_t, 3> size{};    // in samples
  std::array<std::int32_t, 3> blocks{};  // in blocks
  std::vector<GridBlock> of_place;       // x first

  const GridBlock& block_at(const std::array<std::int32_t, 3>& sample) const {
    return of_place[static_cast<std::size_t>(
        sample[0] / kBlockSide +
        blocks[0] * (sample[1] / kBlockSide + blocks[1] * (sample[2] / kBlockSide)))];
  }
  static std::size_t number_in_block(const std::array<std::int32_t, 3>& sample) {
    return static_cast<std::size_t>(sample[0] % kBlockSide +
                                    kBlockSide *
                                        (sample[1] % kBlockSide + kBlockSide * (sample[2] % kBlockSide)));
  }
};

// Packs the samples into an octree: boxes without any light are left out, and boxes without a wall, or of
// kBlockSide samples at most along each axis, become leaves.
formats::LightGrid make_octree(const GridBlocks& grid);

}  // namespace temblor::compiler
