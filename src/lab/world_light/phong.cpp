#include "lab/world_light/phong.h"

#include <algorithm>
#include <memory>

#include "lab/world_light/kernels/phong_kernels.h"
#include "lab/world_light/level_lamps.h"
#include "lab/world_light/lit_draws.h"
#include "lab/world_light/polygon_row.h"

namespace temblor::lab {

namespace {

constexpr std::size_t kMaxDynamicLights = 16;  // of a face

// One draw: its lamps, and triangles whose "light" is the normal. Without triangles, `normal` is everywhere.
struct PhongDraw {
  std::span<const PointLamp> lamps;
  std::span<const LitPolygon> triangles;
  std::array<float, 3> normal;
};

// The state of one frame. Its memory, and the level's lamps, are kept for the next one.
struct Phong {
  LevelLamps lamps;
  render::ViewFrame view;
  render::EdgeTable edges;
  LitDraws draws;
  std::span<PhongDraw> jobs;   // by draw number
  LitPreparation preparation;  // of `jobs`
};

// `scale`: of its light.
PointLamp make_lamp(const render::ViewFrame& view, const Lamp& lamp, float scale) {
  const math::Vec3d from_eye = lamp.origin_world - view.eye_world;
  return {{static_cast<float>(from_eye.x), static_cast<float>(from_eye.y), static_cast<float>(from_eye.z)},
          lamp.light * scale,
          lamp.falloff * scale,
          lamp.inverse * scale,
          lamp.inverse_square * scale};
}

std::span<const PointLamp> collect_lamps(const render::FrameContext& context, const Phong& state,
                                         world::FaceIndex face, const render::FacePlane& plane,
                                         base::Arena& arena) {
  base::ArenaVector<PointLamp> lamps(arena, 16);
  for (const std::uint32_t number : state.lamps.lamps_on(face)) {
    const Lamp& lamp = state.lamps.all()[number];
    lamps.push_back(
        make_lamp(state.view, lamp, context.scene.light_styles[static_cast<std::size_t>(lamp.style)]));
  }
  std::size_t dynamic = 0;
  for (const render::DynamicLight& light : context.scene.lights) {
    const double distance = glm::dot(plane.normal, math::Vec3d(light.origin_world)) - plane.distance;
    if (!(distance > 0 && distance < light.radius) || dynamic++ == kMaxDynamicLights) continue;
    lamps.push_back(make_lamp(
        state.view, {.origin_world = math::Vec3d(light.origin_world), .light = light.radius, .falloff = 1},
        256));
  }
  return lamps.view();
}

// The face as triangles from its first corner.
std::span<const LitPolygon> make_triangles(const render::FrameContext& context, const Phong& state,
                                           const world::Face& face, const render::ModelView& model_view,
                                           base::Arena& arena) {
  base::ArenaVector<LitPolygon> triangles(arena, 8);
  const std::span<const math::Vec3d> normals = state.lamps.normals(face);
  const auto corner = [&](std::uint32_t i) {
    const world::Level& level = context.level();
    const math::Vec3d at(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    const math::Vec3 normal(model_view.direction_to_world(normals[i]));
    return WorldCorner{model_view.to_world(at), {normal.x, normal.y, normal.z}};
  };
  for (std::uint32_t i = 1; i + 1 < face.surfedge_count; ++i) {
    const LitPolygon triangle =
        place_polygon(state.view, std::array{corner(0), corner(i), corner(i + 1)}, true, arena);
    if (!triangle.corners.empty()) triangles.push_back(triangle);
  }
  return triangles.view();
}

PhongDraw make_draw(const render::FrameContext& context, const Phong& state, const render::SurfaceDraw& draw,
                    bool is_smooth, base::Arena& arena) {
  const render::ScreenSurface& surface = state.edges.surfaces[base::to_size(draw.surface)];
  const world::Face& face = context.level().face(surface.face);
  const render::ModelView& model_view = state.edges.model_views[surface.instance];
  const render::FacePlane plane = render::place_plane(context.level(), face, model_view);
  PhongDraw made{collect_lamps(context, state, surface.face, plane, arena), {}, {}};
  if (is_smooth) made.triangles = make_triangles(context, state, face, model_view, arena);
  for (int i = 0; i < 3; ++i) made.normal[static_cast<std::size_t>(i)] = static_cast<float>(plane.normal[i]);
  return made;
}

void prepare(const render::FrameContext& context, const render::SurfaceRequests& requests, bool is_smooth,
             Phong& io_state) {
  io_state.draws = choose_lit_draws(context, requests);
  io_state.jobs = context.arena().allocate<PhongDraw>(requests.draws.size());
  io_state.preparation.run(context, io_state.draws.own, [&](std::uint32_t number, base::Arena& arena) {
    io_state.jobs[number] = make_draw(context, io_state, requests.draws[number], is_smooth, arena);
  });
}

constexpr LitKernels kKernels{draw_phong_lit_u8_simd, draw_phong_lit_u8_scalar, draw_phong_lit_u32_simd,
                              draw_phong_lit_u32_scalar};

// Draws the spans of one draw, in batches.
class PhongSpans {
 public:
  PhongSpans(const LitSpans& spans, const PhongDraw& draw, const render::ViewFrame& view,
             const render::SpanSources& sources, const render::KernelTarget& target)
      : spans_(spans), draw_(draw), view_(view), sources_(sources), target_(target) {
    lights_.lamps = draw.lamps.data();
    lights_.lamp_count = static_cast<std::int32_t>(draw.lamps.size());
    for (int i = 0; i < 3; ++i)
      lights_.ray_step[i] = static_cast<float>(view.axes.right[i] / view.pixels_per_unit);
  }

  void draw(std::span<const render::Span> spans) {
    for (const render::Span& span : spans) {
      if (draw_.triangles.empty()) {
        add_part(span, span, nullptr);
        continue;
      }
      if (row_.y() != span.y) row_.find(draw_.triangles, span.y);
      row_.split(span, [&](const RowPart& part) { add_part(span, part.pixels, &part.interval.row); });
    }
    flush();
  }

 private:
  // `row`: the normals at the triangle's edges, over z; null: the face's own.
  void add_part(const render::Span& span, const render::Span& pixels, const RowLight* row) {
    if (count_ == kBatch) flush();
    PhongPart& part = lines_[count_] = PhongPart{};
    const math::Vec3d ray = view_.axes.forward +
                            view_.axes.right * ((span.x - view_.center_x) / view_.pixels_per_unit) -
                            view_.axes.up * ((span.y - view_.center_y) / view_.pixels_per_unit);
    for (std::size_t i = 0; i < 3; ++i) {
      part.ray[i] = static_cast<float>(ray[static_cast<int>(i)]);
      part.normal[i] = draw_.normal[i];
      if (row == nullptr) continue;
      const LightStep light = row->steps_from(span.x, i);
      part.normal[i] = static_cast<float>(light.first);
      part.normal_step[i] = static_cast<float>(light.step);
    }
    part.pixels_before = pixels.x - span.x;
    parts_[count_++] = pixels;
  }

  void flush() {
    spans_.spans = parts_.data();
    spans_.span_count = count_;
    lights_.parts = lines_.data();
    count_ = 0;
    kKernels.choose(sources_)(spans_, lights_, target_);
  }

  static constexpr std::size_t kBatch = 64;
  LitSpans spans_;
  PhongLights lights_{};
  const PhongDraw& draw_;
  const render::ViewFrame& view_;
  const render::SpanSources& sources_;
  const render::KernelTarget& target_;
  PolygonRow row_;
  std::size_t count_ = 0;
  std::array<render::Span, kBatch> parts_;
  std::array<PhongPart, kBatch> lines_;
};

}  // namespace

base::Status check_lamps(std::span<const double> /*values*/, const world::Level& level) {
  if (!find_lamps(level).empty()) return base::Ok{};
  return base::error(base::ErrorCode::kUnsupported,
                     "{}: phong needs entities whose class name begins with light", level.name);
}

render::FrameStages make_phong(std::span<const double> values, Counter* counter) {
  const auto per_face = static_cast<std::size_t>(values[0]);
  const double smooth_deg = values[1];
  const auto state = std::make_shared<Phong>();
  render::FrameStages stages;
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    if (!state->lamps.belongs_to(context.level()))
      state->lamps = LevelLamps(context.level(), per_face, smooth_deg);
    state->view = view;
    state->edges = table;
    return render::scan_edges(context, view, table);
  };
  stages.reserve_surfaces = [=](const render::FrameContext& context, const render::SurfaceRequests& requests,
                                render::SurfaceCache& io_cache) {
    state->draws = {};
    if (state->lamps.all().empty() || !state->view.perspective)
      return render::reserve_surfaces(context, requests, io_cache);
    const std::size_t before = context.arena().used_bytes();
    prepare(context, requests, smooth_deg > 0, *state);
    if (counter != nullptr)
      counter->add({.bytes = context.arena().used_bytes() - before + state->preparation.used_bytes()});
    return render::reserve_surfaces(context, state->draws.left, io_cache);
  };
  stages.draw_band_spans = [=](const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    if (state->draws.all.empty()) return render::draw_band_spans(context, view, band, sources, io_frame);
    draw_lit_band(
        {context, view, band, sources}, state->draws.all,
        [&](std::uint32_t number, std::span<const render::Span> spans, const render::KernelTarget& target) {
          PhongSpans(make_lit_spans(context, view, sources.draws.all[number], state->draws.all[number]),
                     state->jobs[number], view, sources, target)
              .draw(spans);
        },
        io_frame);
  };
  return stages;
}

}  // namespace temblor::lab
