// The measured values of every frame, one array per kind, and their summary.
#pragma once

#include <chrono>
#include <vector>

#include "app/bench/measurement.h"
#include "render/frame_buffer.h"

namespace temblor::app {

// Returns the wall time of a call of `function`, in milliseconds.
template <typename Function>
double time_ms(Function&& function) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  function();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Parallel arrays, one element per frame. client_ms is empty for levels.
struct Samples {
  std::vector<double> frame_ms, client_ms, render_ms, present_ms, baseline_ms;
  std::vector<double> faces_in_pvs, faces_drawn, faces_seen, edges, spans, surfaces, texels_read;
  std::vector<double> models, triangles, particles;
  std::vector<render::StageTimes> stages;

  void reserve(std::size_t count);
  // Appends the counts and stage times of a frame. The caller appends the other times.
  void add(const render::FrameStats& stats);
  // Keeps the times of the faster run for each frame. `others` must be of the same frames, so that counts are
  // equal.
  void keep_fastest(const Samples& others);
  // Computes the distributions and means. `pixels` is the size of a frame.
  void summarize(std::size_t pixels, Measurement& io_result) const;
};

}  // namespace temblor::app
