// A technique of the laboratory: another way to draw that Abrash's articles describe or weigh, as functions
// that replace stages of the engine's frame. It draws the same scenes as the engine, so that pictures and
// costs can be compared.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "render/frame/frame_stages.h"

namespace temblor::lab {

// A number that changes how a technique works. Switches are 0 or 1. Whole bounds allow whole numbers only.
struct Parameter {
  std::string_view name;
  double value;  // the default
  double min, max;
  std::string_view meaning;
};

// Work that a technique does in a frame, beyond what render::FrameStats counts.
struct Counts {
  std::uint64_t spans_sorted = 0;   // spans that were put in order, or clipped against others
  std::uint64_t comparisons = 0;    // which of two surfaces is nearer, or on which side of a line one is
  std::uint64_t cache_hits = 0;     // comparisons with a result from before
  std::uint64_t splits = 0;         // parts of faces or spans that were cut in two
  std::uint64_t pixels_tested = 0;  // depth tests of single pixels
  std::uint64_t bytes = 0;          // memory that the engine does not need
  std::uint64_t edges_saved = 0;    // edges that need not be sorted
  std::uint64_t planes_tested = 0;  // of nodes and faces, against the eye
  std::uint64_t portals_clipped = 0, leaves_reached = 0;
  std::uint64_t rays = 0;  // from pixels to lights
  // Pixels that show another texel than the exact one, and the largest distance between the two along s or t.
  std::uint64_t pixels_off = 0;
  double max_texel_error = 0;
  // Models drawn from a stack of vertices: those that are sent to it, of so many, and simulated cache misses
  // of a list of vertices and of the stack, with the caches of cache_simulator.h.
  std::uint64_t vertices = 0, vertex_loads = 0, model_triangles = 0;
  std::uint64_t list_misses = 0, stack_misses = 0, list_misses_today = 0, stack_misses_today = 0;

  Counts& operator+=(const Counts& other);
};

// The counts of a frame. Several threads may add to it.
class Counter {
 public:
  void add(const Counts& counts) {
    const std::lock_guard lock(mutex_);
    sum_ += counts;
  }
  // The sum since the last call.
  Counts take();

 private:
  std::mutex mutex_;
  Counts sum_;
};

struct Technique {
  std::string_view name;              // as on the command line
  std::string_view title;             // for people
  std::string_view summary;           // one sentence
  std::string_view article, heading;  // of the paragraph that describes it
  std::string_view replaces;          // stage of the engine
  std::string_view expected;          // the result that the article leads us to expect
  // The share of pixels that may show a wrong face. 0: only pixels next to an edge may.
  double max_wrong_share;
  std::span<const Parameter> parameters;
  // The stages, with a value for each parameter. They share state between stages of one frame, so they must
  // not draw two frames at once. `counter` may be null: then the technique counts nothing, which is faster.
  // It must outlive the stages.
  render::FrameStages (*make_stages)(std::span<const double> values, Counter* counter);
  // Fails if the technique cannot draw the level, with one line for people. Null: it draws every level. The
  // stages may be used anyway; then they draw like the engine.
  base::Status (*check_level)(std::span<const double> values, const world::Level& level) = nullptr;
  // It draws alias models, so it needs a scene that has some.
  bool draws_models = false;
  // Its surfaces show other texels than those of their textures.
  bool changes_texels = false;
  // Like check_level, for a scene. Null: it draws every scene.
  base::Status (*check_scene)(std::span<const double> values, const render::Scene& scene) = nullptr;
};

// A technique and the values of its parameters.
struct Choice {
  const Technique* technique = nullptr;
  std::vector<double> values;

  render::FrameStages make_stages(Counter* counter = nullptr) const {
    return technique->make_stages(values, counter);
  }
  // Whether the technique can draw the level.
  base::Status check_level(const world::Level& level) const {
    return technique->check_level != nullptr ? technique->check_level(values, level) : base::Ok{};
  }
  // The same for a scene.
  base::Status check_scene(const render::Scene& scene) const {
    return technique->check_scene != nullptr ? technique->check_scene(values, scene) : base::Ok{};
  }
  // The name and the parameters that are not at their default, in the form of the command line.
  std::string label() const;
};

}  // namespace temblor::lab
