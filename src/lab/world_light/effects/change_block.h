// Changes the texels of a surface block by a pattern.
#pragma once

#include "base/arena.h"
#include "lab/world_light/effects/texel_patterns.h"
#include "render/surfaces/surface_draws.h"
#include "render/view/frame_context.h"

namespace temblor::lab {

// A pattern at one time.
struct TexelPattern {
  const PatternStyle& style;
  const PatternColors& colors;
  double time_s;
};

// The block of `request` must have its texels. Faces without the pattern stay as they are: floors under one
// that only covers walls. Uses `scratch`, which is reset.
void change_block(const render::FrameContext& context, const TexelPattern& pattern,
                  const render::BlockRequest& request, base::Arena& scratch);

}  // namespace temblor::lab
