// Stage 9. Everything that is translucent, from back to front: late faces, and models and sprites among
// them.
#pragma once

#include "render/renderer.h"
#include "render/translucent/late_faces.h"

namespace temblor::render {

// A model or sprite takes the place of the leaf that its origin lies in, as brush models do. Models are
// fogged, then blended, each pixel once; sprites are not fogged. Depth stays as it is.
void draw_translucent(const Scene& scene, const Settings& settings, const VisibleFaces& visible,
                      std::span<const LateFace> faces, const LateTarget& target, base::Jobs& jobs,
                      base::Arena& arena, std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame);

}  // namespace temblor::render
