#include <algorithm>

#include "render/surfaces/build_surface.h"
#include "render/surfaces/choose_mip.h"
#include "render/surfaces/light_samples.h"
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

// One job's surfaces: few enough to spread well over the workers.
constexpr std::size_t kSurfacesAJob = 32;

class SurfaceSelector {
 public:
  SurfaceSelector(const Scene& scene, const Settings& settings, const ViewFrame& view, const EdgeTable& table,
                  const SpanTable& spans, const CutoutTextures& cutouts, PixelFormat format,
                  base::Arena& arena)
      : scene_(scene),
        level_(*scene.level),
        settings_(settings),
        view_(view),
        table_(table),
        spans_(spans),
        cutouts_(cutouts),
        format_(format),
        light_now_{scene.lights, scene.light_styles},
        arena_(arena),
        items_(arena.allocate_filled<SurfaceDraw>(table.item_count, SurfaceDraw{})),
        seen_(arena.allocate_filled<PixelSum>(table.item_count, PixelSum{})),
        touched_(arena.allocate_filled<bool>(table.surfaces.size(), false)) {}

  // Marks what got spans, and sums up where.
  void collect() {
    for (const Band& band : spans_.bands)
      for (std::size_t i = 0; i < band.items.size(); ++i) {
        items_[band.items[i]].kind = ItemKind::kSurface;
        PixelSum& seen = seen_[band.items[i]];
        seen.pixels += band.sums[i].pixels;
        seen.x += band.sums[i].x;
        seen.y += band.sums[i].y;
      }
    if (items_[0].kind != ItemKind::kUnused) items_[0].kind = ItemKind::kNothing;
  }

  // Planes and mip levels of one surface's items.
  void describe(std::size_t number, base::Arena& scratch) {
    const ScreenSurface& surface = table_.surfaces[number];
    const std::uint32_t tiles = std::uint32_t{surface.tiles.s} * surface.tiles.t;
    const std::span<SurfaceDraw> items = items_.subspan(surface.first_item, tiles);
    if (std::all_of(items.begin(), items.end(),
                    [](const SurfaceDraw& item) { return item.kind == ItemKind::kUnused; }))
      return;
    const world::Face& face = level_.face(surface.face);
    const ModelView& model_view = table_.model_views[surface.instance];
    const FacePlacement placed = place_face(level_, face, model_view);
    touched_[number] = has_surface(face) && is_touched(surface.face, placed);
    const ScreenPlane depth = depth_plane(view_, placed.normal, placed.distance);
    const ScreenPlane s = coordinate_plane(view_, depth, placed.s_axis, placed.s_offset);
    const ScreenPlane t = coordinate_plane(view_, depth, placed.t_axis, placed.t_offset);
    for (std::uint32_t tile = 0; tile < tiles; ++tile) {
      SurfaceDraw& item = items[tile];
      if (item.kind == ItemKind::kUnused) continue;
      item.surface = base::to_index<SurfaceIndex>(number);
      item.depth = depth;
      item.kind = kind_of(face);
      item.light_row = face.kind == world::FaceKind::kLit ? kLightNone : kLightAsStored;
      item.texture_index = texture_of(surface, face);
      item.texture = &cutouts_.drawn(level_, item.texture_index);
      item.mip =
          static_cast<std::uint8_t>(mip_of(surface, surface.first_item + tile, placed, depth, s, t, scratch));
      const math::Vec2d first = first_texel(surface, tile, *item.texture);
      const double scale = 1.0 / (1 << item.mip);
      item.s = scaled(shifted(view_, s, depth, first.x), scale);
      item.t = scaled(shifted(view_, t, depth, first.y), scale);
    }
  }

