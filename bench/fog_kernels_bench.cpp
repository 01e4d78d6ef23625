// Measures the fog of a row of pixels, in pixels per second.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "render/color/fog_kernels.h"

namespace temblor::bench {
namespace {

constexpr std::int32_t kWidth = 1920;

// A row of `run` pixels of one surface, then as many of the next, and so on, 100 to 2,000 units away. Along a
// surface the depth changes by up to a tenth.
std::vector<float> make_depths(std::int32_t run) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> distances(100, 2000), slopes(-0.1f, 0.1f);
  std::vector<float> depths;
  for (std::int32_t first = 0; first < kWidth; first += run) {
    const float depth = 1 / distances(random), slope = slopes(random) * depth / static_cast<float>(run);
    for (std::int32_t i = 0; i < run && first + i < kWidth; ++i)
      depths.push_back(depth + slope * static_cast<float>(i));
  }
  return depths;
}

template <typename Pixel, auto FogRow>
void fog_row(benchmark::State& state) {
  const std::vector<float> depths = make_depths(static_cast<std::int32_t>(state.range(0)));
  const render::FogCurve curve = render::make_fog_curve();
  constexpr float kRate = 0.05f / 64;  // a light fog
  std::vector<float> step_end_depths;
  for (const float end : curve.step_ends) step_end_depths.push_back(end * kRate);
  std::mt19937 random(2);
  std::vector<std::uint8_t> rows((render::kFogSteps + 1) * 256);
  for (std::uint8_t& index : rows) index = static_cast<std::uint8_t>(random());
  std::vector<Pixel> pixels(kWidth);
  for (Pixel& pixel : pixels) pixel = static_cast<Pixel>(random());
  render::FogRow row{};
  row.pixels = pixels.data();
  row.depth = depths.data();
  row.count = kWidth;
  row.perspective = true;
  row.inverse_rate = 1 / kRate;
  row.color = 0x8090a0;
  row.curve = &curve;
  row.rows = rows.data();
  const render::FogCells cells = render::make_fog_cells(step_end_depths.data());
  row.step_end_depths = step_end_depths.data();
  row.cells = &cells;
  for (auto _ : state) {
    FogRow(row);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kWidth);
}

BENCHMARK(fog_row<std::uint8_t, render::fog_row_u8_simd>)
    ->Name("fog/indexed/vector")
    ->Arg(16)
    ->Arg(64)
    ->Arg(256);
BENCHMARK(fog_row<std::uint8_t, render::fog_row_u8_scalar>)
    ->Name("fog/indexed/scalar")
    ->Arg(16)
    ->Arg(64)
    ->Arg(256);
BENCHMARK(fog_row<std::uint32_t, render::fog_row_u32_simd>)
    ->Name("fog/rgb/vector")
    ->Arg(16)
    ->Arg(64)
    ->Arg(256);
BENCHMARK(fog_row<std::uint32_t, render::fog_row_u32_scalar>)
    ->Name("fog/rgb/scalar")
    ->Arg(16)
    ->Arg(64)
    ->Arg(256);

}  // namespace
}  // namespace temblor::bench
