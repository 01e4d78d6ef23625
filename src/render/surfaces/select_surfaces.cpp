#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/color/warped_rows.h"
#include "render/surfaces/build_surface.h"
#include "render/surfaces/choose_mip.h"
#include "render/surfaces/light/caustics.h"
#include "render/surfaces/light/light_samples.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

namespace {

ScreenPlane scaled(const ScreenPlane& plane, double factor) {
  return {plane.at_origin * factor, plane.dx * factor, plane.dy * factor};
}

// plane + offset * depth: moves the origin of a texture coordinate (over z, in perspective).
ScreenPlane shifted(const ViewFrame& view, const ScreenPlane& plane, const ScreenPlane& depth,
                    double offset) {
  if (!view.perspective) return {plane.at_origin + offset, plane.dx, plane.dy};
  return {plane.at_origin + offset * depth.at_origin, plane.dx + offset * depth.dx,
          plane.dy + offset * depth.dy};
}

// Surfaces per job: few enough to distribute the work evenly over the threads.
constexpr std::size_t kSurfacesPerJob = 32;

// The state of one call. sum_visible_pixels() comes first; describe_surface() may then run in parallel for
// different surfaces; request_blocks() comes last.
class SurfaceSelector {
 public:
  SurfaceSelector(const FrameContext& context, const ViewFrame& view, const EdgeTable& table,
                  const SpanTable& spans, const CutoutTextures& cutouts, const WaterFaces& water_faces)
      : scene_(context.scene),
        level_(context.level()),
        settings_(context.settings),
        view_(view),
        table_(table),
        spans_(spans),
        cutouts_(cutouts),
        water_faces_(water_faces),
        format_(context.format),
        light_now_{scene_.lights, scene_.light_styles},
        warp_phase_(static_cast<float>(compute_turbulence_phase(scene_.time_s))),
        arena_(context.arena()),
        draws_(arena_.allocate_filled<SurfaceDraw>(table.draw_count, SurfaceDraw{})),
        seen_(arena_.allocate_filled<PixelSum>(table.draw_count, PixelSum{})),
        has_dynamic_light_(arena_.allocate_filled<bool>(table.surfaces.size(), false)) {}

  // Marks the draws that have spans, and sums their pixels over all bands.
  void sum_visible_pixels() {
    for (const Band& band : spans_.bands)
      for (std::size_t i = 0; i < band.draws.size(); ++i) {
        draws_[band.draws[i]].kind = SurfaceKind::kBlock;
        PixelSum& seen = seen_[band.draws[i]];
        seen.pixels += band.sums[i].pixels;
        seen.x += band.sums[i].x;
        seen.y += band.sums[i].y;
      }
    if (draws_[0].kind != SurfaceKind::kHidden) draws_[0].kind = SurfaceKind::kNothing;
  }

  // Computes the planes and mip levels of one surface's draws.
  void describe_surface(std::size_t number, base::Arena& scratch) {
    const ScreenSurface& surface = table_.surfaces[number];
    const std::uint32_t tiles = std::uint32_t{surface.tiles.s} * surface.tiles.t;
    const std::span<SurfaceDraw> draws = draws_.subspan(surface.first_draw, tiles);
    if (std::all_of(draws.begin(), draws.end(),
                    [](const SurfaceDraw& draw) { return draw.kind == SurfaceKind::kHidden; }))
      return;
    const world::Face& face = level_.face(surface.face);
    const ModelView& model_view = table_.model_views[surface.instance];
    const FacePlacement placed = place_face(level_, face, model_view);
    has_dynamic_light_[number] = has_surface(face) && has_dynamic_light(surface.face, placed);
    TexturePlanes planes{depth_plane(view_, placed.normal, placed.distance), {}, {}};
    planes.s = coordinate_plane(view_, planes.depth, placed.s_axis, placed.s_offset);
    planes.t = coordinate_plane(view_, planes.depth, placed.t_axis, placed.t_offset);
    for (std::uint32_t tile = 0; tile < tiles; ++tile) {
      SurfaceDraw& draw = draws[tile];
      if (draw.kind == SurfaceKind::kHidden) continue;
      draw.surface = base::to_index<SurfaceIndex>(number);
      draw.depth = planes.depth;
      draw.kind = surface_kind(face);
      draw.light_row = face.kind == world::FaceKind::kLit && settings_.light_view != LightView::kFullBright
                           ? kLightNone
                           : kLightAsStored;
      draw.texture_index = drawn_texture(surface, face);
      draw.texture = &cutouts_.drawn(level_, draw.texture_index);
      draw.mip =
          static_cast<std::int8_t>(choose_mip(surface, surface.first_draw + tile, placed, planes, scratch));
      const math::Vec2d first = first_texel(surface, tile, *draw.texture);
      const double scale = std::ldexp(1.0, -draw.mip);
      draw.s = scaled(shifted(view_, planes.s, planes.depth, first.x), scale);
      draw.t = scaled(shifted(view_, planes.t, planes.depth, first.y), scale);
    }
  }

