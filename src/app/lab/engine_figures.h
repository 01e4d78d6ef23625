// Figures of the engine alone that stand next to numbers of the articles.
#pragma once

#include <span>

#include "app/bench/distribution.h"
#include "app/lab/lab_scenes.h"
#include "base/result.h"

namespace temblor::app {

// In all levels, at the sizes of the articles; `indexed`, which they had.
struct EngineFigures {
  Distribution faces_in_pvs_per_seen;                       // over views
  double texels_read_320x200 = 0;                           // median over views, mean of the levels
  double cache_bytes_320x200 = 0, cache_bytes_640x480 = 0;  // largest, after a circle
  double fps_640x400 = 0;                                   // of the slowest level
  double cycles_per_texel_built = 0, cycles_per_pixel_drawn = 0;
  double time_to_fill_depth =
      0;                        // share of a frame without the depth buffer, at 640x400; median of the levels
  double cycles_per_depth = 0;  // to find 1/z of a plane at a pixel, one after the other; 0: unknown
};

// `measure`: everything but size, format, and what to measure. There must be at least one level.
base::Result<EngineFigures> measure_engine(std::span<const LabScenes> levels, const MeasureOptions& measure);

}  // namespace temblor::app
