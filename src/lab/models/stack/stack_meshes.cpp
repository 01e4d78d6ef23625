#include "lab/models/stack/stack_meshes.h"

#include <algorithm>
#include <map>
#include <memory>

#include "lab/models/draw_before_others.h"
#include "lab/models/edges/arena_pool.h"
#include "lab/models/model_jobs.h"
#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"
#include "lab/models/stack/cache_misses.h"
#include "lab/models/stack/stack_painter.h"

namespace temblor::lab {

namespace {

// In more bands, it is faster to find the bands of each group first.
constexpr int kFewBands = 2;

// The models of one frame.
class StackModels {
 public:
  StackModels(std::size_t places, std::size_t group, Counter* counter)
      : sizes_{places, std::max<std::size_t>((group + 15) / 16 * 16, 16)},
        is_grouped_(group > 0),
        counter_(counter) {}

  // Returns the models that the engine draws.
  std::span<const render::PreparedAlias> prepare(const render::FrameContext& context,
                                                 const render::ViewFrame& view) {
    base::Arena& arena = context.arena();
    const auto all = render::place_alias_models(context.scene, view, arena);
    base::ArenaVector<render::AliasPlacement> stacked(arena, all.size() + 1), others(arena, all.size() + 1);
    for (const render::AliasPlacement& placement : all)
      (placement.needs_clipping ? others : stacked).push_back(placement);
    prepare_instances(context, view, stacked.view());
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kAffine;
    return render::prepare_placed_models(with_settings(context, settings), view, others.view());
  }

  void draw(bool simd_kernels, render::RowRange rows, render::FrameBuffer& io_frame) {
    if (instances_.empty()) return;
    const StackKernels kernels{io_frame.format(), simd_kernels};
    base::Arena arena = pool_.take();
    for (const StackInstance& instance : instances_) {
      const render::TriangleTarget target = make_target(instance, rows, io_frame);
      if (target.row_begin >= target.row_end) continue;
      if (is_grouped_) {
        draw_groups(instance, kernels, target);
      } else {
        draw_commands(instance, kernels, target, arena);
        arena.reset();
      }
    }
    pool_.give_back(std::move(arena));
  }

 private:
  struct Mesh {
    std::unique_ptr<const StackMesh> stacked;
    Counts counts;  // of each instance
    std::uint64_t checked_frame = 0;
  };

  void prepare_instances(const render::FrameContext& context, const render::ViewFrame& view,
                         std::span<const render::AliasPlacement> placements) {
    instances_ = context.arena().allocate<StackInstance>(placements.size());
    ++frame_;
    for (std::size_t i = 0; i < placements.size(); ++i) {
      const Mesh& mesh = find_mesh(*placements[i].instance->model);
      instances_[i].mesh = mesh.stacked.get();
      if (counter_ != nullptr) counter_->add(mesh.counts);
    }
    if (counter_ != nullptr) counter_->add({.bytes = used_bytes()});
    for_each_model(context, placements.size(), arenas_, [&](std::size_t i, base::Arena& io_arena) {
      instances_[i] = prepare_instance(context, view, placements[i], *instances_[i].mesh, io_arena);
    });
  }

  std::size_t used_bytes() const {
    std::size_t bytes = 0;
    for (const auto& [model, mesh] : meshes_) bytes += mesh.stacked->size_bytes();
    return bytes;
  }

  const Mesh& find_mesh(const render::AliasModel& model) {
    Mesh& io_mesh = meshes_[&model];
    if (io_mesh.checked_frame == frame_) return io_mesh;
    io_mesh.checked_frame = frame_;
    if (io_mesh.stacked != nullptr && io_mesh.stacked->match(model)) return io_mesh;
    io_mesh.stacked = std::make_unique<const StackMesh>(model, sizes_);
    if (counter_ != nullptr) io_mesh.counts = count_vertex_work(model, *io_mesh.stacked);
    return io_mesh;
  }

  StackInstance prepare_instance(const render::FrameContext& context, const render::ViewFrame& view,
                                 const render::AliasPlacement& placement, const StackMesh& mesh,
                                 base::Arena& io_arena) const {
    const render::AliasInstance& model = *placement.instance;
    const render::AliasLight light = render::choose_light(context, model);
    const std::span<render::NormalLights> lights = io_arena.allocate<render::NormalLights>(1);
    lights[0] = render::light_normals(light, placement, context.format);
    StackInstance instance{};
    instance.mesh = &mesh;
    instance.first_row = placement.first_row;
    instance.row_end = placement.row_end;
    instance.skin = render::make_skin_job(context, placement, light, io_arena);
    const auto set = [](const auto& pose, auto& out) {
      out[0] = pose.x;
      out[1] = pose.y;
      out[2] = pose.z;
      out[3] = pose.normals;
    };
    const auto set_poses = [&](const auto& from, const auto& to, auto& out) {
      set(from, out.from);
      set(to, out.to);
      out.lights = lights[0].data();
    };
    if (model.model->is_wide()) {
      instance.wide_transform = render::make_pose_job<std::uint16_t>(context, view, placement);
      set_poses(mesh.wide_pose(model.from_pose), mesh.wide_pose(model.to_pose), instance.wide_transform);
    } else {
      instance.transform = render::make_pose_job<std::uint8_t>(context, view, placement);
      set_poses(mesh.pose(model.from_pose), mesh.pose(model.to_pose), instance.transform);
    }
    const int rows = instance.row_end - instance.first_row;
    if (is_grouped_ && rows > kFewBands * context.settings.band_rows)
      instance.group_rows = find_group_rows(instance, context.settings.simd_kernels, io_arena);
    return instance;
  }

  static render::TriangleTarget make_target(const StackInstance& instance, render::RowRange rows,
                                            render::FrameBuffer& io_frame) {
    render::PreparedAlias part{};
    part.first_row = instance.first_row;
    part.row_end = instance.row_end;
    return make_model_target(part, rows, io_frame);
  }

  const StackSizes sizes_;
  const bool is_grouped_;
  Counter* const counter_;
  std::map<const render::AliasModel*, Mesh> meshes_;
  std::uint64_t frame_ = 0;
  std::vector<base::Arena> arenas_;  // by job
  std::span<StackInstance> instances_;
  ArenaPool pool_;
};

}  // namespace

render::FrameStages make_stack_meshes(std::span<const double> values, Counter* counter) {
  const auto places = static_cast<std::size_t>(values[0]), group = static_cast<std::size_t>(values[1]);
  return draw_before_others(std::make_shared<StackModels>(places, group, counter), nullptr);
}

}  // namespace temblor::lab
