#include "app/bench/samples.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace temblor::app {

void Samples::reserve(std::size_t count) {
  for (std::vector<double>* samples :
       {&frame_ms, &client_ms, &render_ms, &present_ms, &floor_ms, &faces_in_pvs, &faces_drawn, &faces_seen,
        &edges, &spans, &surfaces, &texels_read, &models, &triangles, &particles})
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

void Samples::keep_quickest(const Samples& others) {
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
    floor_ms[i] = std::min(floor_ms[i], others.floor_ms[i]);
  }
}

void Samples::summarize(std::size_t pixels, Measurement& io_result) const {
  io_result.frames = frame_ms.size();
  io_result.fps = 1000.0 / mean_of(frame_ms);
  io_result.frame_ms = distribution_of(frame_ms);
  io_result.render_ms = distribution_of(render_ms);
  io_result.slowest_frame =
      static_cast<std::size_t>(std::max_element(frame_ms.begin(), frame_ms.end()) - frame_ms.begin());
  io_result.present_mean_ms = mean_of(present_ms);
  io_result.present_ms = distribution_of(present_ms);
  if (!client_ms.empty()) {
    io_result.client_mean_ms = mean_of(client_ms);
    io_result.client_ms = distribution_of(client_ms);
  }
  io_result.floor_ms = distribution_of(floor_ms);
  io_result.faces_in_pvs = distribution_of(faces_in_pvs);
  io_result.faces_drawn = distribution_of(faces_drawn);
  io_result.faces_seen = distribution_of(faces_seen);
  io_result.edges = distribution_of(edges);
  io_result.spans = distribution_of(spans);
  io_result.surfaces = distribution_of(surfaces);
  io_result.texels_read = distribution_of(texels_read);
  io_result.models = distribution_of(models);
  io_result.triangles = distribution_of(triangles);
  io_result.particles = distribution_of(particles);
  const auto frames = static_cast<double>(frame_ms.size());
  const render::StageTimes sums = std::accumulate(
      stages.begin(), stages.end(), render::StageTimes{},
      [](render::StageTimes sum, const render::StageTimes& of_frame) { return sum += of_frame; });
  for (std::size_t stage = 0; stage < render::kStages; ++stage) {
    io_result.stage_ms[stage] = sums.ms[stage] / frames;
    io_result.stage_cycles_per_pixel[stage] = sums.cycles[stage] / (frames * static_cast<double>(pixels));
  }
}

}  // namespace temblor::app