  // Every block the frame needs: those that are there are marked first, so that making room for the rest
  // cannot evict them.
  std::span<BlockRequest> request_blocks(SurfaceCache& io_cache, FrameStats& io_stats) {
    base::ArenaVector<BlockRequest> missing(arena_, 256);
    base::ArenaVector<ItemRequest> waiting(arena_, 256);
    for (std::uint32_t number = 0; number < items_.size(); ++number) {
      SurfaceDraw& item = items_[number];
      if (item.kind != ItemKind::kSurface) continue;
      const BlockRequest request = request_of(number);
      SurfaceCache::Lookup found;
      if (!io_cache.find(slot_of(io_cache, request), request.contents, found)) {
        waiting.push_back({number, request});
        continue;
      }
      item.block = found.block;
      count_use(found, io_stats);
    }
    for (auto [number, request] : waiting) {
      const world::Face& face = level_.face(request.face);
      const SurfaceShape shape = surface_shape(face, request.tile_s, request.tile_t, request.mip);
      const SurfaceCache::Lookup room = io_cache.reserve(slot_of(io_cache, request), request.contents, shape);
      items_[number].block = request.block = room.block;
      count_use(room, io_stats);
      if (!room.must_build) continue;
      missing.push_back(request);
      io_stats.texels_built += shape.texels();
    }
    io_stats.surfaces_built = static_cast<std::uint32_t>(missing.size());
    return missing.view();
  }

  std::span<SurfaceDraw> items() const { return items_; }

 private:
  struct ItemRequest {
    std::uint32_t item;
    BlockRequest request;
  };

  world::TextureIndex texture_of(const ScreenSurface& surface, const world::Face& face) const {
    const int frame = surface.instance == 0 ? 0 : scene_.brush_models[surface.instance - 1].frame;
    return world::animated_texture(level_, face.texture, scene_.time_s, frame);
  }

  static ItemKind kind_of(const world::Face& face) {
    if (has_surface(face)) return ItemKind::kSurface;
    if (face.kind == world::FaceKind::kSky) return ItemKind::kSky;
    return face.kind == world::FaceKind::kLiquid ? ItemKind::kLiquid : ItemKind::kTexture;
  }

  // From the face's first texel to the one that coordinates are to be counted from: its tile's first, or, for
  // a texture that repeats, one where it begins.
  math::Vec2d first_texel(const ScreenSurface& surface, std::uint32_t tile,
                          const world::Texture& texture) const {
    const world::Face& face = level_.face(surface.face);
    if (has_surface(face))
      return math::Vec2d(tile % surface.tiles.s, tile / surface.tiles.s) * -static_cast<double>(kTileTexels);
    return {face.texture_mins[0] % static_cast<std::int32_t>(texture.width),
            face.texture_mins[1] % static_cast<std::int32_t>(texture.height)};
  }

  // Pieces of a face read from one block.
  static void count_use(const SurfaceCache::Lookup& lookup, FrameStats& io_stats) {
    if (!lookup.first_use) return;
    ++io_stats.surfaces;
    io_stats.texels_read += lookup.block.shape.texels();
  }

  BlockRequest request_of(std::uint32_t number) const {
    const SurfaceDraw& item = items_[number];
    const ScreenSurface& surface = table_.surfaces[base::to_size(item.surface)];
    const world::Face& face = level_.face(surface.face);
    const std::uint32_t tile = number - surface.first_item;
    BlockRequest request{surface.face,
                         static_cast<std::uint16_t>(tile % surface.tiles.s),
                         static_cast<std::uint16_t>(tile / surface.tiles.s),
                         item.mip,
                         {},
                         {},
                         {},
                         {},
                         item.texture};
    request.contents.texture = item.texture_index;
    request.contents.colored = shows_color() && !level_.light_rgb.empty();
    for (std::size_t style = 0; style < face.style_count; ++style)
      request.contents.style_values[style] = light_of(surface.face).light_styles[face.styles[style]];
    if (touched_[base::to_size(item.surface)]) {
      request.lights = lights_on_tile(surface, sample_grid(face, request.tile_s, request.tile_t));
      request.contents.lights = hash_of(request.lights);
    }
    if (has_marks(scene_)) {
      request.marks = scene_.marks->of_face(surface.face);
      request.contents.marks = scene_.marks->revision(surface.face);
    }
    return request;
  }

