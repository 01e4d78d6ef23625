#include "lab/models/flood_fill.h"

#include <algorithm>
#include <map>
#include <memory>

#include "lab/models/draw_before_others.h"
#include "lab/models/flood/flooded_picture.h"
#include "lab/models/prepare_with_settings.h"
#include "lab/models/sprite_kernels.h"

namespace temblor::lab {

namespace {

bool can_be_flooded(const render::FrameContext& context, const render::ViewFrame& view,
                    const render::AliasPlacement& placement) {
  if (placement.instance == context.scene.view_weapon || placement.needs_clipping || !view.perspective)
    return false;
  const math::Bounds& bounds = render::model_bounds(*placement.instance->model);
  const double size_px = glm::length(math::Vec3d(bounds.maxs - bounds.mins)) *
                         double{placement.instance->scale} * placement.largest_pixels_per_unit;
  return size_px < std::max(view.width, view.height);
}

// The models of one frame. Memory is kept for the next one.
class FloodedModels {
 public:
  // Returns the models that are drawn as triangles.
  std::span<const render::PreparedAlias> prepare(const render::FrameContext& context,
                                                 const render::ViewFrame& view) {
    base::Arena& arena = context.arena();
    const auto all = render::place_alias_models(context.scene, view, arena);
    base::ArenaVector<render::AliasPlacement> flooded(arena, all.size() + 1), others(arena, all.size() + 1);
    for (const render::AliasPlacement& placement : all)
      (can_be_flooded(context, view, placement) ? flooded : others).push_back(placement);
    flood(context, view, flooded.view());
    return render::prepare_placed_models(context, view, others.view());
  }

  // One thread or several, for different rows.
  void draw(bool simd_kernels, render::RowRange rows, render::FrameBuffer& io_frame) const {
    for (const FloodedPicture& picture : pictures_) draw_picture(picture, simd_kernels, rows, io_frame);
  }

  std::size_t used_bytes() const {
    std::size_t bytes = 0;
    for (const base::Arena& arena : arenas_) bytes += arena.used_bytes();
    return bytes;
  }

 private:
  void flood(const render::FrameContext& context, const render::ViewFrame& view,
             std::span<const render::AliasPlacement> placements) {
    // By subdivision, the engine does not look for front faces: here, those without pixels count too.
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kSubdivision;
    const render::FrameContext unsorted = with_settings(context, settings);
    constexpr std::size_t kJobsPerThread = 4;
    const std::size_t jobs =
        std::min(placements.size(), static_cast<std::size_t>(context.jobs.threads()) * kJobsPerThread);
    pictures_ = context.arena().allocate<FloodedPicture>(placements.size());
    for (const render::AliasPlacement& placement : placements) find_edges(*placement.instance->model);
    render::FrameArenas::grow(arenas_, 2 * jobs);
    for (base::Arena& arena : arenas_) arena.reset();
    context.jobs.parallel_for(jobs, [&](std::size_t job) {
      const std::size_t end = placements.size() * (job + 1) / jobs;
      for (std::size_t i = placements.size() * job / jobs; i < end; ++i) {
        base::Arena &pictures = arenas_[2 * job], &scratch = arenas_[2 * job + 1];
        scratch.reset();
        const render::PreparedAlias alias = render::prepare_alias(unsorted, view, placements[i], scratch);
        const MeshEdges& edges = edges_.at(placements[i].instance->model);
        pictures_[i] = flood_model(alias.job, edges, context.format, pictures, scratch);
      }
    });
  }

  // Another model may have the address of one from before.
  void find_edges(const render::AliasModel& model) {
    const auto found = edges_.find(&model);
    if (found == edges_.end())
      edges_.emplace(&model, MeshEdges(model.triangles));
    else if (!found->second.match(model.triangles))
      found->second = MeshEdges(model.triangles);
  }

  static void draw_picture(const FloodedPicture& picture, bool simd_kernels, render::RowRange rows,
                           render::FrameBuffer& io_frame) {
    const int first_x = std::max(picture.left, 0);
    const int end_x = std::min(picture.left + picture.width, io_frame.width());
    const int first_y = std::max(picture.top, rows.first);
    const int end_y = std::min(picture.top + picture.height, rows.end);
    if (first_x >= end_x || first_y >= end_y) return;
    const std::int64_t from = (first_y - picture.top) * picture.stride + (first_x - picture.left);
    const std::int64_t to = std::int64_t{first_y} * io_frame.width() + first_x;
    SpriteRows job{};
    job.depth = picture.depth + from;
    job.depth_scale = 1;
    job.out_depth = io_frame.depth().data() + to;
    job.stride = picture.stride;
    job.out_stride = io_frame.width();
    job.width = end_x - first_x;
    job.height = end_y - first_y;
    if (io_frame.format() == render::PixelFormat::kIndexed) {
      job.pixels = static_cast<const std::uint8_t*>(picture.pixels) + from;
      job.out_pixels = io_frame.indexed().data() + to;
      simd_kernels ? draw_sprite_u8_simd(job) : draw_sprite_u8_scalar(job);
    } else {
      job.pixels = static_cast<const std::uint32_t*>(picture.pixels) + from;
      job.out_pixels = io_frame.rgb().data() + to;
      simd_kernels ? draw_sprite_u32_simd(job) : draw_sprite_u32_scalar(job);
    }
  }

  std::vector<base::Arena> arenas_;  // two for each job: pictures, and temporary memory
  std::map<const render::AliasModel*, MeshEdges> edges_;
  std::span<FloodedPicture> pictures_;
};

}  // namespace

render::FrameStages make_flood_fill(std::span<const double> /*values*/, Counter* counter) {
  return draw_before_others(std::make_shared<FloodedModels>(), counter);
}

}  // namespace temblor::lab
