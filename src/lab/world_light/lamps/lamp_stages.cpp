#include "lab/world_light/lamps/lamp_stages.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace temblor::lab {

namespace {

constexpr std::size_t kMaxDynamicLights = 16;  // of a face

// The state of one frame. Its memory, and the level's lamps, are kept for the next one.
struct LampFrame {
  LevelLamps lamps;
  bool can_draw = false;  // the level
  render::ViewFrame view;
  render::EdgeTable edges;
  LitDraws draws;
  std::span<LampDraw> jobs;    // by draw number
  LitPreparation preparation;  // of `jobs`
};

// `scale`: of its light.
PointLamp make_lamp(const render::ViewFrame& view, const Lamp& lamp, float scale) {
  const math::Vec3d from_eye = lamp.origin_world - view.eye_world;
  return {{static_cast<float>(from_eye.x), static_cast<float>(from_eye.y), static_cast<float>(from_eye.z)},
          lamp.light * scale,
          lamp.falloff * scale,
          lamp.inverse * scale,
          lamp.inverse_square * scale,
          {static_cast<float>(lamp.spot.x), static_cast<float>(lamp.spot.y), static_cast<float>(lamp.spot.z)},
          static_cast<float>(lamp.spot_cosine),
          lamp.is_sky};
}

std::span<const PointLamp> collect_lamps(const render::FrameContext& context, const LampFrame& state,
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
std::span<const LitPolygon> make_triangles(const render::FrameContext& context, const LampFrame& state,
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

LampDraw make_draw(const render::FrameContext& context, const LampFrame& state,
                   const render::SurfaceDraw& draw, bool is_smooth, base::Arena& arena) {
  const render::ScreenSurface& surface = state.edges.surfaces[base::to_size(draw.surface)];
  const world::Face& face = context.level().face(surface.face);
  const render::ModelView& model_view = state.edges.model_views[surface.instance];
  const render::FacePlane plane = render::place_plane(context.level(), face, model_view);
  LampDraw made{collect_lamps(context, state, surface.face, plane, arena), {}, {}};
  if (is_smooth) made.triangles = make_triangles(context, state, face, model_view, arena);
  for (int i = 0; i < 3; ++i) made.normal[static_cast<std::size_t>(i)] = static_cast<float>(plane.normal[i]);
  return made;
}

void prepare(const render::FrameContext& context, const render::SurfaceRequests& requests, bool is_smooth,
             LampFrame& io_state) {
  io_state.draws = choose_lit_draws(context, requests);
  io_state.jobs = context.arena().allocate<LampDraw>(requests.draws.size());
  io_state.preparation.run(context, io_state.draws.own, [&](std::uint32_t number, base::Arena& arena) {
    io_state.jobs[number] = make_draw(context, io_state, requests.draws[number], is_smooth, arena);
  });
}

}  // namespace

base::Status check_lamps(std::span<const double> /*values*/, const world::Level& level) {
  if (!find_lamps(level).empty()) return base::Ok{};
  return base::error(base::ErrorCode::kUnsupported,
                     "{}: there are no lights: no entity's class name begins with light", level.name);
}

render::FrameStages make_lamp_stages(const LampOptions& options, Counter* counter,
                                     std::function<bool(const world::Level& level)> begin_level,
                                     std::function<void(const LampSpans& spans)> draw_spans) {
  const auto state = std::make_shared<LampFrame>();
  render::FrameStages stages;
  stages.scan_edges = [=, begin = std::move(begin_level)](const render::FrameContext& context,
                                                          const render::ViewFrame& view,
                                                          const render::EdgeTable& table) {
    if (!state->lamps.belongs_to(context.level())) {
      std::vector<Lamp> lamps = find_lamps(context.level());
      if (options.has_shadows)
        std::ranges::copy(find_shadowed_lamps(context.level()), std::back_inserter(lamps));
      state->lamps =
          LevelLamps(context.level(), std::move(lamps), options.lamps_per_face, options.smooth_deg);
      state->can_draw = begin(context.level()) && !state->lamps.all().empty();
    }
    state->view = view;
    state->edges = table;
    return render::scan_edges(context, view, table);
  };
  stages.reserve_surfaces = [=](const render::FrameContext& context, const render::SurfaceRequests& requests,
                                render::SurfaceCache& io_cache) {
    state->draws = {};
    if (!state->can_draw || !state->view.perspective)
      return render::reserve_surfaces(context, requests, io_cache);
    const std::size_t before = context.arena().used_bytes();
    prepare(context, requests, options.smooth_deg > 0, *state);
    if (counter != nullptr)
      counter->add({.bytes = context.arena().used_bytes() - before + state->preparation.used_bytes()});
    return render::reserve_surfaces(context, state->draws.left, io_cache);
  };
  stages.draw_band_spans = [=, draw = std::move(draw_spans)](
                               const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    if (state->draws.all.empty()) return render::draw_band_spans(context, view, band, sources, io_frame);
    draw_lit_band(
        {context, view, band, sources}, state->draws.all,
        [&](std::uint32_t number, std::span<const render::Span> spans, const render::KernelTarget& target) {
          const LitSpans job =
              make_lit_spans(context, view, sources.draws.all[number], state->draws.all[number]);
          draw({view, sources, state->jobs[number], job, spans, target});
        },
        io_frame);
  };
  return stages;
}

}  // namespace temblor::lab
