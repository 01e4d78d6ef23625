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
#ifdef __x86_64__
constexpr int kNopsAPlacement = 16;
#else
constexpr int kNopsAPlacement = 4;
#endif
constexpr std::uint32_t kStepS = 40000, kStepT = 3000;  // 16.16

template <typename Texel>
using Surface = std::array<Texel, std::size_t{kSide} * kSide>;

template <typename Texel>
constexpr Surface<Texel> make_surface() {
  Surface<Texel> surface{};
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    surface[i] = static_cast<Texel>(0xff000000u | (i * 0x010305u));
  return surface;
}

// The surface is one for all placements.
template <typename Texel>
constexpr Surface<Texel> kSurface = make_surface<Texel>();

template <typename Texel, int kPlacement>
void fill_rows(std::span<Texel> out, std::size_t width) {
  const std::size_t height = out.size() / width;
  for (std::size_t y = 0; y < height; ++y) {
    Texel* row = out.data() + y * width;
    std::uint32_t s = 0, t = static_cast<std::uint32_t>(y) << 16;
    // Executed once a row: the start of a cache line of code, and then 16 bytes a placement.
    __asm__ __volatile__(".p2align 6\n.rept %c0\nnop\n.endr" : : "i"(kPlacement * kNopsAPlacement));
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
constexpr std::array<Fill, kFloorPlacements> kFills = {fill<0>, fill<1>, fill<2>, fill<3>};

}  // namespace

void fill_with_floor_loop(int placement, render::FrameBuffer& io_frame) {
  kFills[static_cast<std::size_t>(placement)](io_frame);
}

int quickest_floor_placement(render::FrameBuffer& io_frame) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 9;
  std::array<Clock::duration, kFloorPlacements> least;
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
