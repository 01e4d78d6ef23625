// Spans that are drawn from a repeating texture instead of a surface block: liquids, and faces without light.
//
// Liquids are warped as in stock Quake: s is displaced by a sine of t, and t by a sine of s.
#pragma once

#include "base/arena.h"
#include "render/frame_buffer.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// For every draw of kind kLiquid or kTexture: everything that its kernel needs except the spans. By draw
// number, null for other draws. Lives in the frame's arena.
std::span<const RepeatSpans*> prepare_repeat_spans(const FrameContext& context, const ViewFrame& view,
                                                   const SurfaceDraws& draws);

}  // namespace temblor::render
