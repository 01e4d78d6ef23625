#include "render/alias/draw_alias_models.h"

#include <algorithm>

#include "render/alias/fill_alias.h"

namespace temblor::render {

namespace {

std::span<const AliasPlacement> place_all(const Scene& scene, const ViewFrame& view, base::Arena& arena) {
  base::ArenaVector<AliasPlacement> placements(arena, scene.alias_models.size() + 1);
  const auto add = [&](const AliasInstance& instance, AliasRole role) {
    if (instance.model == nullptr || !(instance.alpha >= 1)) return;
    if (const auto placement = place_alias(view, instance, role)) placements.push_back(*placement);
  };
  for (const AliasInstance& instance : scene.alias_models) add(instance, AliasRole::kWorld);
  if (scene.view_weapon != nullptr && view.perspective) add(*scene.view_weapon, AliasRole::kViewWeapon);
  return placements.view();
}

// In runs of instances, each with an arena of its own.
std::span<const PreparedAlias> prepare_all(const Scene& scene, const Settings& settings,
                                           const ViewFrame& view, std::span<const AliasPlacement> placements,
                                           const ColorTables& tables, PixelFormat format, base::Jobs& jobs,
                                           base::Arena& arena, std::vector<base::Arena>& io_job_arenas) {
  constexpr std::size_t kRunsAThread = 4;
  const std::span<PreparedAlias> prepared = arena.allocate<PreparedAlias>(placements.size());
  const std::size_t threads = static_cast<std::size_t>(jobs.threads());
  const std::size_t runs = std::min(placements.size(), threads > 1 ? threads * kRunsAThread : 1);
  if (io_job_arenas.size() < runs) io_job_arenas.resize(runs);
  jobs.parallel_for(runs, [&](std::size_t run) {
    base::Arena& own = io_job_arenas[run];
    own.reset();
    const std::size_t begin = placements.size() * run / runs, end = placements.size() * (run + 1) / runs;
    for (std::size_t i = begin; i < end; ++i)
      prepared[i] = prepare_alias(scene, settings, view, placements[i], tables, format, own);
  });
  return prepared;
}

}  // namespace

std::span<const PreparedAlias> prepare_alias_models(const Scene& scene, const Settings& settings,
                                                    const ViewFrame& view, const ColorTables& tables,
                                                    PixelFormat format, base::Jobs& jobs, base::Arena& arena,
                                                    std::vector<base::Arena>& io_job_arenas) {
  const std::span<const AliasPlacement> placements = place_all(scene, view, arena);
  if (placements.empty()) return {};
  return prepare_all(scene, settings, view, placements, tables, format, jobs, arena, io_job_arenas);
}

void draw_alias_models(std::span<const PreparedAlias> models, bool vector_kernels, RowRange rows,
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
    if (target.row_begin < target.row_end) fill_alias(alias, format, vector_kernels, target);
  }
}

}  // namespace temblor::render
