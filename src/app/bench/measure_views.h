// Measures small views of a level that are drawn at once (render::Renderer::render_views), as programs that
// learn to play need them.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/bench/distribution.h"
#include "app/bench/measurement.h"
#include "app/level/level_loading.h"

namespace temblor::app {

constexpr int kMaxViews = 1024;

struct ViewsMeasurement {
  MeasureOptions options;
  std::size_t views = 0;
  // Times of all views together: at once, with options.settings.threads; and one after the other, with one
  // thread.
  Distribution at_once_ms, one_by_one_ms;

  double ratio() const { return at_once_ms.p50 / one_by_one_ms.p50; }
};

// Draws `views` views (1 to kMaxViews), spread over the level's viewpoints and over all directions. Rounds of
// both kinds alternate; surfaces are in the cache.
ViewsMeasurement measure_views(const LoadedMap& map, const MeasureOptions& options, std::size_t views);

// Returns several lines, each with a newline.
std::string describe_views(const std::string& name, const ViewsMeasurement& measurement);

// Returns an object: map, views, threads, size, color, at_once_ms and one_by_one_ms {p50, p99, max}, ratio.
nlohmann::json make_views_json(const std::string& name, const ViewsMeasurement& measurement);

}  // namespace temblor::app
