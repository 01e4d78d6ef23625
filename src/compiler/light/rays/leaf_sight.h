// Which lights can reach a face at all, after the level's PVS: saves the rays that would find out one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/light/faces/sample_points.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/sources/light_source.h"
#include "world/level.h"

namespace temblor::compiler {

// Says yes to everything where the level has no PVS, or one that does not see through the surface of liquids,
// which light passes. Otherwise a no is certain, as a PVS never hides what can be seen.
class Leavesight {
 public:
  Leavesight(const LitLevel& lit, std::span<const LightSource> lights);

  // The leaves that a face's samples lie in, and those that show it. Empty: unknown.
  std::vector<world::LeafIndex> leaves_of(std::size_t face, const SamplePlaces& places) const;
  bool light_may_reach(std::size_t light, std::span<const world::LeafIndex> leaves) const;
  bool sky_may_reach(std::span<const world::LeafIndex> leaves) const;

 private:
  using Row = std::vector<std::uint8_t>;  // one bit a leaf, as world::decompress_pvs has it

  bool known_ = false;
  std::vector<std::vector<world::LeafIndex>> leaves_showing_;  // by face
  std::vector<Row> rows_;
  std::vector<std::uint32_t> row_of_light_;
  Row from_sky_;
};

}  // namespace temblor::compiler
