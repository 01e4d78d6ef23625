// Records of a level that nothing refers to. Compilers and editors leave damaged ones behind.
#pragma once

#include <cstddef>

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// Replaces a plane, vertex, texinfo, edge, or surfedge by a valid one if no other record refers to it.
// Returns false without a change if one does, or for other lumps. `record` must exist.
bool reset_if_unused(Bsp& io_bsp, BspLump lump, std::size_t record);

}  // namespace temblor::formats::bsp_file
