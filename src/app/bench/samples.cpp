#include "app/bench/samples.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace temblor::app {

// Reserves all arrays, so that no allocation of this structure falls into a measured frame.
void Samples::reserve(std::size_t count) {
  for (std::vector<double>* samples :
       {&frame_ms, &client_ms, &render_ms, &present_ms, &baseline_ms, &faces_in_pvs, &faces_drawn,
        &faces_seen, &edges, &spans, &surfaces, &texels_read, &models, &triangles, &particles})
    samples->reserve(count);
  stages.reserve(count);
}

void Samples::add(const render::FrameStats& stats) {
  faces_in_pvs.push_back(stats.faces_in_pvs);
  faces_drawn.push_back(stats.faces_drawn);
  faces_seen.push_back(stats.faces_seen);
  edges.push_back(stats.edges);
  spans.push_back(stats.spans);
  surfaces.push_back(stats.surfaces);
  texels_read.push_back(static_cast<double>(stats.texels_read));
  models.push_back(stats.models);
  triangles.push_back(stats.triangles);
  particles.push_back(stats.particles);
  stages.push_back(stats.stages);
}

// Counts are the same in each run, because a demo is deterministic, so only times are compared.
void Samples::keep_fastest(const Samples& others) {
  CHECK(others.frame_ms.size() == frame_ms.size(), "{} and {} frames", frame_ms.size(),
        others.frame_ms.size());
  for (std::size_t i = 0; i < frame_ms.size(); ++i) {
    if (others.frame_ms[i] < frame_ms[i]) {
      frame_ms[i] = others.frame_ms[i];
      client_ms[i] = others.client_ms[i];
      render_ms[i] = others.render_ms[i];
      present_ms[i] = others.present_ms[i];
      stages[i] = others.stages[i];
    }
    if (!baseline_ms.empty()) baseline_ms[i] = std::min(baseline_ms[i], others.baseline_ms[i]);
  }
}

// Stages are averaged instead of taking medians, so that they add up to the mean frame.
void Samples::summarize(std::size_t pixels, Measurement& io_result) const {
  io_result.frames = frame_ms.size();
  io_result.fps = 1000.0 / compute_mean(frame_ms);
  io_result.frame_ms = compute_distribution(frame_ms);
  io_result.render_ms = compute_distribution(render_ms);
  io_result.slowest_frame =
      static_cast<std::size_t>(std::max_element(frame_ms.begin(), frame_ms.end()) - frame_ms.begin());
  io_result.present_mean_ms = compute_mean(present_ms);
  io_result.present_ms = compute_distribution(present_ms);
  if (!client_ms.empty()) {
    io_result.client_mean_ms = compute_mean(client_ms);
    io_result.client_ms = compute_distribution(client_ms);
  }
  io_result.baseline_ms = compute_distribution(baseline_ms);
  io_result.faces_in_pvs = compute_distribution(faces_in_pvs);
  io_result.faces_drawn = compute_distribution(faces_drawn);
  io_result.faces_seen = compute_distribution(faces_seen);
  io_result.edges = compute_distribution(edges);
  io_result.spans = compute_distribution(spans);
  io_result.surfaces = compute_distribution(surfaces);
  io_result.texels_read = compute_distribution(texels_read);
  io_result.models = compute_distribution(models);
  io_result.triangles = compute_distribution(triangles);
  io_result.particles = compute_distribution(particles);
  const auto frames = static_cast<double>(frame_ms.size());
  const render::StageTimes sums =
      std::accumulate(stages.begin(), stages.end(), render::StageTimes{},
                      [](render::StageTimes sum, const render::StageTimes& frame) { return sum += frame; });
  for (std::size_t stage = 0; stage < render::kStages; ++stage) {
    io_result.stage_ms[stage] = sums.ms[stage] / frames;
    io_result.stage_cycles_per_pixel[stage] = sums.cycles[stage] / (frames * static_cast<double>(pixels));
  }
}

}  // namespace temblor::app
