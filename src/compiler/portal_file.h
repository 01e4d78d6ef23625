// Portals as a .prt file, through which the bsp and vis programs of other tools hand them on.
#pragma once

#include "base/result.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"
#include "formats/levels/prt.h"

namespace temblor::compiler {

// Returns the file of a level's portals. `visible_leaves`: of its world (formats::BspModel); those without a
// cluster get one of their own, without portals.
formats::PortalFile make_portal_file(const PortalSet& portals, std::size_t visible_leaves);

// Returns the portals of a file for its level. `bsp` passed validation. A portal that the tree shows to lie
// the other way round is turned; one without an area is left out. Fails if the number of leaves differs, or
// if most portals do not lie between their leaves: then the file belongs to another level.
base::Result<PortalSet> match_portal_file(const formats::PortalFile& file, const formats::Bsp& bsp);

}  // namespace temblor::compiler
