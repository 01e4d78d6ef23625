#include "render/alias/draw_alias_models.h"

#include <algorithm>

#include "render/alias/fill_alias.h"

namespace temblor::render {

// Placing is cheap, and it discards most invisible instances before jobs are distributed.
std::span<const AliasPlacement> place_alias_models(const Scene& scene, const ViewFrame& view,
                                                   base::Arena& arena) {
  base::ArenaVector<AliasPlacement> placements(arena, scene.alias_models.size() + 1);
  const auto add = [&](const AliasInstance& instance, AliasRole role) {
    if (instance.model == nullptr || !(instance.alpha >= 1)) return;
    if (const auto placement = place_alias(view, instance, role)) placements.push_back(*placement);
  };
  for (const AliasInstance& instance : scene.alias_models) add(instance, AliasRole::kWorld);
  if (scene.view_weapon != nullptr && view.perspective) add(*scene.view_weapon, AliasRole::kViewWeapon);
  return placements.view();
}

// Each job prepares a range of the instances, in an arena that lives until the frame's end.
std::span<PreparedAlias> prepare_placed_models(const FrameContext& context, const ViewFrame& view,
                                               std::span<const AliasPlacement> placements) {
  constexpr std::size_t kJobsPerThread = 4;
  if (placements.empty()) return {};
  const std::span<PreparedAlias> prepared = context.arena().allocate<PreparedAlias>(placements.size());
  const std::size_t threads = static_cast<std::size_t>(context.jobs.threads());
  const std::size_t job_count = std::min(placements.size(), threads > 1 ? threads * kJobsPerThread : 1);
  std::vector<base::Arena>& arenas = context.arenas.models;
  FrameArenas::grow(arenas, job_count);
  context.jobs.parallel_for(job_count, [&](std::size_t job) {
    arenas[job].reset();
    const std::size_t begin = placements.size() * job / job_count;
    const std::size_t end = placements.size() * (job + 1) / job_count;
    for (std::size_t i = begin; i < end; ++i)
      prepared[i] = prepare_alias(context, view, placements[i], arenas[job]);
  });
  return prepared;
}

std::span<const PreparedAlias> prepare_alias_models(const FrameContext& context, const ViewFrame& view) {
  return prepare_placed_models(context, view, place_alias_models(context.scene, view, context.arena()));
}

void draw_alias_models(std::span<const PreparedAlias> models, bool simd_kernels, RowRange rows,
                       FrameBuffer& io_frame) {
  const PixelFormat format = io_frame.format();
  void* const pixels =
      format == PixelFormat::kIndexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data();
  for (const PreparedAlias& alias : models) {
    const TriangleTarget target{pixels,
                                io_frame.depth().data(),
                                io_frame.width(),
                                0,
                                std::max(rows.first, alias.first_row),
                                std::min(rows.end, alias.row_end)};
    if (target.row_begin < target.row_end) fill_alias(alias, format, simd_kernels, target);
  }
}

}  // namespace temblor::render
