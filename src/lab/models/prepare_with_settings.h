// The frame's context with other settings, for techniques that let the engine prepare models in another way.
#pragma once

#include "render/view/frame_context.h"

namespace temblor::lab {

// Both must live as long as the result.
inline render::FrameContext with_settings(const render::FrameContext& context,
                                          const render::Settings& settings) {
  return {context.scene, settings, context.format, context.colors, context.jobs, context.arenas};
}

}  // namespace temblor::lab
