// Stage 9. What of the translucent is not drawn with the opaque (banded_picture.h): models and sprites, and
// the faces before them.
#pragma once

#include "render/renderer.h"
#include "render/translucent/translucent_layers.h"

namespace temblor::render {

// `layers` in their order, whose faces are numbers in `faces`. Models are fogged, then blended, each pixel
// once; sprites are not fogged. Depth stays as it is.
void draw_translucent(const Scene& scene, const Settings& settings, std::span<const TranslucentLayer> layers,
                      std::span<const DeferredFace> faces, const LateTarget& target, base::Jobs& jobs,
                      base::Arena& arena, std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame);

}  // namespace temblor::render
