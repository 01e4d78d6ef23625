// Draws rows of a sprite of 64 x 64 texels in front of everything else, in pixels per second, by the length
// of a row.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "render/sprites/sprite_kernels.h"

namespace temblor::bench {
namespace {

constexpr std::int32_t kSide = 64;
constexpr std::int32_t kRows = 64;

// Tilted if not affine. One texel in four is transparent.
template <typename Pixel, auto DrawRow, bool kAffine>
void draw_sprite_rows(benchmark::State& state) {
  const auto count = static_cast<std::int32_t>(state.range(0));
  std::mt19937 random(1);
  std::vector<std::uint8_t> texels(kSide * kSide);
  for (std::uint8_t& texel : texels)
    texel = random() % 4 == 0 ? render::kClearTexel : static_cast<std::uint8_t>(random() % 255);
  const std::vector<std::uint32_t> colors(256, 0xff123456u);
  std::vector<Pixel> pixels(static_cast<std::size_t>(count) * kRows);
  std::vector<float> depth(pixels.size(), 0.001f);
  const float nearness = 0.01f, step = kSide / static_cast<float>(count), scale = kAffine ? 1 : nearness;
  for (auto _ : state) {
    for (std::int32_t y = 0; y < kRows; ++y) {
      const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(count);
      DrawRow({{nearness, kAffine ? 0 : 1e-7f},
               {0, step * scale},
               {static_cast<float>(y) * scale, 0},
               kAffine,
               texels.data(),
               kSide,
               kSide,
               colors.data(),
               pixels.data() + first,
               depth.data() + first,
               0,
               count});
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * kRows * count);
}

void row_lengths(benchmark::internal::Benchmark* benchmark) {
  for (const int length : {20, 100, 400}) benchmark->Arg(length);
}

BENCHMARK(draw_sprite_rows<std::uint8_t, render::draw_sprite_row_u8_simd, true>)
    ->Name("sprites/indexed/affine/vector")
    ->Apply(row_lengths);
BENCHMARK(draw_sprite_rows<std::uint8_t, render::draw_sprite_row_u8_scalar, true>)
    ->Name("sprites/indexed/affine/plain")
    ->Apply(row_lengths);
BENCHMARK(draw_sprite_rows<std::uint8_t, render::draw_sprite_row_u8_simd, false>)
    ->Name("sprites/indexed/tilted/vector")
    ->Apply(row_lengths);
BENCHMARK(draw_sprite_rows<std::uint32_t, render::draw_sprite_row_u32_simd, true>)
    ->Name("sprites/rgb/affine/vector")
    ->Apply(row_lengths);
BENCHMARK(draw_sprite_rows<std::uint32_t, render::draw_sprite_row_u32_scalar, true>)
    ->Name("sprites/rgb/affine/plain")
    ->Apply(row_lengths);

}  // namespace
}  // namespace temblor::bench
