// The sources that spans are drawn from in a frame, prepared for the kernels: used by draw_spans.h and for
// deferred faces.
#pragma once

#include <optional>
#include <span>

#include "base/arena.h"
#include "render/frame_buffer.h"
#include "render/spans/skybox.h"
#include "render/spans/skybox_kernels.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// Refers to the frame's arena and to the prepared skybox.
struct SpanSources {
  SurfaceDraws draws;
  // By draw number; null for draws of other kinds.
  std::span<const SkySpans*> skies;  // empty if there is a skybox
  std::span<const RepeatSpans*> repeating;
  std::optional<SkyboxSpans> skybox;  // without depth and spans
  std::uint64_t skybox_version = 0;   // PreparedSkybox::version
  PixelFormat format;
  KernelDivide divide;
  int affine_pixels = kAffinePixels;
  bool simd_kernels;
  bool fill_depth;  // false: nothing in this frame needs depth (Settings::fill_depth)
};

// `io_skybox` is updated to the scene's skybox.
SpanSources prepare_span_sources(const FrameContext& context, const ViewFrame& view,
                                 const SurfaceDraws& draws, PreparedSkybox& io_skybox);

// Writes pixels and depth of some spans of draw number `draw`, without a depth test. Writes nothing for
// kHidden and kNothing.
void draw_spans(const SpanSources& sources, std::uint32_t draw, std::span<const Span> spans,
                const KernelTarget& target);

}  // namespace temblor::render
