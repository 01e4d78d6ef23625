#include "lab/models/deltas/deltas.h"

#include <algorithm>
#include <map>
#include <memory>

#include "lab/models/deltas/walk_painter.h"
#include "lab/models/draw_before_others.h"
#include "lab/models/edges/arena_pool.h"
#include "lab/models/model_jobs.h"
#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"

namespace temblor::lab {

namespace {

// The models of one frame.
class DeltaModels {
 public:
  explicit DeltaModels(bool has_many_seeds) : has_many_seeds_(has_many_seeds) {}

  // Returns the models that the engine draws.
  std::span<const render::PreparedAlias> prepare(const render::FrameContext& context,
                                                 const render::ViewFrame& view) {
    base::Arena& arena = context.arena();
    const auto all = render::place_alias_models(context.scene, view, arena);
    base::ArenaVector<render::AliasPlacement> walked(arena, all.size() + 1);
    base::ArenaVector<render::AliasPlacement> others(arena, all.size() + 1);
    for (const render::AliasPlacement& placement : all)
      (placement.needs_clipping ? others : walked).push_back(placement);
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kSubdivision;  // without a search for front faces
    prepare_walks(context, walked.view(), settings, view);
    settings.alias_raster = render::AliasRaster::kAffine;
    return render::prepare_placed_models(with_settings(context, settings), view, others.view());
  }

  void draw(bool simd_kernels, render::RowRange rows, render::FrameBuffer& io_frame) {
    if (models_.empty()) return;
    base::Arena arena = pool_.take();
    for (std::size_t i = 0; i < models_.size(); ++i) {
      const render::TriangleTarget target = make_model_target(prepared_[i], rows, io_frame);
      if (target.row_begin >= target.row_end) continue;
      RowPainter painter({io_frame.format(), simd_kernels}, target, arena);
      draw_walk(models_[i], target, painter, arena);
      painter.draw();
      arena.reset();
    }
    pool_.give_back(std::move(arena));
  }

 private:
  void prepare_walks(const render::FrameContext& context, std::span<const render::AliasPlacement> placements,
                     const render::Settings& settings, const render::ViewFrame& view) {
    prepared_ = context.arena().allocate<render::PreparedAlias>(placements.size());
    models_ = context.arena().allocate<WalkedModel>(placements.size());
    for (const render::AliasPlacement& placement : placements) find_neighbors(*placement.instance->model);
    const render::FrameContext unsorted = with_settings(context, settings);
    for_each_model(context, placements.size(), arenas_, [&](std::size_t i, base::Arena& io_arena) {
      prepared_[i] = render::prepare_alias(unsorted, view, placements[i], io_arena);
      const MeshNeighbors& neighbors = neighbors_.at(placements[i].instance->model);
      models_[i] = {&prepared_[i].job, &neighbors,
                    walk_visible_side(prepared_[i].job, neighbors, has_many_seeds_, io_arena)};
    });
  }

  void find_neighbors(const render::AliasModel& model) {
    const auto found = neighbors_.find(&model);
    if (found == neighbors_.end())
      neighbors_.emplace(&model, MeshNeighbors(model));
    else if (!found->second.match(model))
      found->second = MeshNeighbors(model);
  }

  const bool has_many_seeds_;
  std::map<const render::AliasModel*, MeshNeighbors> neighbors_;
  std::vector<base::Arena> arenas_;  // by job
  std::span<render::PreparedAlias> prepared_;
  std::span<WalkedModel> models_;
  ArenaPool pool_;
};

}  // namespace

render::FrameStages make_deltas(std::span<const double> values, Counter* counter) {
  return draw_before_others(std::make_shared<DeltaModels>(values[0] == 0), counter);
}

}  // namespace temblor::lab