  // Makes a request for each draw that needs a surface block.
  SurfaceRequests request_blocks() {
    base::ArenaVector<BlockRequest> requests(arena_, 256);
    for (std::uint32_t number = 0; number < draws_.size(); ++number)
      if (draws_[number].kind == SurfaceKind::kBlock) requests.push_back(make_request(number));
    return {draws_, table_.first_deferred_draw(), requests.view()};
  }

 private:
  // Animated textures change with time; an instance's frame selects the alternate sequence.
  world::TextureIndex drawn_texture(const ScreenSurface& surface, const world::Face& face) const {
    const int frame = surface.instance == 0 ? 0 : scene_.brush_models[surface.instance - 1].frame;
    return world::find_animated_texture(level_, face.texture, scene_.time_s, frame);
  }

  static SurfaceKind surface_kind(const world::Face& face) {
    if (has_surface(face)) return SurfaceKind::kBlock;
    if (face.kind == world::FaceKind::kSky) return SurfaceKind::kSky;
    return face.kind == world::FaceKind::kLiquid ? SurfaceKind::kLiquid : SurfaceKind::kTexture;
  }

  // The offset from the face's first texel to the origin of a draw's coordinates: the first texel of its
  // tile, or, for a texture that repeats, a point where the texture begins; for a liquid also its warp, so
  // that waves continue from face to face.
  math::Vec2d first_texel(const ScreenSurface& surface, std::uint32_t tile,
                          const world::Texture& texture) const {
    const world::Face& face = level_.face(surface.face);
    if (has_surface(face))
      return math::Vec2d(tile % surface.tiles.s, tile / surface.tiles.s) * -static_cast<double>(kTileTexels);
    const auto repeat = [&](std::uint32_t side) {
      const auto texels = static_cast<std::int32_t>(side);
      return face.kind == world::FaceKind::kLiquid ? std::lcm(texels, static_cast<std::int32_t>(kTurn_texels))
                                                   : texels;
    };
    return {face.texture_mins[0] % repeat(texture.width), face.texture_mins[1] % repeat(texture.height)};
  }

  BlockRequest make_request(std::uint32_t number) const {
    const SurfaceDraw& draw = draws_[number];
    const ScreenSurface& surface = table_.surfaces[base::to_size(draw.surface)];
    const std::uint32_t tile = number - surface.first_draw;
    BlockRequest request{.face = surface.face,
                         .tile_s = static_cast<std::uint16_t>(tile % surface.tiles.s),
                         .tile_t = static_cast<std::uint16_t>(tile / surface.tiles.s),
                         .mip = draw.mip,
                         .contents = {},
                         .lights = {},
                         .marks = {},
                         .block = {},
                         .texture = draw.texture,
                         .draw = number};
    request.contents.texture = draw.texture_index;
    request.contents.light_view = settings_.light_view;
    if (level_.face(surface.face).kind == world::FaceKind::kLiquid) {
      request.contents.warp_phase = warp_phase_;
      if (!settings_.lit_liquids) request.contents.light_view = LightView::kFullBright;
    }
    if (request.contents.light_view != LightView::kFullBright) light_block(surface, draw, request);
    if (has_marks(scene_)) {
      request.marks = scene_.marks->marks_on_face(surface.face);
      request.contents.marks = scene_.marks->revision(surface.face);
    }
    return request;
  }

