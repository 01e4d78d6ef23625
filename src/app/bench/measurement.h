// Measures the renderer, frame by frame beside the floor loop: in a level, full circles at every viewpoint;
// in a recording, one frame for each packet, as fast as they can be drawn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/bench/distribution.h"
#include "app/commands/options.h"
#include "app/demo/demo_loading.h"
#include "app/files/level_loading.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

struct MeasureOptions {
  FrameSize size{1920, 1080};
  render::PixelFormat format = render::PixelFormat::kRgb;
  float fov_deg = 90;
  double step_deg = 5;   // from one view of a circle to the next
  int runs = 1;          // of a recording: each frame's times are those of its quickest run
  bool cold = false;     // also measure views whose surfaces are all still to be built
  bool relight = false;  // and views whose light changes
  render::Settings settings;
};

// Render times of the same views under light that stays and light that changes.
struct RelightTimes {
  Distribution still_ms;
  Distribution relit_ms;      // all light styles have changed since the frame before
  Distribution alternate_ms;  // the same with Settings::relight_alternate
  // The standard light styles, a tenth of a second on: some of the surfaces change.
  Distribution animated_ms;
  double animated_surfaces = 0, animated_texels = 0;  // built, means
};

// Medians over all warm frames unless said otherwise. Milliseconds of wall time.
struct Measurement {
  MeasureOptions options;
  std::size_t places = 0;         // viewpoints of the level; 0: of a recording
  std::size_t frames = 0;         // measured; of a level, warm ones
  double fps = 0;                 // frames / (time to render and present them)
  Distribution frame_ms;          // client, render and present
  Distribution render_ms;         // all but present
  std::size_t slowest_frame = 0;  // of a recording: which of its packets, from 0
  // Recordings, part of render_ms: messages read, entities and effects moved, status bar and texts laid out.
  Distribution client_ms;
  double client_mean_ms = 0;
  Distribution present_ms;  // palette expansion; 0 for rgb, which a window takes as it is
  double present_mean_ms = 0;
  Distribution floor_ms;
  // Four views at each place, 90 degrees apart, all surfaces dropped before each; only with options.cold.
  std::optional<Distribution> cold_ms;
  // Four views at each place, as for cold_ms; only with options.relight.
  std::optional<RelightTimes> relight;
  // Bytes of surfaces after a whole circle at a place that began with none; only with options.cold.
  std::optional<Distribution> circle_cache_bytes;
  std::array<double, render::kStages> stage_ms{};                // means, so that they add up
  std::array<double, render::kStages> stage_cycles_per_pixel{};  // means
  Distribution models, triangles, particles;                     // of recordings
  Distribution faces_in_pvs, faces_drawn, faces_seen, edges, spans, surfaces, texels_read;
  std::uint64_t cache_bytes = 0;     // in use at the end: all surfaces of all views
  std::uint64_t surfaces_built = 0;  // in all warm frames together
  // Calls of operator new in a frame. Of a recording the first sight of things is among them: arenas grow.
  std::uint64_t most_allocations = 0;
  std::size_t allocating_frames = 0;

  void count_allocations(std::uint64_t of_frame);
};

Measurement measure(const LoadedMap& map, const MeasureOptions& options);
// options.step_deg and cold do not count. Fails where the recording does.
base::Result<Measurement> measure_demo(const LoadedDemo& demo,
                                       const client::PresentationSettings& presentation,
                                       const MeasureOptions& options);

// How much faster two copies of the floor loop, each in a thread of its own, are than one: 2.0 on a machine
// that really gives two cores.
double floor_speedup_of_two_threads(FrameSize size, render::PixelFormat format);

}  // namespace temblor::app
