// Stage 7, first part: alias models, tested against the depth that the world's spans have written.
//
// Stock Quake z-buffers its models too (Abrash, "Quake's 3-D Engine: The Big Picture"); here they are also
// drawn in bands, by all threads.
#pragma once

#include <span>

#include "render/alias/prepare_alias.h"

namespace temblor::render {

// The instances of Scene::alias_models that may be visible, in their order, then the view model. Instances
// with alpha below 1 are left to draw_translucent_alias.h. Results live in the arenas.
std::span<const PreparedAlias> prepare_alias_models(const FrameContext& context, const ViewFrame& view);

// The same in two steps: element i of the second result belongs to element i of the first.
std::span<const AliasPlacement> place_alias_models(const Scene& scene, const ViewFrame& view,
                                                   base::Arena& arena);
std::span<PreparedAlias> prepare_placed_models(const FrameContext& context, const ViewFrame& view,
                                               std::span<const AliasPlacement> placements);

// Draws the part of the models in `rows`, whose depth must have been written. A pixel gets the same triangles
// in the same order however the picture is divided into bands.
void draw_alias_models(std::span<const PreparedAlias> models, bool simd_kernels, RowRange rows,
                       FrameBuffer& io_frame);

}  // namespace temblor::render
