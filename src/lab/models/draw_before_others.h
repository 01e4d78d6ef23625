// Stages of techniques that draw some models of a frame themselves, and leave the others to the engine.
//
// `State` has:
//   prepare(context, view)                  the models for the engine
//   draw(simd_kernels, rows, io_frame)      draws the models that it kept; several bands may run at once
//   used_bytes()                            memory of this frame; may be left out
#pragma once

#include <memory>

#include "lab/technique.h"
#include "render/alias/draw_alias_models.h"

namespace temblor::lab {

template <class State>
render::FrameStages draw_before_others(std::shared_ptr<State> state, Counter* counter) {
  render::FrameStages stages;
  stages.prepare_alias_models = [=](const render::FrameContext& context, const render::ViewFrame& view) {
    const auto others = state->prepare(context, view);
    if constexpr (requires { state->used_bytes(); })
      if (counter != nullptr) counter->add({.bytes = state->used_bytes()});
    return others;
  };
  stages.draw_alias_models = [=](std::span<const render::PreparedAlias> models, bool simd_kernels,
                                 render::RowRange rows, render::FrameBuffer& io_frame) {
    state->draw(simd_kernels, rows, io_frame);
    render::draw_alias_models(models, simd_kernels, rows, io_frame);
  };
  return stages;
}

}  // namespace temblor::lab
