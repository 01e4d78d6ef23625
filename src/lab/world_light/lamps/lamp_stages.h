// The stages of techniques that light each pixel by the level's light entities. They differ only in how they
// draw the spans of one face. A level without light entities, and parallel projection, are left to the
// engine.
#pragma once

#include <functional>

#include "lab/technique.h"
#include "lab/world_light/kernels/phong_kernels.h"
#include "lab/world_light/lamps/level_lamps.h"
#include "lab/world_light/lit_draws.h"
#include "lab/world_light/lit_polygons.h"

namespace temblor::lab {

// One draw: its lamps, and triangles whose "light" is the normal. Without triangles, `normal` is everywhere.
struct LampDraw {
  std::span<const PointLamp> lamps;
  std::span<const LitPolygon> triangles;
  std::array<float, 3> normal;
};

// Some spans of a draw, on their way to a frame.
struct LampSpans {
  const render::ViewFrame& view;
  const render::SpanSources& sources;
  const LampDraw& draw;
  const LitSpans& job;  // without spans
  std::span<const render::Span> spans;
  const render::KernelTarget& target;
};

struct LampOptions {
  std::size_t lamps_per_face = 8;
  double smooth_deg = 0;  // angle up to which faces share normals
  // Also suns, sky domes, and glowing surfaces, which would shine through walls otherwise.
  bool has_shadows = false;
};

// `begin_level` is called when the level changes, and returns whether `draw_spans` can draw it. `draw_spans`
// is called by several threads at once.
render::FrameStages make_lamp_stages(const LampOptions& options, Counter* counter,
                                     std::function<bool(const world::Level& level)> begin_level,
                                     std::function<void(const LampSpans& spans)> draw_spans);

// An error of one line if the level has no light entities.
base::Status check_lamps(std::span<const double> values, const world::Level& level);

}  // namespace temblor::lab
