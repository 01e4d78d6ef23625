// Stage 7, first part: alias models, against the depth that the world left.
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/colour/colour_tables.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Instances that may be on the screen, and all their triangles.
struct AliasCounts {
  std::uint32_t models = 0, triangles = 0;
};

// Draws Scene::alias_models in their order, then the view weapon, in bands of `band_rows` scan lines. Those
// whose alpha is below 1 are left out (draw_translucent_alias.h). Depth must have been filled. Results live
// in the arenas no longer than the call.
AliasCounts draw_alias_models(const Scene& scene, const Settings& settings, const ViewFrame& view,
                              int band_rows, const ColourTables& tables, base::Jobs& jobs, base::Arena& arena,
                              std::vector<base::Arena>& io_job_arenas, FrameBuffer& io_frame);

}  // namespace temblor::render
