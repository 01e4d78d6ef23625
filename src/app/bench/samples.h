// Every measured frame's numbers, by kind, and what they come to.
#pragma once

#include <chrono>
#include <vector>

#include "app/bench/measurement.h"
#include "render/frame.h"

namespace temblor::app {

// How long `function` takes, by the wall clock.
template <typename Function>
double time_ms(Function&& function) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  function();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Samples {
  std::vector<double> frame_ms, client_ms, render_ms, present_ms, floor_ms;
  std::vector<double> faces_in_pvs, faces_drawn, faces_seen, edges, spans, surfaces, texels_read;
  std::vector<double> models, triangles, particles;
  std::vector<render::StageTimes> stages;

  void reserve(std::size_t count);
  void add(const render::FrameStats& stats);
  // Of each frame the quicker one's times. `others` is of the same frames: what was counted is the same.
  void keep_quickest(const Samples& others);
  // Fills in what is worked out from samples.
  void summarize(std::size_t pixels, Measurement& io_result) const;
};

}  // namespace temblor::app
