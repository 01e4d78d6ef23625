// Spans as a frame has them, for benchmarks: varied, so that no branch predictor learns them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "render/spans/span_kernels.h"

namespace temblor::bench {

constexpr std::uint16_t kScreenWidth = 1920, kScreenHeight = 1080;

// Spans of half to one and a half times `mean_length` pixels, anywhere on the screen, `pixels` or a little
// more in all.
inline std::vector<render::SpanRun> random_runs(int mean_length, std::size_t pixels) {
  std::mt19937 random(1);
  std::vector<render::SpanRun> runs;
  for (std::size_t total = 0; total < pixels; total += runs.back().count) {
    const auto count = static_cast<std::uint16_t>(
        mean_length / 2 + static_cast<int>(random() % static_cast<unsigned>(mean_length + 1)));
    runs.push_back({static_cast<std::uint16_t>(random() % static_cast<unsigned>(kScreenWidth - count)),
                    static_cast<std::uint16_t>(random() % kScreenHeight),
                    count > 0 ? count : std::uint16_t{1}});
  }
  return runs;
}

inline std::size_t pixels_of(const std::vector<render::SpanRun>& runs) {
  std::size_t pixels = 0;
  for (const render::SpanRun& run : runs) pixels += run.count;
  return pixels;
}

}  // namespace temblor::bench
