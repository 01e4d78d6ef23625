// Portals instead of the precomputed PVS: each frame floods from the eye's leaf through the openings between
// leaves (portal_flood.h). The faces of the leaves that it reaches are drawn by the engine's own stages.
//
// Every pixel is the engine's, except where the engine shows a face through solid space: through fences,
// whose inside is solid, and in corners of a level that players cannot reach, where compilers remove the
// faces of walls.
//
// Parameters: `octagon` 1 clips windows to octagons instead of rectangles; `pvs` 1 enters leaves of the PVS
// only; `portals` is the largest number of portals that a level may have.
//
// The eye of a parallel projection is no point, and an eye in solid space sees through no portal. For these
// the leaves are the engine's.
#pragma once

#include "base/result.h"
#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_portal_stages(std::span<const double> values, Counter* counter);

// Fails if the level has too many portals. (The stages draw it like the engine then.)
base::Status check_portals(std::span<const double> values, const world::Level& level);

}  // namespace temblor::lab
