// Records of a level that no game reaches. Compilers and editors leave damaged ones behind.
#pragma once

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// Replaces every record that no model leads to by a valid one:
//
//   models --> nodes --> leaves --> marksurfaces --> faces --> surfedges --> edges --> vertices
//        \--> clipnodes                                   \--> planes, texinfo
//
// A reachable node or clipnode also leads to its plane; a model other than the world, and a node, to its
// faces. Appends a few records that the replacements refer to. Follows only indices that are in range, in
// time proportional to the level, so the level need not be valid.
void reset_unused(Bsp& io_bsp);

}  // namespace temblor::formats::bsp_file
