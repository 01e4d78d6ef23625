// Stage 9, second part. Draws the translucent layers that are not drawn with the opaque picture
// (frame/banded_picture.h): models, and the faces and sprites in front of them.
#pragma once

#include "render/translucent/translucent_layers.h"

namespace temblor::render {

// Draws the layers from order.banded on. Models are fogged and then blended, each of their pixels once.
// Depth does not change.
void draw_translucent(const FrameContext& context, const TranslucentOrder& order, const WorldPicture& world,
                      FrameBuffer& io_frame);

}  // namespace temblor::render