  void light_block(const ScreenSurface& surface, const SurfaceDraw& draw, BlockRequest& io_request) const {
    const world::Face& face = level_.face(surface.face);
    BlockContents& contents = io_request.contents;
    contents.colored = shows_color() && !level_.light_rgb.empty();
    for (std::size_t style = 0; style < face.style_count; ++style)
      contents.style_values[style] = current_light(surface.face).light_styles[face.styles[style]];
    if (settings_.caustics && water_faces_.contains(surface.face))
      contents.caustic_step = find_caustic_step(surface.face, scene_.time_s);
    if (!has_dynamic_light_[base::to_size(draw.surface)]) return;
    io_request.lights = lights_on_tile(surface, sample_grid(face, io_request.tile_s, io_request.tile_t));
    contents.lights = hash_lights(io_request.lights);
  }

  // With relight_alternate, the face's and the frame's numbers decide whether the face shows the light of
  // this frame or of the previous one. The contents of the cache must not matter, or pixels would depend on
  // it.
  const SceneLight& current_light(world::FaceIndex face) const {
    if (!settings_.relight_alternate || scene_.light_before == nullptr) return light_now_;
    const bool in_turn = (static_cast<std::uint32_t>(face) + scene_.frame_number) % 2 == 0;
    return in_turn ? light_now_ : *scene_.light_before;
  }

  // Light maps show their colors in true color only; dynamic lights in both formats.
  bool shows_color() const { return format_ == PixelFormat::kRgb && settings_.colored_light; }

  // Whether a dynamic light reaches the face at all: a quick test before lights are collected per tile.
  bool has_dynamic_light(world::FaceIndex number, const FacePlacement& placed) const {
    const world::Face& face = level_.face(number);
    const std::span<const DynamicLight> lights = current_light(number).lights;
    const SampleGrid whole{0, 0, face.texture_extents[0] / kTexelsASample + 1,
                           face.texture_extents[1] / kTexelsASample + 1};
    return std::any_of(lights.begin(), lights.end(), [&](const DynamicLight& light) {
      const std::optional<FaceLight> on_face = light_on_face(light, placed, settings_.colored_light);
      return on_face && reaches(*on_face, whole);
    });
  }
  std::span<const FaceLight> lights_on_tile(const ScreenSurface& surface, const SampleGrid& tile) const {
    const FacePlacement placed =
        place_face(level_, level_.face(surface.face), table_.model_views[surface.instance]);
    base::ArenaVector<FaceLight> lights(arena_, 4);
    for (const DynamicLight& light : current_light(surface.face).lights) {
      const std::optional<FaceLight> on_face = light_on_face(light, placed, settings_.colored_light);
      if (on_face && reaches(*on_face, tile)) lights.push_back(*on_face);
    }
    return lights.view();
  }

  int choose_mip(const ScreenSurface& surface, std::uint32_t draw, const FacePlacement& placed,
                 const TexturePlanes& planes, base::Arena& scratch) const {
    const SurfaceDraw& drawn = draws_[draw];
    // The warp is in texels of mip 0, which are always enough for stock textures.
    const bool is_liquid = drawn.kind == SurfaceKind::kLiquid;
    if (is_liquid && drawn.texture->finest_mip() == 0) return 0;
    if (settings_.force_mip >= 0) return is_liquid ? 0 : settings_.force_mip;
    const int mip = apply_mip_rule(surface, draw, placed, planes, scratch);
    // Smaller mip levels of textures of other sizes do not repeat at the same places as the texture.
    const bool repeats = drawn.texture->width % 8 == 0 && drawn.texture->height % 8 == 0;
    return repeats && !is_liquid ? mip : std::min(mip, 0);
  }

  int apply_mip_rule(const ScreenSurface& surface, std::uint32_t draw, const FacePlacement& placed,
                     const TexturePlanes& planes, base::Arena& scratch) const {
    const int finest = draws_[draw].texture->finest_mip();
    if (settings_.mip_rule == MipRule::kFootprint) {
      // At the center of the visible part.
      const PixelSum seen = sum_face_pixels(surface, draw);
      const double pixels = static_cast<double>(seen.pixels);
      return footprint_mip(view_, planes, static_cast<double>(seen.x) / pixels,
                           static_cast<double>(seen.y) / pixels, finest);
    }
    const bool whole = surface.tiles.s == 1 && surface.tiles.t == 1;
    const double nearest =
        whole ? nearest_face_depth(surface, scratch) : nearest_span_depth(draw, planes.depth);
    return stock_mip(view_, nearest, (glm::length(placed.s_axis) + glm::length(placed.t_axis)) / 2, finest);
  }

