// The light grid of a level (formats/levels/light_grid.h), by which engines light models.
#pragma once

#include <optional>

#include "base/function_ref.h"
#include "base/parallel_for.h"
#include "compiler/light/grid/grid_blocks.h"
#include "compiler/light/grid/space_light.h"
#include "formats/levels/light_grid.h"

namespace temblor::compiler {

// More samples than this make no grid.
constexpr std::size_t kMaxGridSamples = 1 << 24;

// Lays a grid over the world, `step` units apart. Its first samples are a quarter of a step inside of the
// world's box, so that they are close over floors but not in them. Returns nothing if there would be more
// than kMaxGridSamples.
std::optional<GridBlocks> lay_grid(const world::Level& level, const math::Vec3& step);

// Lights all blocks. Calls `make_step` once for each, from any thread. Returns false if it ever returned
// false; then some blocks may be missing. The light does not depend on the number of threads.
bool light_grid_blocks(const SpaceLightInput& input, base::Jobs& io_jobs, base::FunctionRef<bool()> make_step,
                       GridBlocks& io_grid);

}  // namespace temblor::compiler
