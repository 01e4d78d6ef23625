// Colour laid over the finished view.
#pragma once

#include "base/parallel_for.h"
#include "render/colour/colour_tables.h"
#include "render/frame.h"
#include "render/scene.h"

namespace temblor::render {

// rgb: blend_rgb. Indexed: every entry becomes the one nearest to its blend; full-bright ones may stay so.
// An opacity that is not positive changes nothing.
void tint_picture(const Tint& tint, const ColourTables& tables, bool vector_kernels, base::Jobs& jobs,
                  FrameBuffer& io_frame);

}  // namespace temblor::render
