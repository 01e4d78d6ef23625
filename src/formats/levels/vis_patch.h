// Visibility patches (.vis): visibility for levels that were compiled before water could be transparent.
// Their own visibility ends at every water surface. One file may have patches for several levels.
//
//   for each level   0  name of the level, 32 bytes up to the first zero: "e1m1.bsp"
//                   32  size i32 of the rest
//                   36  size i32, and the visibility lump
//                    .  size i32, and the leaves as in version 29, 28 bytes each
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats {

struct VisPatch {
  std::string level;  // as stored
  std::vector<std::uint8_t> visibility;
  // BspLeaf::visibility_offset of each leaf. A patch stores whole leaves, but only these may differ from the
  // level's.
  std::vector<std::int32_t> leaf_offsets;
  bool operator==(const VisPatch&) const = default;
};

// Reads the patches up to the first damaged one. Returns an error, which names its offset, if there are none
// before it.
base::Result<std::vector<VisPatch>> read_vis_patches(base::Bytes bytes);

// Gives the level the patch's visibility. Returns an error and leaves the level alone if the patch was made
// for another version of it: the number of leaves differs, or an offset is outside of the visibility.
base::Status apply_vis_patch(const VisPatch& patch, Bsp& io_bsp);

}  // namespace temblor::formats
