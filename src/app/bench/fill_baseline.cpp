#include "app/bench/fill_baseline.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::app {
namespace {

constexpr std::uint32_t kSide = 256;
// How many nop instructions have 16 bytes: they are 1 byte long on x86-64, 4 bytes on ARM.
#ifdef __x86_64__
constexpr int kNopsPerPlacement = 16;
#else
constexpr int kNopsPerPlacement = 4;
#endif
// Steps per pixel in 16.16 fixed point: about 0.61 and 0.05 texels.
constexpr std::uint32_t kStepS = 40000, kStepT = 3000;

template <typename Texel>
using Surface = std::array<Texel, std::size_t{kSide} * kSide>;

// Fills the surface with a pattern, so that reads cannot be optimized away.
template <typename Texel>
constexpr Surface<Texel> make_surface() {
  Surface<Texel> surface{};
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    surface[i] = static_cast<Texel>(0xff000000u | (i * 0x010305u));
  return surface;
}

// Shared by all placements, so that they differ only in the alignment of code.
template <typename Texel>
constexpr Surface<Texel> kSurface = make_surface<Texel>();

template <typename Texel, int kPlacement>
void fill_rows(std::span<Texel> out, std::size_t width) {
  const std::size_t height = out.size() / width;
  for (std::size_t y = 0; y < height; ++y) {
    Texel* row = out.data() + y * width;
    std::uint32_t s = 0, t = static_cast<std::uint32_t>(y) << 16;
    // Aligns the loop to a cache line of code plus 16 bytes per placement. Runs once per row, so its cost
    // does not count.
    __asm__ __volatile__(".p2align 6\n.rept %c0\nnop\n.endr" : : "i"(kPlacement * kNopsPerPlacement));
    for (std::size_t x = 0; x < width; ++x) {
      row[x] = kSurface<Texel>[((t >> 16) & (kSide - 1)) * kSide + ((s >> 16) & (kSide - 1))];
      s += kStepS;
      t += kStepT;
    }
  }
}

template <int kPlacement>
void fill(render::FrameBuffer& io_frame) {
  const auto width = static_cast<std::size_t>(io_frame.width());
  if (io_frame.format() == render::PixelFormat::kIndexed)
    fill_rows<std::uint8_t, kPlacement>(io_frame.indexed(), width);
  else
    fill_rows<std::uint32_t, kPlacement>(io_frame.rgb(), width);
}

using Fill = void (*)(render::FrameBuffer&);
constexpr std::array<Fill, kBaselinePlacements> kFills = {fill<0>, fill<1>, fill<2>, fill<3>};

}  // namespace

void run_fill_baseline(int placement, render::FrameBuffer& io_frame) {
  kFills[static_cast<std::size_t>(placement)](io_frame);
}

// Keeps the least time of several rounds, which interrupts of the operating system disturb least.
int find_fastest_placement(render::FrameBuffer& io_frame) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 9;
  std::array<Clock::duration, kBaselinePlacements> least;
  least.fill(Clock::duration::max());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t placement = 0; placement < least.size(); ++placement) {
      const Clock::time_point start = Clock::now();
      kFills[placement](io_frame);
      least[placement] = std::min(least[placement], Clock::now() - start);
    }
  }
  return static_cast<int>(std::min_element(least.begin(), least.end()) - least.begin());
}

}  // namespace temblor::app
