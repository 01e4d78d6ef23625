// Visibility as a level stores it: a row of leaves for each leaf, and the sounds of what it sees.
#pragma once

#include "base/result.h"
#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// Which of the sounds that go on around a listener are set.
struct AmbientSounds {
  bool water = true;
  bool sky = true;
  bool lava = true;
};

// Sets the visibility, the number of visible leaves, and each leaf's visibility_offset and ambient levels.
// `visible` has a row and a column for each cluster of `portals`, and `portals` a cluster for each leaf of
// the world but the solid ones (both CHECKed against io_bsp's number of leaves). Leaves without a cluster get
// offset -1.
//
// Bit i of a row stands for leaf i + 1; a zero byte is followed by how many it stands for. Leaves whose rows
// are equal share one.
//
// A leaf's ambient level is 255 where it sees a leaf with a face of that texture, else 0: "*...water..." and
// "*...slime..." sound as water, "sky..." as sky, "*...lava..." as lava; so it is in finished levels, where
// teleporters and blood are silent and the level for slime stays 0.
//
// kTooLarge when the rows are more than a level can point into; io_bsp is then as it was.
base::Status write_visibility(const PortalSet& portals, const BitMatrix& visible, const AmbientSounds& sounds,
                              formats::Bsp& io_bsp);

// The mean share of leaves that leaves see, 0 to 1, weighing every leaf with a cluster alike.
double mean_visible_share(const PortalSet& portals, const BitMatrix& visible);

}  // namespace temblor::compiler
