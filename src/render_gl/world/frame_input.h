// The results of the CPU's stages that a frame is drawn from.
#pragma once

#include "render/frame/render_frame.h"
#include "render/spans/span_sources.h"
#include "render/translucent/translucent_layers.h"
#include "render_gl/draw_options.h"
#include "render_gl/frame/index_tables.h"

namespace temblor::render_gl {

// Refers to them.
struct FrameInput {
  const render::FrameContext& context;
  const render::FrameRecord& record;
  const render::SpanSources& sources;
  const render::TranslucentOrder& order;
  const render::LevelData& level_data;
  const DrawOptions& options;
  IndexTables* index_tables;  // null for rgb frames

  const render::Scene& scene() const { return context.scene; }
};

}  // namespace temblor::render_gl
