#include "render/alias/prepare_alias.h"

#include <algorithm>
#include <array>

#include "render/alias/clip_triangles.h"

namespace temblor::render {

namespace {

// With vertices rounded to whole pixels, as in stock Quake, moving models wobble.
std::int32_t steps_per_pixel(const Settings& settings) {
  return settings.alias_snap ? 1 : kSubpixels;
}

// Where the kernels write.
struct VertexOutput {
  std::span<ScreenVertex> vertices;
  std::array<std::span<float>, 3> view;  // empty: not needed
};

// Blends and projects the vertices of two poses.
template <typename Element>
void project_poses(const FrameContext& context, const ViewFrame& view, const AliasPlacement& placement,
                   const std::array<PoseRows<Element>, 2>& poses, const NormalLights& lights,
                   const VertexOutput& output) {
  PoseJob<Element> job = make_pose_job<Element>(context, view, placement);
  const auto set = [](const PoseRows<Element>& pose, const Element*(&out)[4]) {
    out[0] = pose.x;
    out[1] = pose.y;
    out[2] = pose.z;
    out[3] = pose.normals;
  };
  set(poses[0], job.from);
  set(poses[1], job.to);
  job.count = placement.instance->model->vertices_per_row;
  job.lights = lights.data();
  job.out = output.vertices.data();
  for (std::size_t axis = 0; axis < 3; ++axis)
    job.view[axis] = output.view[axis].empty() ? nullptr : output.view[axis].data();
  context.settings.simd_kernels ? project_vertices_simd(job) : project_vertices_scalar(job);
}

// The mean length of the triangles' sides on the screen, at most.
double compute_side_px(const AliasPlacement& placement) {
  const double units = double{placement.instance->model->mean_side} * placement.instance->scale;
  return units * placement.largest_pixels_per_unit;
}

// Subdivision does not clip, so the whole box must be inside the picture.
bool chooses_subdivision(const Settings& settings, const AliasPlacement& placement) {
  if (!placement.inside_screen || settings.alias_raster == AliasRaster::kAffine) return false;
  if (settings.alias_raster == AliasRaster::kSubdivision) return true;
  return compute_side_px(placement) < kSubdivisionSidePx;
}

// Rows of such triangles have about two pixels. Found by measuring (docs/decisions/alias-triangles.md).
constexpr double kShortRowsSidePx = 5;

}  // namespace

AliasLight choose_light(const FrameContext& context, const AliasInstance& instance) {
  const Settings& settings = context.settings;
  if (settings.light_view == LightView::kFullBright) return {.full_bright = true};
  return light_alias(context.scene, instance, context.format, settings.colored_light);
}

template <typename Element>
PoseJob<Element> make_pose_job(const FrameContext& context, const ViewFrame& view,
                               const AliasPlacement& placement) {
  const float blend = placement.instance->blend;
  PoseJob<Element> job{};
  job.blend = blend > 0 ? std::min(blend, 1.0f) : 0.0f;
  std::copy_n(&placement.to_view[0][0], 12, &job.to_view[0][0]);
  job.center_x = static_cast<float>(view.center_x);
  job.center_y = static_cast<float>(view.center_y);
  job.pixels_per_unit = placement.pixels_per_unit;
  job.perspective = placement.perspective;
  job.near_z = placement.near_z;
  job.depth_scale = placement.depth_scale;
  job.steps_per_pixel = steps_per_pixel(context.settings);
  return job;
}

template VertexJob make_pose_job(const FrameContext& context, const ViewFrame& view,
                                 const AliasPlacement& placement);
template WideVertexJob make_pose_job(const FrameContext& context, const ViewFrame& view,
                                     const AliasPlacement& placement);

TriangleJob make_skin_job(const FrameContext& context, const AliasPlacement& placement,
                          const AliasLight& light, base::Arena& arena) {
  const AliasInstance& instance = *placement.instance;
  const AliasModel& model = *instance.model;
  TriangleJob job{};
  job.skin = model.skin_picture(instance.skin);
  job.skin_width = static_cast<std::int32_t>(model.skin_width);
  job.skin_height = static_cast<std::int32_t>(model.skin_height);
  job.colors = instance_colors(context.colors, instance, light, context.format, arena);
  for (int channel = 0; channel < 3; ++channel)
    job.tint[channel] = static_cast<std::int32_t>(light.color[channel] * 32768.0f + 0.5f);
  job.perspective = placement.perspective && !context.settings.alias_snap;
  job.has_short_rows = compute_side_px(placement) < kShortRowsSidePx;
  return job;
}

PreparedAlias prepare_alias(const FrameContext& context, const ViewFrame& view,
                            const AliasPlacement& placement, base::Arena& arena) {
  const Settings& settings = context.settings;
  const AliasInstance& instance = *placement.instance;
  const AliasModel& model = *instance.model;
  const AliasLight light = choose_light(context, instance);
  const NormalLights lights = light_normals(light, placement, context.format);

  VertexOutput projected{arena.allocate<ScreenVertex>(model.vertices_per_row), {}};
  if (placement.needs_clipping)
    for (std::span<float>& axis : projected.view) axis = arena.allocate<float>(model.vertices_per_row);
  if (model.is_wide())
    project_poses<std::uint16_t>(context, view, placement,
                                 {model.wide_pose(instance.from_pose), model.wide_pose(instance.to_pose)},
                                 lights, projected);
  else
    project_poses<std::uint8_t>(context, view, placement,
                                {model.pose(instance.from_pose), model.pose(instance.to_pose)}, lights,
                                projected);
  const ProjectedMesh mesh{projected.vertices.first(model.vertex_count),
                           {projected.view[0], projected.view[1], projected.view[2]},
                           model.texels,
                           model.triangles};

  ClippedMesh drawn{mesh.vertices, mesh.texels, mesh.triangles};
  if (placement.needs_clipping)
    drawn = clip_triangles(view, placement, mesh, steps_per_pixel(settings), arena);

  PreparedAlias prepared{};
  prepared.first_row = placement.first_row;
  prepared.row_end = placement.row_end;
  prepared.by_subdivision = chooses_subdivision(settings, placement);
  TriangleJob& job = prepared.job;
  job = make_skin_job(context, placement, light, arena);
  job.vertices = drawn.vertices.data();
  job.texels = drawn.texels.data();
  job.triangles = drawn.triangles.empty() ? nullptr : drawn.triangles.front().data();
  job.vertex_count = drawn.vertices.size();
  job.triangle_count = drawn.triangles.size();
  if (settings.simd_kernels && !prepared.by_subdivision) {
    const std::size_t room = job.triangle_count + kFrontsSpare;
    job.fronts.numbers = arena.allocate<std::uint32_t>(room).data();
    job.fronts.rows = arena.allocate<TriangleRows>(room).data();
    find_front_triangles_simd(job, job.fronts);
  }
  return prepared;
}

}  // namespace temblor::render
