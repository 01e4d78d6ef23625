#include "app/lab/engine_figures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "app/bench/samples.h"

namespace temblor::app {
namespace {

constexpr auto kIndexed = render::PixelFormat::kIndexed;

double largest_cache(const Measurement& measurement) {
  return measurement.circle_cache_bytes ? measurement.circle_cache_bytes->max
                                        : static_cast<double>(measurement.cache_bytes);
}

// Sums over views that were drawn with an empty surface cache.
struct ColdSums {
  std::vector<double> faces_in_pvs_per_seen;  // of each view
  double surface_cycles = 0, texels = 0, span_cycles = 0, pixels = 0;
  double all_cycles = 0, all_ms = 0;  // of all stages
};

void add_stages(const render::StageTimes& stages, ColdSums& io_sums) {
  io_sums.surface_cycles += stages.cycles[static_cast<std::size_t>(render::Stage::kSurfaces)];
  io_sums.span_cycles += stages.cycles[static_cast<std::size_t>(render::Stage::kSpans)];
  io_sums.all_cycles += std::accumulate(stages.cycles.begin(), stages.cycles.end(), 0.0);
  io_sums.all_ms += std::accumulate(stages.ms.begin(), stages.ms.end(), 0.0);
}

base::Status draw_cold_views(const LabScenes& scenes, const render::Settings& settings, ColdSums& io_sums) {
  const assets::Look& look = scenes.look();
  render::FrameBuffer frame(640, 400, kIndexed);
  render::Renderer renderer(look.palette, look.colormap);
  return scenes.for_each_scene([&](const render::Scene& scene) {
    renderer.drop_surfaces();
    const render::FrameStats stats = renderer.render(scene, settings, frame);
    if (stats.faces_seen > 0)
      io_sums.faces_in_pvs_per_seen.push_back(double{1} * stats.faces_in_pvs / stats.faces_seen);
    add_stages(stats.stages, io_sums);
    io_sums.texels += static_cast<double>(stats.texels_built);
    io_sums.pixels += static_cast<double>(frame.pixel_count());
  });
}

// The share of a frame's time that the depth buffer adds. Both are measured in turns, and the fastest counts.
base::Result<double> measure_depth_fill(const LabScenes& scenes, MeasureOptions measure) {
  constexpr int kRounds = 3;
  measure.size = {640, 400};
  double with_ms = 1e9, without_ms = 1e9;
  for (int i = 0; i < kRounds; ++i)
    for (const bool fills : {true, false}) {
      measure.settings.fill_depth = fills;
      TRY(const Measurement measured, scenes.measure(measure));
      double& fastest_ms = fills ? with_ms : without_ms;
      fastest_ms = std::min(fastest_ms, measured.render_ms.p50);
    }
  return with_ms / without_ms - 1;
}

// 1/z over the screen.
struct DepthPlane {
  double at_origin, dx, dy;
};

// The time for 1/z at a point of a plane, as an edge list that is sorted by 1/z needs it: each on another
// plane, and each waited for, because a comparison follows.
double time_depth_ns() {
  constexpr std::size_t kPlanes = 256;  // stay in the nearest cache
  constexpr int kSteps = 1 << 20;
  std::array<DepthPlane, kPlanes> planes{};
  for (std::size_t i = 0; i < kPlanes; ++i) {
    const auto part = static_cast<double>(i) / kPlanes;
    planes[i] = {0.01 + 0.001 * part, 1e-5 * part, 1e-5 * (1 - part)};
  }
  double fastest_ms = 1e9;
  volatile double nearest_seen = 0;
  for (int round = 0; round < 5; ++round)
    fastest_ms = std::min(fastest_ms, time_ms([&] {
                            double x = 0, y = 0, nearest = 0;
                            for (int i = 0; i < kSteps; ++i) {
                              const DepthPlane& plane = planes[static_cast<std::size_t>(i) % kPlanes];
                              nearest = std::max(nearest, plane.at_origin + plane.dx * x + plane.dy * y);
                              x = i & 511;
                              y = i & 255;
                            }
                            nearest_seen = nearest;
                          }));
  return fastest_ms * 1e6 / kSteps;
}

}  // namespace

base::Result<EngineFigures> measure_engine(std::span<const LabScenes> levels, const MeasureOptions& asked) {
  EngineFigures engine;
  engine.fps_640x400 = 1e9;
  ColdSums sums;
  std::vector<double> depth_shares;
  MeasureOptions measure = asked;
  measure.format = kIndexed;
  measure.settings.mip_rule = render::MipRule::kStock;
  for (const LabScenes& scenes : levels) {
    measure.cold = true;
    measure.size = {320, 200};
    TRY(const Measurement smallest, scenes.measure(measure));
    measure.size = {640, 480};
    TRY(const Measurement larger, scenes.measure(measure));
    measure.size = {640, 400};
    TRY(const Measurement middle, scenes.measure(measure));
    engine.texels_read_320x200 += smallest.texels_read.p50 / static_cast<double>(levels.size());
    engine.cache_bytes_320x200 = std::max(engine.cache_bytes_320x200, largest_cache(smallest));
    engine.cache_bytes_640x480 = std::max(engine.cache_bytes_640x480, largest_cache(larger));
    engine.fps_640x400 = std::min(engine.fps_640x400, middle.fps);
    TRY_STATUS(draw_cold_views(scenes, asked.settings, sums));
    measure.cold = false;
    TRY(const double depth_share, measure_depth_fill(scenes, measure));
    depth_shares.push_back(depth_share);
  }
  engine.faces_in_pvs_per_seen = compute_distribution(std::move(sums.faces_in_pvs_per_seen));
  if (sums.texels > 0) engine.cycles_per_texel_built = sums.surface_cycles / sums.texels;
  engine.cycles_per_pixel_drawn = sums.span_cycles / sums.pixels;
  engine.time_to_fill_depth = compute_distribution(std::move(depth_shares)).p50;
  if (sums.all_ms > 0) engine.cycles_per_depth = time_depth_ns() * sums.all_cycles / sums.all_ms / 1e6;
  return engine;
}

}  // namespace temblor::app