  // Sums over all fragments of the face, which are adjacent: they must get the same mip level.
  PixelSum sum_face_pixels(const ScreenSurface& surface, std::uint32_t draw) const {
    const std::uint32_t tile = draw - surface.first_draw;
    const auto same_face = [&](const ScreenSurface& other) {
      return other.instance == surface.instance && other.face == surface.face;
    };
    std::size_t first = base::to_size(draws_[draw].surface);
    while (first > 1 && same_face(table_.surfaces[first - 1])) --first;
    PixelSum sum;
    for (std::size_t i = first; i < table_.surfaces.size() && same_face(table_.surfaces[i]); ++i) {
      const PixelSum& fragment = seen_[table_.surfaces[i].first_draw + tile];
      sum.pixels += fragment.pixels;
      sum.x += fragment.x;
      sum.y += fragment.y;
    }
    return sum;
  }

  double nearest_face_depth(const ScreenSurface& surface, base::Arena& scratch) const {
    if (surface.nearest_z > 0) return view_.depth(static_cast<double>(surface.nearest_z));
    const world::Face& face = level_.face(surface.face);
    const std::span<math::Vec3d> corners = scratch.allocate<math::Vec3d>(face.surfedge_count);
    for (std::uint32_t i = 0; i < face.surfedge_count; ++i)
      corners[i] = table_.model_views[surface.instance].to_world(
          math::Vec3d(level_.vertices[level_.surfedge_start(face.first_surfedge + i)]));
    return nearest_depth(view_, corners, scratch);
  }

  // Depth is linear along a span, so its largest value is at one of the ends.
  double nearest_span_depth(std::uint32_t number, const ScreenPlane& depth) const {
    double nearest = view_.depth(1e9);
    for (const Band& band : spans_.bands) {
      const auto found = std::ranges::find(band.draws, number);
      if (found == band.draws.end()) continue;
      const auto position = static_cast<std::size_t>(found - band.draws.begin());
      for (std::uint32_t i = band.span_begin[position]; i < band.span_begin[position + 1]; ++i) {
        const Span& span = band.spans[i];
        nearest = std::max({nearest, depth.at(span.x, span.y), depth.at(span.x + span.count - 1, span.y)});
      }
    }
    return nearest;
  }

  const Scene& scene_;
  const world::Level& level_;
  const Settings& settings_;
  const ViewFrame& view_;
  const EdgeTable& table_;
  const SpanTable& spans_;
  const CutoutTextures& cutouts_;
  const WaterFaces& water_faces_;
  const PixelFormat format_;
  const SceneLight light_now_;
  const float warp_phase_;
  base::Arena& arena_;
  std::span<SurfaceDraw> draws_;
  std::span<PixelSum> seen_;           // by draw
  std::span<bool> has_dynamic_light_;  // by surface: whether a dynamic light reaches the face
};

}  // namespace

SurfaceRequests select_surfaces(const FrameContext& context, const ViewFrame& view, const EdgeTable& table,
                                const SpanTable& spans, const CutoutTextures& cutouts,
                                const WaterFaces& water_faces) {
  SurfaceSelector selector(context, view, table, spans, cutouts, water_faces);
  selector.sum_visible_pixels();
  const std::size_t job_count = (table.surfaces.size() + kSurfacesPerJob - 1) / kSurfacesPerJob;
  std::vector<base::Arena>& scratch = context.arenas.scratch;
  FrameArenas::grow(scratch, job_count);
  context.jobs.parallel_for(job_count, [&](std::size_t job) {
    scratch[job].reset();
    const std::size_t end = std::min(table.surfaces.size(), (job + 1) * kSurfacesPerJob);
    for (std::size_t surface = std::max<std::size_t>(1, job * kSurfacesPerJob); surface < end; ++surface)
      selector.describe_surface(surface, scratch[job]);
  });
  return selector.request_blocks();
}

}  // namespace temblor::render
