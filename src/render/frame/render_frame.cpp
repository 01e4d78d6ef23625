#include "render/frame/render_frame.h"

#include <algorithm>

#include "render/frame/banded_picture.h"
#include "render/frame/stage_clock.h"
#include "render/screen/debug_view.h"
#include "render/screen/draw_lines.h"
#include "render/spans/span_sources.h"
#include "render/translucent/draw_translucent.h"

namespace temblor::render {

namespace {

FrameFog make_fog(const FrameContext& context, const ViewFrame& view, FogTables& io_tables) {
  return {context.scene.fog, view.perspective, context.format,
          context.colors,    io_tables,        context.settings.simd_kernels};
}

void count_models(std::span<const PreparedAlias> models, FrameStats& io_stats) {
  io_stats.models = static_cast<std::uint32_t>(models.size());
  for (const PreparedAlias& model : models)
    io_stats.triangles += static_cast<std::uint32_t>(model.job.triangle_count);
}

// A face counts as seen if any of its draws has spans. Its surfaces follow one another in the table.
void count_spans(const EdgeTable& edges, const SpanTable& spans, const SurfaceDraws& draws,
                 FrameStats& io_stats) {
  for (const Band& band : spans.bands) io_stats.spans += static_cast<std::uint32_t>(band.spans.size());
  const auto is_seen = [&](const ScreenSurface& surface) {
    const auto own = draws.all.subspan(surface.first_draw, std::size_t{surface.tiles.s} * surface.tiles.t);
    return std::ranges::any_of(own,
                               [](const SurfaceDraw& draw) { return draw.kind != SurfaceKind::kHidden; });
  };
  const ScreenSurface* last_seen = nullptr;
  for (const ScreenSurface& surface : edges.surfaces.subspan(1)) {
    if (!is_seen(surface)) continue;
    // The fragments of a brush model's face are adjacent and count once.
    const bool same_face =
        last_seen != nullptr && last_seen->instance == surface.instance && last_seen->face == surface.face;
    io_stats.faces_seen += !same_face;
    last_seen = &surface;
  }
}

void count_surfaces(const SurfaceBlocks& blocks, FrameStats& io_stats) {
  const SurfaceCounts& counts = blocks.counts;
  io_stats.surfaces = counts.surfaces;
  io_stats.cache_hits = counts.cache.hits;
  io_stats.cache_misses = counts.cache.misses;
  io_stats.cache_evictions = counts.cache.evictions;
  io_stats.over_budget = counts.cache.over_budget;
  io_stats.cache_bytes = counts.cache_bytes;
  io_stats.surfaces_built = static_cast<std::uint32_t>(blocks.missing.size());
  io_stats.texels_built = counts.texels_built;
  io_stats.texels_read = counts.texels;
}

}  // namespace

// Each line is one stage; clock.end() attributes its time.
SurfaceRequests find_surfaces(const FrameContext& context, const FrameStages& stages, const LevelData& level,
                              const FrameBuffer& frame, FrameRecord& io_record) {
  FrameRecord& f = io_record;
  StageClock clock(f.times);
  f.view = clock.end(Stage::kView, make_view_frame(context.scene, frame.width(), frame.height()));
  f.visible = clock.end(Stage::kVisibility, stages.find_visible_faces(context, f.view, level.tables));
  f.edges = clock.end(Stage::kEdges, emit_edges(context, f.view, f.visible, level.outlines));
  f.spans = clock.end(Stage::kScan, stages.scan_edges(context, f.view, f.edges));
  return clock.end(Stage::kSurfaces,
                   select_surfaces(context, f.view, f.edges, f.spans, level.cutouts, level.water_faces));
}

void draw_surfaces(const FrameContext& context, const FrameStages& stages, PreparedSkybox& io_skybox,
                   ViewCaches& io_view, FrameRecord& io_record, FrameBuffer& io_frame) {
  FrameRecord& f = io_record;
  StageClock clock(f.times);
  const SpanSources sources = prepare_span_sources(context, f.view, f.surfaces.draws, io_skybox);
  const FrameFog fog = make_fog(context, f.view, io_view.fog_tables);
  const WorldPicture world{f.spans, f.edges, sources, context.colors, fog, f.view};
  const TranslucentOrder order = clock.end(Stage::kTranslucent, sort_translucent(context, world, f.visible));
  BandedPicture picture = clock.end(Stage::kScreen, make_banded_picture(context, stages, world, order));
  f.has_models = sources.fill_depth;
  if (f.has_models) {
    f.alias_models = picture.alias_models =
        clock.end(Stage::kModels, stages.prepare_alias_models(context, f.view));
    picture.sprites = clock.end(Stage::kSprites, place_sprites(context.scene, f.view, context.arena()));
    picture.particles = clock.end(Stage::kParticles, place_particles(context, f.view));
  }
  clock.end_in_parts(draw_banded_picture(context, picture, io_frame));
  draw_translucent(context, order, world, io_frame);
  clock.end(Stage::kTranslucent);
  finish_picture(context, picture, io_view.warp, io_frame);
  clock.end(Stage::kScreen);
}

FrameRecord render_frame(const FrameContext& context, const FrameStages& stages, FrameCaches& io_caches,
                         FrameBuffer& io_frame) {
  FrameRecord f;
  const SurfaceRequests requests = find_surfaces(context, stages, io_caches.level, io_frame, f);
  StageClock clock(f.times);
  begin_surface_frame(context, io_caches.surfaces);
  f.surfaces = stages.reserve_surfaces(context, requests, io_caches.surfaces);
  stages.build_surfaces(context, f.surfaces, io_caches.mark_tables ? &*io_caches.mark_tables : nullptr);
  clock.end(Stage::kSurfaces);
  draw_surfaces(context, stages, io_caches.skybox, io_caches.view, f, io_frame);
  return f;
}

void draw_over_picture(const FrameContext& context, const FrameRecord& record, FrameBuffer& io_frame) {
  draw_debug_view(context.settings.show,
                  {context.level(), record.view, record.edges, record.spans, record.surfaces.draws},
                  context.colors.palette, io_frame);
  draw_lines(context.scene.lines, record.view, context.colors.palette, io_frame);
}

FrameStats collect_frame_stats(const FrameRecord& record, const Scene& scene) {
  FrameStats stats;
  stats.stages = record.times;
  stats.faces_in_pvs = record.visible.faces_in_pvs;
  stats.faces_drawn = static_cast<std::uint32_t>(record.edges.surfaces.size() - 1);  // less the background
  stats.edges = static_cast<std::uint32_t>(record.edges.edges.size());
  stats.bands = static_cast<std::uint32_t>(record.spans.bands.size());
  count_spans(record.edges, record.spans, record.surfaces.draws, stats);
  count_surfaces(record.surfaces, stats);
  count_models(record.alias_models, stats);
  if (record.has_models) stats.particles = static_cast<std::uint32_t>(scene.particles.size());
  return stats;
}

}  // namespace temblor::render
