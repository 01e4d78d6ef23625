#include "app/bench/frame_report.h"

#include <fmt/format.h>

#include <iterator>
#include <numeric>

namespace temblor::app {

// First the counts, in the order of the pipeline, then one line per stage and their total.
std::string describe_frame(const render::FrameStats& stats, std::size_t pixels) {
  constexpr double kKibibyte = 1024.0;
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "faces     {:>8} in PVS  {:>8} drawn  {:>8} seen\n", stats.faces_in_pvs,
                 stats.faces_drawn, stats.faces_seen);
  fmt::format_to(out, "edges     {:>8}\n", stats.edges);
  fmt::format_to(out, "spans     {:>8}  bands {}\n", stats.spans, stats.bands);
  fmt::format_to(out, "surfaces  {:>8}  built {}  not cached {}\n", stats.surfaces, stats.surfaces_built,
                 stats.over_budget);
  fmt::format_to(out, "cache     {:>8.0f} KiB  hits {}  misses {}  evicted {}\n",
                 static_cast<double>(stats.cache_bytes) / kKibibyte, stats.cache_hits, stats.cache_misses,
                 stats.cache_evictions);
  fmt::format_to(out, "texels    {:>8} read  {} built\n", stats.texels_read, stats.texels_built);

  const auto pixel_count = static_cast<double>(pixels);
  auto stage_line = [&](const char* name, double ms, double cycles) {
    fmt::format_to(out, "{:<10}{:>8.3f} ms  {:>8.2f} cycles/pixel\n", name, ms, cycles / pixel_count);
  };
  for (std::size_t stage = 0; stage < render::kStages; ++stage)
    stage_line(render::kStageNames[stage], stats.stages.ms[stage], stats.stages.cycles[stage]);
  stage_line("total", std::accumulate(stats.stages.ms.begin(), stats.stages.ms.end(), 0.0),
             std::accumulate(stats.stages.cycles.begin(), stats.stages.cycles.end(), 0.0));
  return text;
}

}  // namespace temblor::app