  // Whether a face shows the light of this frame or of the one before depends on numbers alone, never on what
  // the cache holds.
  const SceneLight& light_of(world::FaceIndex face) const {
    if (!settings_.relight_alternate || scene_.light_before == nullptr) return light_now_;
    const bool in_turn = (static_cast<std::uint32_t>(face) + scene_.frame_number) % 2 == 0;
    return in_turn ? light_now_ : *scene_.light_before;
  }

  bool shows_color() const { return format_ == PixelFormat::kRgb && settings_.colored_light; }

  bool is_touched(world::FaceIndex number, const FacePlacement& placed) const {
    const world::Face& face = level_.face(number);
    const std::span<const DynamicLight> lights = light_of(number).lights;
    const SampleGrid whole{0, 0, face.light_width(), face.light_height()};
    return std::any_of(lights.begin(), lights.end(), [&](const DynamicLight& light) {
      const std::optional<FaceLight> on_face = light_on_face(light, placed, shows_color());
      return on_face && reaches(*on_face, whole);
    });
  }
  std::span<const FaceLight> lights_on_tile(const ScreenSurface& surface, const SampleGrid& tile) const {
    const FacePlacement placed =
        place_face(level_, level_.face(surface.face), table_.model_views[surface.instance]);
    base::ArenaVector<FaceLight> lights(arena_, 4);
    for (const DynamicLight& light : light_of(surface.face).lights) {
      const std::optional<FaceLight> on_face = light_on_face(light, placed, shows_color());
      if (on_face && reaches(*on_face, tile)) lights.push_back(*on_face);
    }
    return lights.view();
  }

  std::size_t slot_of(const SurfaceCache& cache, const BlockRequest& request) const {
    const TileGrid grid = tile_grid(level_.face(request.face));
    return cache.slot(request.face, std::size_t{request.tile_t} * grid.s + request.tile_s, request.mip);
  }

  int mip_of(const ScreenSurface& surface, std::uint32_t item, const FacePlacement& placed,
             const ScreenPlane& depth, const ScreenPlane& s, const ScreenPlane& t,
             base::Arena& scratch) const {
    const SurfaceDraw& drawn = items_[item];
    if (drawn.kind == ItemKind::kLiquid) return 0;  // they sway by texels of mip 0
    if (settings_.force_mip >= 0) return std::min(settings_.force_mip, 3);
    // Mip levels of other sizes do not repeat where the texture does.
    if (drawn.texture->width % 8 != 0 || drawn.texture->height % 8 != 0) return 0;
    if (settings_.mip_rule == MipRule::kFootprint) {
      // In the middle of what is seen of it.
      const PixelSum seen = seen_of_face(surface, item);
      const double pixels = static_cast<double>(seen.pixels);
      return footprint_mip(view_, depth, s, t, static_cast<double>(seen.x) / pixels,
                           static_cast<double>(seen.y) / pixels);
    }
    const bool whole = surface.tiles.s == 1 && surface.tiles.t == 1;
    const double nearest = whole ? nearest_of_face(surface, scratch) : nearest_in_spans(item, depth);
    return stock_mip(view_, nearest, (glm::length(placed.s_axis) + glm::length(placed.t_axis)) / 2);
  }

  // Of all pieces that the face was cut into, which must look alike: they were entered one after another.
  PixelSum seen_of_face(const ScreenSurface& surface, std::uint32_t item) const {
    const std::uint32_t tile = item - surface.first_item;
    const auto same_face = [&](const ScreenSurface& other) {
      return other.instance == surface.instance && other.face == surface.face;
    };
    std::size_t first = base::to_size(items_[item].surface);
    while (first > 1 && same_face(table_.surfaces[first - 1])) --first;
    PixelSum sum;
    for (std::size_t i = first; i < table_.surfaces.size() && same_face(table_.surfaces[i]); ++i) {
      const PixelSum& piece = seen_[table_.surfaces[i].first_item + tile];
      sum.pixels += piece.pixels;
      sum.x += piece.x;
      sum.y += piece.y;
    }
    return sum;
  }

