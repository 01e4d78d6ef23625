// Where a frame is drawn to, and what drawing it took.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/large_memory.h"
#include "formats/images/palette.h"

namespace temblor::render {

enum class PixelFormat { kIndexed, kRgb };

// 0xffRRGGBB.
constexpr std::uint32_t to_rgb(formats::Rgb color) {
  return 0xff000000u | static_cast<std::uint32_t>(color.r) << 16 | static_cast<std::uint32_t>(color.g) << 8 |
         color.b;
}

// Pixels and depth of one picture. Rows follow one another, `width` elements each.
class FrameBuffer {
 public:
  FrameBuffer() = default;
  FrameBuffer(int width, int height, PixelFormat format);

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat format() const { return format_; }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  // kIndexed: palette indices. kRgb: 0xffRRGGBB. The other one is empty.
  std::span<std::uint8_t> indexed() {
    return {indexed_.get(), format_ == PixelFormat::kIndexed ? pixel_count() : 0};
  }
  std::span<std::uint32_t> rgb() { return {rgb_.get(), format_ == PixelFormat::kRgb ? pixel_count() : 0}; }
  std::span<const std::uint8_t> indexed() const { return const_cast<FrameBuffer*>(this)->indexed(); }
  std::span<const std::uint32_t> rgb() const { return const_cast<FrameBuffer*>(this)->rgb(); }
  // Puts other memory, for pixel_count() pixels, in the place of theirs, which is handed out: a stage that
  // moves pixels about writes them there first. Spans taken before go with it.
  void exchange(base::LargeMemory<std::uint8_t>& io_indexed) { indexed_.swap(io_indexed); }
  void exchange(base::LargeMemory<std::uint32_t>& io_rgb) { rgb_.swap(io_rgb); }
  // Perspective: 1/z in 1/units, larger is nearer. Orthographic: minus the distance along the view, linear.
  // Pixels that show the background have the smallest float.
  std::span<float> depth() { return {depth_.get(), pixel_count()}; }
  std::span<const float> depth() const { return const_cast<FrameBuffer*>(this)->depth(); }

 private:
  int width_ = 0, height_ = 0;
  PixelFormat format_ = PixelFormat::kIndexed;
  base::LargeMemory<std::uint8_t> indexed_;
  base::LargeMemory<std::uint32_t> rgb_;
  base::LargeMemory<float> depth_;
};

// Rows of a frame, `end` without.
struct RowRange {
  int first = 0, end = 0;
};

enum class Stage {
  kView,
  kVisibility,
  kEdges,
  kScan,
  kSurfaces,
  kSpans,
  kModels,
  kSprites,
  kParticles,
  kTranslucent,
  kScreen,
  kOverlay
};
constexpr std::size_t kStages = 12;
constexpr std::array<const char*, kStages> kStageNames = {"view",      "visibility",  "edges",  "scan",
                                                          "surfaces",  "spans",       "models", "sprites",
                                                          "particles", "translucent", "screen", "overlay"};

struct StageTimes {
  std::array<double, kStages> ms{};
  std::array<double, kStages> cycles{};  // time-stamp counter ticks

  StageTimes& operator+=(const StageTimes& other) {
    for (std::size_t i = 0; i < kStages; ++i) {
      ms[i] += other.ms[i];
      cycles[i] += other.cycles[i];
    }
    return *this;
  }
};

struct FrameStats {
  std::uint32_t faces_in_pvs = 0;  // faces of the leaves that the eye's leaf can see
  std::uint32_t faces_drawn = 0;   // entered in the edge list
  std::uint32_t faces_seen = 0;    // got a span
  std::uint32_t edges = 0;         // in the edge table
  std::uint32_t spans = 0;
  std::uint32_t surfaces = 0;  // blocks the spans read from
  std::uint32_t cache_hits = 0, cache_misses = 0;
  std::uint32_t surfaces_built = 0;  // misses and rebuilds of stale ones
  std::uint64_t texels_built = 0;
  std::uint64_t texels_read = 0;  // texels of the blocks that this frame's spans read from
  std::uint64_t cache_bytes = 0;  // in use after the frame
  std::uint32_t cache_evictions = 0;
  std::uint32_t over_budget =
      0;  // surfaces built beside the cache because this frame's did not fit the budget
  std::uint32_t bands = 0;
  std::uint32_t models = 0;     // alias models that may be on the screen
  std::uint32_t triangles = 0;  // theirs
  std::uint32_t particles = 0;  // in the scene
  // Of stages that take turns within a band (spans to fog): each one's part of the time of all bands.
  StageTimes stages;
};

}  // namespace temblor::render
