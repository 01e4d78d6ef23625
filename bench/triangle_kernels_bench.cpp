// Draws triangles of alias models with depth test and depth writes, in triangles per second, by their size
// in pixels. The mesh is a grid of points moved at random, so that all triangles differ and neighbors share
// edges.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "render/alias/triangle_kernels.h"

namespace temblor::bench {
namespace {

constexpr int kScreenWidth = 1920, kScreenHeight = 1080;
constexpr std::uint32_t kSkinSide = 256;
constexpr std::uint32_t kCells = 40;

struct Field {
  std::vector<render::ScreenVertex> vertices;
  std::vector<render::TexelPoint> texels;
  std::vector<std::uint32_t> triangles;
};

// Two triangles a cell, each of `area_px` on average. Some lie half beyond the picture when they are large.
Field random_field(double area_px, bool snapped) {
  std::mt19937 random(1);
  const double side = std::sqrt(2 * area_px);
  const auto jitter = [&] { return (static_cast<double>(random() % 1001) / 1000 - 0.5) * side * 0.5; };
  const auto coordinate = [&](std::uint32_t cell) {
    const double pixels = 8 + side + cell * side + jitter();
    return static_cast<std::int32_t>(std::lround(snapped ? std::round(pixels) * 256 : pixels * 256));
  };
  Field field;
  for (std::uint32_t row = 0; row <= kCells; ++row)
    for (std::uint32_t column = 0; column <= kCells; ++column) {
      const std::int32_t x = coordinate(column), y = coordinate(row);
      field.vertices.push_back(
          {x, y, 0.001f + static_cast<float>(random() % 1000) * 1e-8f, static_cast<float>(random() % 16000)});
      field.texels.push_back(
          {static_cast<float>(random() % kSkinSide) * 0.1f + static_cast<float>(column) * 5,
           static_cast<float>(random() % kSkinSide) * 0.1f + static_cast<float>(row) * 5});
    }
  const auto number = [](std::uint32_t row, std::uint32_t column) { return row * (kCells + 1) + column; };
  for (std::uint32_t row = 0; row < kCells; ++row)
    for (std::uint32_t column = 0; column < kCells; ++column) {
      const std::uint32_t a = number(row, column), b = number(row, column + 1);
      const std::uint32_t c = number(row + 1, column), d = number(row + 1, column + 1);
      for (const std::uint32_t corner : {a, b, d, a, d, c}) field.triangles.push_back(corner);
    }
  return field;
}

// kFronts: as vector code wants triangles.
template <typename Pixel, auto Draw, bool kFronts>
void draw_triangles(benchmark::State& state) {
  const Field field = random_field(static_cast<double>(state.range(0)), false);
  std::mt19937 random(2);
  std::vector<std::uint8_t> skin(kSkinSide * kSkinSide);
  for (std::uint8_t& texel : skin) texel = static_cast<std::uint8_t>(random());
  const std::vector<Pixel> colors(64 * 256, static_cast<Pixel>(0xff807060u));
  std::vector<Pixel> pixels(kScreenWidth * kScreenHeight);
  std::vector<float> depth(pixels.size(), 0.0f);
  const std::size_t count = field.triangles.size() / 3;
  std::vector<std::uint32_t> numbers(count + render::kFrontsSpare);
  std::vector<render::TriangleRows> rows(numbers.size());
  render::TriangleJob job{field.vertices.data(),
                          field.texels.data(),
                          field.triangles.data(),
                          field.vertices.size(),
                          count,
                          skin.data(),
                          kSkinSide,
                          kSkinSide,
                          colors.data(),
                          {32768, 30000, 28000},
                          true,
                          false,
                          state.range(0) <= 8,
                          {numbers.data(), rows.data(), 0}};
  const render::TriangleTarget target{pixels.data(), depth.data(), kScreenWidth, 0, 0, kScreenHeight};
  for (auto _ : state) {
    if constexpr (kFronts) render::find_front_triangles_simd(job, job.fronts);
    Draw(job, target);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void areas(benchmark::internal::Benchmark* benchmark) {
  for (const int area_px : {1, 2, 3, 4, 8, 16, 32, 64, 128}) benchmark->Arg(area_px);
}

BENCHMARK(draw_triangles<std::uint8_t, render::draw_triangles_u8_simd, true>)
    ->Name("triangles/indexed/affine/vector")
    ->Apply(areas);
BENCHMARK(draw_triangles<std::uint8_t, render::draw_triangles_u8_scalar, false>)
    ->Name("triangles/indexed/affine/plain")
    ->Apply(areas);
BENCHMARK(draw_triangles<std::uint8_t, render::subdivide_triangles_u8, false>)
    ->Name("triangles/indexed/subdivision")
    ->Apply(areas);
BENCHMARK(draw_triangles<std::uint32_t, render::draw_triangles_u32_simd, true>)
    ->Name("triangles/rgb/affine/vector")
    ->Apply(areas);
BENCHMARK(draw_triangles<std::uint32_t, render::draw_triangles_u32_scalar, false>)
    ->Name("triangles/rgb/affine/plain")
    ->Apply(areas);
BENCHMARK(draw_triangles<std::uint32_t, render::subdivide_triangles_u32, false>)
    ->Name("triangles/rgb/subdivision")
    ->Apply(areas);

}  // namespace
}  // namespace temblor::bench
