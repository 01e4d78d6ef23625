// What the items of a frame are drawn from, ready for the kernels: for draw_spans, and for late faces.
#pragma once

#include <optional>
#include <span>

#include "base/arena.h"
#include "render/frame.h"
#include "render/spans/skybox.h"
#include "render/spans/skybox_kernels.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

struct SpanSources {
  SurfaceDraws items;
  // By item number; null for items of other kinds.
  std::span<const SkyRuns*> skies;  // without a skybox
  std::span<const RepeatRuns*> repeating;
  std::optional<SkyboxRuns> skybox;  // all but depth and runs
  PixelFormat format;
  KernelDivide divide;
  bool vector_kernels;
};

SpanSources prepare_span_sources(const Scene& scene, const Settings& settings, const ViewFrame& view,
                                 const SurfaceDraws& items, const ColorTables& tables, PixelFormat format,
                                 PreparedSkybox& io_skybox, base::Arena& arena);

// Pixels and depth of some of an item's runs; untested. Draws nothing for items that show nothing.
void draw_runs(const SpanSources& sources, std::uint32_t item, std::span<const SpanRun> runs,
               const KernelTarget& target);

}  // namespace temblor::render
