// Data that all stages of one frame share. It keeps parameter lists short: a stage's other parameters are the
// results of earlier stages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/settings.h"

namespace temblor::render {

// The memory of a frame. A stage's results live until the next frame. Arenas are reset but keep their memory,
// so a warm renderer draws frames without allocating. The vectors grow to the number of jobs; job i uses
// element i and resets it, so threads never share an arena.
struct FrameArenas {
  // Results of stages, allocated by the thread that runs the stage.
  base::Arena frame;
  // Outlines and edges, by job of emit_edges.
  std::vector<base::Arena> edges;
  // Spans, by band.
  std::vector<base::Arena> bands;
  // Projected alias models, by job of prepare_alias_models.
  std::vector<base::Arena> models;
  // Temporary memory, by job of any stage; free again when the job ends.
  std::vector<base::Arena> scratch;

  // The decompressed PVS row of the eye's leaf, one bit per leaf.
  std::vector<std::uint8_t> pvs_row;

  // Makes room for `count` jobs. Must be called before the jobs start, since it may move the arenas.
  static void grow(std::vector<base::Arena>& io_arenas, std::size_t count) {
    if (io_arenas.size() < count) io_arenas.resize(count);
  }
};

// Holds references only; everything that it refers to outlives the frame.
struct FrameContext {
  const Scene& scene;        // `level` is set
  const Settings& settings;  // resolved: every value is valid
  PixelFormat format;
  const ColorTables& colors;
  base::Jobs& jobs;
  FrameArenas& arenas;

  const world::Level& level() const { return *scene.level; }
  base::Arena& arena() const { return arenas.frame; }
  bool is_indexed() const { return format == PixelFormat::kIndexed; }
};

}  // namespace temblor::render
