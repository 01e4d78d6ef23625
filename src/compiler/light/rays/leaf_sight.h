// Finds out which lights can reach a face at all according to the level's PVS, which saves tracing their
// rays.
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

// Excludes nothing if the level has no PVS, or one that does not see through the surfaces of liquids or the
// brushes of switchable shadows, since light does. Otherwise an excluded light certainly does not reach the
// face: a PVS never hides anything visible.
class LeafSight {
 public:
  LeafSight(const LitLevel& lit, std::span<const LightSource> lights);

  // Returns the leaves that the face's sample points are in, and those that list the face. Empty: unknown.
  std::vector<world::LeafIndex> find_leaves(std::size_t face, const SamplePoints& places) const;
  // False: no ray from that light (or from the sky) reaches any of the leaves.
  bool light_may_reach(std::size_t light, std::span<const world::LeafIndex> leaves) const;
  bool sky_may_reach(std::span<const world::LeafIndex> leaves) const;

 private:
  using Row = std::vector<std::uint8_t>;  // a bit for each leaf, as from world::decompress_pvs

  bool known_ = false;
  std::vector<std::vector<world::LeafIndex>> leaves_showing_;  // by face
  std::vector<Row> rows_;
  std::vector<std::uint32_t> row_of_light_;
  Row from_sky_;
};

}  // namespace temblor::compiler
