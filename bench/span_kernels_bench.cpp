// Draws spans of one surface and fills 1/z, in pixels per second, by the mean length of a span.
#include <benchmark/benchmark.h>

#include "bench/random_spans.h"

namespace temblor::bench {
namespace {

constexpr std::int32_t kSurfaceSide = 256;
constexpr std::size_t kPixels = 200'000;

// A wall seen at a slant: all coordinates and depth change in both directions of the screen.
render::SurfaceSpans slanted_wall(const std::vector<render::Span>& spans, const void* texels,
                                  render::KernelDivide divide) {
  const render::KernelPlane depth = {0.002, 1e-6, 2e-7};
  const render::KernelPlane s = {0.01, 1.8e-4, 1e-6}, t = {0.01, 2e-6, 2.6e-4};
  return {depth,        s,           t, divide, texels, kSurfaceSide, kSurfaceSide - 1, kSurfaceSide - 1,
          spans.data(), spans.size()};
}

template <typename Texel, auto DrawSpans, render::KernelDivide Divide>
void draw_spans(benchmark::State& state) {
  const std::vector<render::Span> spans = random_spans(static_cast<int>(state.range(0)), kPixels);
  // Padded like surface blocks, for wide loads at the end.
  const std::vector<Texel> texels(kSurfaceSide * kSurfaceSide + 64, Texel{7});
  constexpr std::size_t kScreenPixels = std::size_t{kScreenWidth} * kScreenHeight;
  std::vector<Texel> pixels(kScreenPixels + 64);
  std::vector<float> depth(kScreenPixels + 64);
  const render::SurfaceSpans surface = slanted_wall(spans, texels.data(), Divide);
  const render::KernelTarget target = {pixels.data(), depth.data(), kScreenWidth};
  for (auto _ : state) {
    DrawSpans(surface, target);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * list_pixels(spans)));
}

constexpr auto kExact = render::KernelDivide::kEveryPixel;
constexpr auto kEvery16 = render::KernelDivide::kAffine;

void span_lengths(benchmark::internal::Benchmark* benchmark) {
  for (const int length : {4, 16, 40, 120}) benchmark->Arg(length);
}

BENCHMARK(draw_spans<std::uint8_t, render::draw_surface_spans_u8_simd, kExact>)
    ->Name("spans/indexed/exact/vector")
    ->Apply(span_lengths);
BENCHMARK(draw_spans<std::uint8_t, render::draw_surface_spans_u8_scalar, kExact>)
    ->Name("spans/indexed/exact/plain")
    ->Apply(span_lengths);
BENCHMARK(draw_spans<std::uint8_t, render::draw_surface_spans_u8_simd, kEvery16>)
    ->Name("spans/indexed/every16/vector")
    ->Apply(span_lengths);
BENCHMARK(draw_spans<std::uint32_t, render::draw_surface_spans_u32_simd, kExact>)
    ->Name("spans/rgb/exact/vector")
    ->Apply(span_lengths);
BENCHMARK(draw_spans<std::uint32_t, render::draw_surface_spans_u32_scalar, kExact>)
    ->Name("spans/rgb/exact/plain")
    ->Apply(span_lengths);
BENCHMARK(draw_spans<std::uint32_t, render::draw_surface_spans_u32_simd, kEvery16>)
    ->Name("spans/rgb/every16/vector")
    ->Apply(span_lengths);

}  // namespace
}  // namespace temblor::bench
