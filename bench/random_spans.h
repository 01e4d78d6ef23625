// Makes spans like those of a frame for benchmarks. Their lengths vary at random, so that a branch predictor
// cannot learn them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "render/spans/span_kernels.h"

namespace temblor::bench {

constexpr std::uint16_t kScreenWidth = 1920, kScreenHeight = 1080;

// Makes spans of 0.5 to 1.5 times `mean_length` pixels anywhere on the screen. Their total is `pixels` or
// slightly more.
inline std::vector<render::Span> random_spans(int mean_length, std::size_t pixels) {
  std::mt19937 random(1);
  std::vector<render::Span> spans;
  for (std::size_t total = 0; total < pixels; total += spans.back().count) {
    const auto count = static_cast<std::uint16_t>(
        mean_length / 2 + static_cast<int>(random() % static_cast<unsigned>(mean_length + 1)));
    spans.push_back({static_cast<std::uint16_t>(random() % static_cast<unsigned>(kScreenWidth - count)),
                     static_cast<std::uint16_t>(random() % kScreenHeight),
                     count > 0 ? count : std::uint16_t{1}});
  }
  return spans;
}

inline std::size_t list_pixels(const std::vector<render::Span>& spans) {
  std::size_t pixels = 0;
  for (const render::Span& span : spans) pixels += span.count;
  return pixels;
}

}  // namespace temblor::bench
