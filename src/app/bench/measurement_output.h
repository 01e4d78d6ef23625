// Formats a measurement as text and as JSON, for `temblor bench`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/bench/measurement.h"

namespace temblor::app {

// Returns a ratio of medians: the time to render, or to present, a frame divided by the time of the fill
// baseline.
double compute_render_baselines(const Measurement& measurement);
double compute_present_baselines(const Measurement& measurement);

// Returns "1920x1080 rgb, threads: 1".
std::string describe_conditions(const MeasureOptions& options);

// Returns several lines, each with a newline.
std::string describe_measurement(const std::string& name, const Measurement& measurement);

// Returns an object. Counts are medians over the frames, stages means:
//
//   map or demo, fps, frames, places, threads, size, color
//   frame_ms, render_ms, present_ms {p50, p99, max}       also cold_ms (--cold)
//   floor_ms, render_floors, present_floors               fill baseline, and ratios to it
//   stages {name: ms}, cycles_per_pixel {name: cycles}
//   faces {in_pvs, drawn, seen}, edges, spans, surfaces, surfaces_built, texels_read
//   cache_bytes, allocations, allocating_frames           also circle_cache_bytes (--cold)
//   relight {still_ms, relit_ms, alternate_ms, ...}       only with --relight
//   models, triangles, particles, slowest_frame           only of demos
//
// `temblor bench --against` adds "against" (comparison.h).
nlohmann::json make_json(const std::string& name, const Measurement& measurement);
// Returns an object with p50, p99, and max.
nlohmann::json make_json(const Distribution& values);
// Returns "1920x1080".
std::string format_size(const FrameSize& size);

}  // namespace temblor::app
