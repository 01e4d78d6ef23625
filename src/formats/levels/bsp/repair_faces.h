// Repair of faces and of the records that describe them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// The vertex at which a surfedge starts. Its edge must be in range.
std::uint32_t find_start(const Bsp& bsp, std::size_t surfedge);

// Replaces faces by ones without area, which show nothing and have no light. A face keeps its number. Each
// has an outline of its own, because no two faces may share surfedges. Requires a plane and a vertex.
void clear_faces(Bsp& io_bsp, const std::vector<bool>& is_cleared);

// Repairs vertices, texinfos, edges, surfedges, and faces, as repair_level() describes it (repair.h).
// Requires a plane and a vertex. Returns the number of changed records.
std::size_t repair_faces(Bsp& io_bsp);

}  // namespace temblor::formats::bsp_file
