// Draws 10,000 particles at 1920 x 1080 on one thread: at distances where their squares are smallest, as in
// a nearby explosion, and largest.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "render/particles/draw_particles.h"
#include "support/pictures/stage_parts.h"

namespace temblor::bench {
namespace {

struct Cloud {
  std::vector<float> x, y, z;
  std::vector<std::uint8_t> color;
};

// Spread over the whole picture of a camera at the origin that looks along x.
Cloud random_cloud(std::size_t count, float least_distance, float most_distance) {
  std::mt19937 random(1);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random()) / 4294967296.0f;
  };
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const float distance = uniform(least_distance, most_distance);
    cloud.x.push_back(distance);
    cloud.y.push_back(distance * uniform(-1.3f, 1.3f));
    cloud.z.push_back(distance * uniform(-0.75f, 0.75f));
    cloud.color.push_back(static_cast<std::uint8_t>(random()));
  }
  return cloud;
}

render::ViewFrame straight_view() {
  render::ViewFrame view;
  view.width = 1920;
  view.height = 1080;
  view.pixels_per_unit = 720;
  view.center_x = 959.5;
  view.center_y = 539.5;
  return view;
}

// The value of whole frames.
constexpr int kBandRows = 64;

// Depth is cleared outside the measurement, so that no run is hidden by the particles of the last one.
template <render::PixelFormat kFormat, bool kVectorKernels>
void draw_particles(benchmark::State& state) {
  const Cloud cloud =
      random_cloud(10'000, static_cast<float>(state.range(0)), static_cast<float>(state.range(1)));
  render::Scene scene;
  scene.particles = {cloud.x, cloud.y, cloud.z, cloud.color};
  const render::ViewFrame view = straight_view();
  render::FrameBuffer frame(view.width, view.height, kFormat);
  const render::ColorTables tables = render::make_color_tables({}, {});
  test::StageParts parts({.simd_kernels = kVectorKernels, .band_rows = kBandRows});
  for (auto _ : state) {
    state.PauseTiming();
    parts.arenas.frame.reset();
    std::fill(frame.depth().begin(), frame.depth().end(), 1.0f / 1024);
    state.ResumeTiming();
    const render::ParticleBands bands = render::place_particles(parts.context(scene, kFormat, tables), view);
    for (std::size_t band = 0; band < bands.rects.size(); ++band)
      render::draw_particles(bands, band, kVectorKernels, frame);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * 10'000);
}

void distances(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({512, 1000})->Args({32, 512})->Args({8, 32});
  benchmark->Unit(benchmark::kMicrosecond);
}

constexpr auto kIndexed = render::PixelFormat::kIndexed, kRgb = render::PixelFormat::kRgb;

BENCHMARK(draw_particles<kIndexed, true>)->Name("particles/indexed/vector")->Apply(distances);
BENCHMARK(draw_particles<kIndexed, false>)->Name("particles/indexed/plain")->Apply(distances);
BENCHMARK(draw_particles<kRgb, true>)->Name("particles/rgb/vector")->Apply(distances);
BENCHMARK(draw_particles<kRgb, false>)->Name("particles/rgb/plain")->Apply(distances);

}  // namespace
}  // namespace temblor::bench
