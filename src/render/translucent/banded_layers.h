// Stage 9: translucent faces and sprites, band by band. Models are not drawn this way, because each pixel of
// a model is blended once, however many of its triangles cover it.
#pragma once

#include "render/translucent/translucent_layers.h"

namespace temblor::render {

// Draws the part of the layers in one band, in their order. None of them may be a model. `layers` are
// consecutive ones of order.layers. Sprites are fogged, then blended, and do not write depth.
void draw_banded_layers(std::span<const TranslucentLayer> layers, const TranslucentOrder& order,
                        const WorldPicture& world, const Band& band, base::Arena& arena,
                        FrameBuffer& io_frame);

}  // namespace temblor::render
