// A measurement as text for a person and as JSON for a program: what `temblor bench` prints.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/bench/measurement.h"

namespace temblor::app {

// The medians' ratios: how many floors it takes to render, and to present, a frame.
double render_floors(const Measurement& measurement);
double present_floors(const Measurement& measurement);

// Several lines, each ended.
std::string describe_measurement(const std::string& name, const Measurement& measurement);

// map, fps, frames, places, frame_ms {p50, p99, max}, render_ms, present_ms, floor_ms, render_floors,
// present_floors, cold_ms (with --cold), stages {name: ms}, cycles_per_pixel {name: cycles}, faces {in_pvs,
// drawn, seen}, edges, spans, surfaces, surfaces_built, texels_read, cache_bytes, circle_cache_bytes (with
// --cold), allocations, threads, size, color. Counts are medians over the frames, stages means.
nlohmann::json json_of(const std::string& name, const Measurement& measurement);

}  // namespace temblor::app
