// Visibility as a level stores it: for each leaf a row of bits, one for each leaf that it sees, and the
// levels of the ambient sounds that are heard in it.
#pragma once

#include "base/result.h"
#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// Which ambient sounds leaves get.
struct AmbientSounds {
  bool water = true;
  bool sky = true;
  bool lava = true;
};

// Sets the visibility, the number of visible leaves, and each leaf's visibility_offset and ambient sound
// levels. `visible` has a row and a column for each cluster of `portals`; `portals` assigns a cluster to each
// leaf of the world that is not solid (both CHECKed against io_bsp's number of leaves). Leaves without a
// cluster get the offset -1.
//
// A row is run-length coded: bit i stands for leaf i + 1, and a zero byte is followed by the number of zero
// bytes that it stands for. Leaves with equal rows share one.
//
//   leaves 3, 40 and 41 of 80  ->  04 00 03 80 01 00 04
//
// A leaf's ambient level is 255 if it sees a leaf with a face of the right texture, else 0. Textures
// "*...water..." and "*...slime..." sound as water, "sky..." as sky, "*...lava..." as lava. This is what
// finished levels contain: teleporters and blood are silent, and the level for slime stays 0.
//
// Fails with kTooLarge if the rows take more bytes than offsets can address; io_bsp is then unchanged.
base::Status write_visibility(const PortalSet& portals, const BitMatrix& visible, const AmbientSounds& sounds,
                              formats::Bsp& io_bsp);

// The mean share of all leaves that a leaf sees, 0 to 1. Every leaf with a cluster counts the same.
double mean_visible_share(const PortalSet& portals, const BitMatrix& visible);

}  // namespace temblor::compiler
