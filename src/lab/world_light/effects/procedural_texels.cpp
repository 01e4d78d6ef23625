#include "lab/world_light/effects/procedural_texels.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "lab/world_light/effects/change_block.h"
#include "lab/world_light/rebuilt_blocks.h"

namespace temblor::lab {

namespace {

// The colors of a pattern, for the palette of the last frame.
class PatternCache {
 public:
  explicit PatternCache(PatternKind kind) : kind_(kind) {}

  const PatternColors& find(const render::ColorTables& tables) {
    if (!colors_ || palette_ != tables.palette) {
      palette_ = tables.palette;
      colors_ = make_pattern_colors(kind_, tables);
    }
    return *colors_;
  }

 private:
  const PatternKind kind_;
  formats::Palette palette_{};
  std::optional<PatternColors> colors_;
};

// Interleaved, like render::build_surfaces.
void change_blocks(const render::FrameContext& context, const TexelPattern& pattern,
                   std::span<const render::BlockRequest> built) {
  constexpr std::size_t kJobsPerThread = 8;
  const std::size_t jobs =
      std::min(built.size(), static_cast<std::size_t>(context.jobs.threads()) * kJobsPerThread);
  std::vector<base::Arena>& scratch = context.arenas.scratch;
  render::FrameArenas::grow(scratch, jobs);
  context.jobs.parallel_for(jobs, [&](std::size_t job) {
    for (std::size_t i = job; i < built.size(); i += jobs)
      change_block(context, pattern, built[i], scratch[job]);
  });
}

}  // namespace

render::FrameStages make_procedural_texels(std::span<const double> values, Counter* /*counter*/) {
  const auto kind = static_cast<PatternKind>(values[0]);
  const auto every = static_cast<std::uint32_t>(values[1]);
  const PatternStyle& style = find_style(kind);
  render::FrameStages stages;
  if (style.moves)
    stages.reserve_surfaces = [every, turn = std::uint32_t{0}](const render::FrameContext& context,
                                                               const render::SurfaceRequests& requests,
                                                               render::SurfaceCache& io_cache) mutable {
      const render::SurfaceBlocks blocks = render::reserve_surfaces(context, requests, io_cache);
      return add_rebuilt_blocks(context, requests, blocks, ++turn, every);
    };
  stages.build_surfaces = [&style, cache = std::make_shared<PatternCache>(kind)](
                              const render::FrameContext& context, const render::SurfaceBlocks& blocks,
                              const render::MarkTables* mark_tables) {
    render::build_surfaces(context, blocks, mark_tables);
    change_blocks(context, {style, cache->find(context.colors), context.scene.time_s}, blocks.missing);
  };
  return stages;
}

}  // namespace temblor::lab
