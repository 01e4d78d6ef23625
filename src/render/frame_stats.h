// Statistics of a frame: the time of each stage, and counts. `temblor bench` and the console variable
// r_speeds print them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace temblor::render {

// In the order in which a frame passes through them. docs/architecture.md describes each one.
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

// Both arrays are indexed by Stage. Cycles are ticks of the processor's time-stamp counter, 0 where it has
// none.
struct StageTimes {
  std::array<double, kStages> ms{};
  std::array<double, kStages> cycles{};

  StageTimes& operator+=(const StageTimes& other) {
    for (std::size_t i = 0; i < kStages; ++i) {
      ms[i] += other.ms[i];
      cycles[i] += other.cycles[i];
    }
    return *this;
  }
};

struct FrameStats {
  std::uint32_t faces_in_pvs = 0;  // faces in the leaves that are visible from the eye's leaf
  std::uint32_t faces_drawn = 0;   // surfaces in the edge table
  std::uint32_t faces_seen = 0;    // faces with at least one span
  std::uint32_t edges = 0;         // in the edge table
  std::uint32_t spans = 0;         // in the span table
  // Different surface blocks that the spans read from.
  std::uint32_t surfaces = 0;
  std::uint32_t cache_hits = 0;    // blocks found in the surface cache
  std::uint32_t cache_misses = 0;  // blocks not found there
  std::uint32_t surfaces_built = 0;
  std::uint64_t texels_built = 0;  // in the blocks built in this frame
  std::uint64_t texels_read = 0;   // in all blocks that the spans read from
  std::uint64_t cache_bytes = 0;   // in use in the surface cache after the frame
  std::uint32_t cache_evictions = 0;
  // Blocks built outside the cache because the blocks of this frame used up its budget.
  std::uint32_t over_budget = 0;
  std::uint32_t bands = 0;
  std::uint32_t models = 0;     // alias models that may be on the screen
  std::uint32_t triangles = 0;  // of those models, before back faces are removed
  std::uint32_t particles = 0;  // in the scene
  // The stages from kSpans to kScreen take turns in every band, on several threads. Each gets its share of
  // the elapsed time, in proportion to its time summed over all bands.
  StageTimes stages;
};

}  // namespace temblor::render
