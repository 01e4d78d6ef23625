// Measures the kernels that build rows of surface blocks and expand the palette, in texels and pixels per
// second.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "render/screen/present_kernels.h"
#include "render/surfaces/build_kernels.h"

namespace temblor::bench {
namespace {

constexpr std::int32_t kTexelsASample = 16;
constexpr std::int32_t kMaxTexels = 256;

template <typename Number>
std::vector<Number> random_numbers(std::size_t count, std::uint32_t below) {
  std::mt19937 random(1);
  std::vector<Number> numbers(count);
  for (Number& number : numbers) number = static_cast<Number>(random() % below);
  return numbers;
}

template <auto BuildRow>
void build_indexed_row(benchmark::State& state) {
  const auto count = static_cast<std::int32_t>(state.range(0));
  const auto texels = random_numbers<std::uint8_t>(kMaxTexels + 64, 256);
  const auto colormap = random_numbers<std::uint8_t>(64 * 256, 256);
  // From the darkest row of the colormap to the brightest.
  auto light = random_numbers<std::int16_t>(kMaxTexels / kTexelsASample + 1 + 32, 16256);
  for (std::int16_t& sample : light) sample = static_cast<std::int16_t>(sample + 64);
  std::vector<std::uint8_t> out(kMaxTexels + 64);
  for (auto _ : state) {
    BuildRow({texels.data(), light.data(), colormap.data(), out.data(), count, kTexelsASample});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * count);
}

template <auto BuildRow>
void build_rgb_row(benchmark::State& state) {
  const auto count = static_cast<std::int32_t>(state.range(0));
  auto texels = random_numbers<std::uint32_t>(kMaxTexels + 64, 1u << 24);
  for (std::uint32_t& texel : texels) texel |= 0xff000000u;
  const auto light = random_numbers<std::int16_t>(4 * (kMaxTexels / kTexelsASample + 1) + 32, 32641);
  std::vector<std::uint32_t> out(kMaxTexels + 64);
  for (auto _ : state) {
    BuildRow({texels.data(), light.data(), out.data(), count, kTexelsASample});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * count);
}

template <auto Expand>
void expand_palette(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto indices = random_numbers<std::uint8_t>(count + 64, 256);
  const auto colors = random_numbers<std::uint32_t>(256, 1u << 24);
  std::vector<std::uint32_t> out(count + 64);
  for (auto _ : state) {
    Expand(indices.data(), count, colors.data(), out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}

BENCHMARK(build_indexed_row<render::build_indexed_row_simd>)->Name("build/indexed/vector")->Arg(32)->Arg(256);
BENCHMARK(build_indexed_row<render::build_indexed_row_scalar>)
    ->Name("build/indexed/plain")
    ->Arg(32)
    ->Arg(256);
BENCHMARK(build_rgb_row<render::build_rgb_row_simd>)->Name("build/rgb/vector")->Arg(32)->Arg(256);
BENCHMARK(build_rgb_row<render::build_rgb_row_scalar>)->Name("build/rgb/plain")->Arg(32)->Arg(256);
BENCHMARK(expand_palette<render::expand_palette_simd>)->Name("present/vector")->Arg(1920 * 1080);
BENCHMARK(expand_palette<render::expand_palette_scalar>)->Name("present/plain")->Arg(1920 * 1080);

}  // namespace
}  // namespace temblor::bench
