// Measures how fast the renderer is, in levels and demos.
//
// In a level, the camera turns a full circle at every viewpoint: each view is drawn once to fill the caches,
// then once with the clock running. A demo is drawn one frame per packet, as fast as possible, with
// everything cold as in a game. The fill baseline (fill_baseline.h) runs after every frame, so that both see
// the same state of the machine, for example its clock frequency and other load.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/distribution.h"
#include "app/commands/options.h"
#include "app/demo/demo_loading.h"
#include "app/level/level_loading.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "lab/technique.h"
#include "render/renderer.h"

namespace temblor::app {

class ModelCrowd;

struct MeasureOptions {
  FrameSize size{1920, 1080};
  render::PixelFormat format = render::PixelFormat::kRgb;
  float fov_deg = 90;
  RendererKind renderer = RendererKind::kCpu;
  // Angle between two views of a circle.
  double step_deg = 5;
  // Runs of a demo; the fastest time of every frame counts.
  int runs = 1;
  // Also measure views with an empty surface cache; of the CPU only.
  bool cold = false;
  // Also measure views with changing light.
  bool relight = false;
  // Seconds of a level after which no other viewpoint is begun; 0: no limit. Slow techniques need one.
  double time_limit_s = 0;
  // Also run the fill baseline after each frame.
  bool baseline = true;
  render::Settings settings;
  // The technique that draws the frames; null: the engine's own stages.
  const lab::Choice* technique = nullptr;
  // Models before the camera; null: none. They move from frame to frame.
  const ModelCrowd* models = nullptr;
};

// Render times of the same views with constant and with changing light.
struct RelightTimes {
  Distribution still_ms;
  // All light styles change between two frames.
  Distribution relit_ms;
  // The same with Settings::relight_alternate.
  Distribution alternate_ms;
  // The standard light styles advance by 0.1 s between two frames, so that some surfaces change. Means of the
  // surfaces and texels that are then built in a frame.
  Distribution animated_ms;
  double animated_surfaces = 0, animated_texels = 0;
};

// Results. Distributions are over all warm frames of a level or all frames of a demo; times are wall time.
struct Measurement {
  MeasureOptions options;
  // Viewpoints of the level; 0 for a demo.
  std::size_t places = 0;
  // Measured frames.
  std::size_t frames = 0;
  // 1000 / mean of frame_ms.
  double fps = 0;
  // Client, render, and present; and without present.
  Distribution frame_ms, render_ms;
  // Only of a demo: index of the packet of the slowest frame.
  std::size_t slowest_frame = 0;
  // Only of demos, included in render_ms: read messages, move entities and effects, lay out status bar and
  // texts.
  Distribution client_ms;
  double client_mean_ms = 0;
  // Palette expansion; 0 for rgb, which a window shows as it is.
  Distribution present_ms;
  double present_mean_ms = 0;
  // Fill baseline.
  Distribution baseline_ms;
  // Four views per place, 90 degrees apart, with the surface cache emptied before each; only with
  // options.cold.
  std::optional<Distribution> cold_ms;
  // The same four views; only with options.relight.
  std::optional<RelightTimes> relight;
  // Size of the surface cache after a circle that started with an empty one; only with options.cold.
  std::optional<Distribution> circle_cache_bytes;
  // Means, so that the stages add up to the frame.
  std::array<double, render::kStages> stage_ms{};
  std::array<double, render::kStages> stage_cycles_per_pixel{};
  // Only of demos.
  Distribution models, triangles, particles;
  // Counts of render::FrameStats.
  Distribution faces_in_pvs, faces_drawn, faces_seen, edges, spans, surfaces, texels_read;
  // Surface cache in use at the end.
  std::uint64_t cache_bytes = 0;
  // Surface blocks, and their texels, built in all measured frames together.
  std::uint64_t surfaces_built = 0, texels_built = 0;
  // Maximum number of calls of operator new in a frame, and how many frames have any. In a demo, arenas grow
  // when more is seen than before.
  std::uint64_t max_allocations = 0;
  std::size_t allocating_frames = 0;
  // Only of demos: problems that playing it found, for the user.
  std::vector<std::string> notes;

  // Adds a frame with this number of allocations.
  void count_allocations(std::uint64_t count);
};

// Measures all views of a level. Level and settings must be valid. Fails only if a graphics card was asked
// for and cannot draw.
base::Result<Measurement> measure(const LoadedMap& map, const MeasureOptions& options);
// Ignores options.step_deg, cold, and relight. Returns an error if the demo is damaged.
base::Result<Measurement> measure_demo(const LoadedDemo& demo,
                                       const client::PresentationSettings& presentation,
                                       const MeasureOptions& options);

// Returns the speedup of two fill baselines in two threads over one after the other: 2.0 on a machine with
// two independent cores, less if they share memory bandwidth, power, or a physical core.
double measure_baseline_speedup(FrameSize size, render::PixelFormat format);

}  // namespace temblor::app
