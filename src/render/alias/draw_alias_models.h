// Stage 7, first part: alias models, against the depth that the world left.
#pragma once

#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/alias/prepare_alias.h"
#include "render/color/color_tables.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Those of Scene::alias_models that may be on the screen, in their order, then the view weapon. Those whose
// alpha is below 1 are left out (draw_translucent_alias.h). Results live in the arenas.
std::span<const PreparedAlias> prepare_alias_models(const Scene& scene, const Settings& settings,
                                                    const ViewFrame& view, const ColorTables& tables,
                                                    PixelFormat format, base::Jobs& jobs, base::Arena& arena,
                                                    std::vector<base::Arena>& io_job_arenas);

// Draws their part of `rows`, whose depth must have been filled. A pixel sees the same triangles in the same
// order however a picture is cut into rows.
void draw_alias_models(std::span<const PreparedAlias> models, bool vector_kernels, RowRange rows,
                       FrameBuffer& io_frame);

}  // namespace temblor::render