  double nearest_of_face(const ScreenSurface& surface, base::Arena& scratch) const {
    if (surface.nearest_z > 0) return view_.depth(static_cast<double>(surface.nearest_z));
    const world::Face& face = level_.face(surface.face);
    const std::span<math::Vec3d> corners = scratch.allocate<math::Vec3d>(face.surfedge_count);
    for (std::uint32_t i = 0; i < face.surfedge_count; ++i)
      corners[i] = table_.model_views[surface.instance].to_world(
          math::Vec3d(level_.vertices[level_.surfedge_start(face.first_surfedge + i)]));
    return nearest_depth(view_, corners, scratch);
  }

  // Depth is linear along a run, so its largest value is at an end.
  double nearest_in_spans(std::uint32_t number, const ScreenPlane& depth) const {
    double nearest = view_.depth(1e9);
    for (const Band& band : spans_.bands) {
      const auto found = std::lower_bound(band.items.begin(), band.items.end(), number);
      if (found == band.items.end() || *found != number) continue;
      const auto position = static_cast<std::size_t>(found - band.items.begin());
      for (std::uint32_t i = band.run_begin[position]; i < band.run_begin[position + 1]; ++i) {
        const SpanRun& run = band.runs[i];
        nearest = std::max({nearest, depth.at(run.x, run.y), depth.at(run.x + run.count - 1, run.y)});
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
  const PixelFormat format_;
  const SceneLight light_now_;
  base::Arena& arena_;
  std::span<SurfaceDraw> items_;
  std::span<PixelSum> seen_;  // by item
  std::span<bool> touched_;   // by surface: whether a dynamic light reaches the face
};

// One arena for each of `count` jobs.
void ready_arenas(std::vector<base::Arena>& io_arenas, std::size_t count) {
  if (io_arenas.size() < count) io_arenas.resize(count);
}

}  // namespace

SurfaceDraws prepare_surfaces(const Scene& scene, const Settings& settings, const ViewFrame& view,
                              const EdgeTable& table, const SpanTable& spans, const ColorTables& color_tables,
                              const CutoutTextures& cutouts, const MarkLook* mark_look, PixelFormat format,
                              base::Jobs& jobs, base::Arena& arena, std::vector<base::Arena>& io_job_arenas,
                              SurfaceCache& io_cache, FrameStats& io_stats) {
  SurfaceSelector preparation(scene, settings, view, table, spans, cutouts, format, arena);
  preparation.collect();

  const std::size_t describing_jobs = (table.surfaces.size() + kSurfacesAJob - 1) / kSurfacesAJob;
  ready_arenas(io_job_arenas, describing_jobs);
  jobs.parallel_for(describing_jobs, [&](std::size_t job) {
    io_job_arenas[job].reset();
    const std::size_t end = std::min(table.surfaces.size(), (job + 1) * kSurfacesAJob);
    for (std::size_t surface = std::max<std::size_t>(1, job * kSurfacesAJob); surface < end; ++surface)
      preparation.describe(surface, io_job_arenas[job]);
  });

  io_cache.begin_frame(*scene.level, format == PixelFormat::kIndexed ? 1 : 4, settings.cache_bytes,
                       settings.surface_cache);
  const std::span<const BlockRequest> requests = preparation.request_blocks(io_cache, io_stats);
  io_stats.cache_hits = io_cache.counts().hits;
  io_stats.cache_misses = io_cache.counts().misses;
  io_stats.cache_evictions = io_cache.counts().evictions;
  io_stats.over_budget = io_cache.counts().over_budget;
  io_stats.cache_bytes = io_cache.bytes_in_use();

  const std::size_t build_jobs =
      std::min<std::size_t>(requests.size(), static_cast<std::size_t>(jobs.threads()) * 8);
  ready_arenas(io_job_arenas, build_jobs);
  jobs.parallel_for(build_jobs, [&](std::size_t job) {
    for (std::size_t i = job; i < requests.size(); i += build_jobs)
      build_surface(*scene.level, color_tables, mark_look, requests[i], format, settings.vector_kernels,
                    io_job_arenas[job]);
  });
  return {preparation.items(), table.first_deferred_item()};
}

}  // namespace temblor::render
