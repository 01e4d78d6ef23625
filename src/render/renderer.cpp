#include "render/renderer.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/arena.h"
#include "base/check.h"
#include "render/color/color_tables.h"
#include "render/edges/edge_table.h"
#include "render/edges/span_table.h"
#include "render/frame/banded_picture.h"
#include "render/frame/stage_clock.h"
#include "render/screen/draw_overlay.h"
#include "render/screen/show.h"
#include "render/screen/tint_picture.h"
#include "render/screen/warp.h"
#include "render/surfaces/cutout_textures.h"
#include "render/surfaces/surface_cache.h"
#include "render/surfaces/surface_draws.h"
#include "render/translucent/draw_translucent.h"
#include "render/view/level_tables.h"
#include "render/view/view_frame.h"
#include "render/view/visible_faces.h"

namespace temblor::render {

namespace {

// As many rows as keep a band's pixels within the second-level cache, and bands enough for every thread.
int choose_band_rows(const Settings& settings, int width, int height, PixelFormat format) {
  if (settings.band_rows > 0) return std::min(settings.band_rows, height);
  constexpr int kBandBytes = 768 << 10;
  constexpr int kBandsAThread = 6;
  const int row_bytes = width * (format == PixelFormat::kIndexed ? 5 : 8);
  int rows = std::clamp(kBandBytes / row_bytes, 8, 256);
  if (settings.threads > 1) rows = std::min(rows, std::max(8, height / (settings.threads * kBandsAThread)));
  return std::min(rows, height);
}

// Whether anything is drawn after the edge list.
bool needs_depth(const Scene& scene, const EdgeTable& edges) {
  return edges.deferred_count() > 0 || scene.fog.density > 0;
}

void count_models(std::span<const PreparedAlias> models, FrameStats& io_stats) {
  io_stats.models = static_cast<std::uint32_t>(models.size());
  for (const PreparedAlias& model : models)
    io_stats.triangles += static_cast<std::uint32_t>(model.job.triangle_count);
}

void count_seen(const EdgeTable& edges, const SpanTable& spans, const SurfaceDraws& items,
                FrameStats& io_stats) {
  for (const Band& band : spans.bands) io_stats.spans += static_cast<std::uint32_t>(band.runs.size());
  const auto is_seen = [&](const ScreenSurface& surface) {
    const auto own = items.items.subspan(surface.first_item, std::size_t{surface.tiles.s} * surface.tiles.t);
    return std::any_of(own.begin(), own.end(),
                       [](const SurfaceDraw& item) { return item.kind != ItemKind::kUnused; });
  };
  const ScreenSurface* last_seen = nullptr;
  for (const ScreenSurface& surface : edges.surfaces.subspan(1)) {
    if (!is_seen(surface)) continue;
    // The pieces of a brush model's face were entered one after another, and count once.
    const bool again =
        last_seen != nullptr && last_seen->instance == surface.instance && last_seen->face == surface.face;
    io_stats.faces_seen += !again;
    last_seen = &surface;
  }
}

bool has_liquid(const world::Level& level) {
  return std::ranges::any_of(level.leaves, [](const world::Leaf& leaf) {
    return leaf.contents <= world::Contents::kWater && leaf.contents != world::Contents::kSky;
  });
}

}  // namespace

struct Renderer::State {
  explicit State(ColorTables tables) : color_tables(std::move(tables)) {}

  ColorTables color_tables;
  std::optional<MarkLook> mark_look;  // made for the first marks
  std::optional<base::Jobs> jobs;
  base::JobBackend job_backend{};
  base::Arena arena;
  std::vector<EdgeJobArenas> edge_arenas;
  std::vector<base::Arena> band_arenas, job_arenas, model_arenas;
  std::vector<std::uint8_t> pvs_row;
  std::shared_ptr<const world::LevelIdentity> level;
  bool level_has_liquid = false;
  LevelTables level_tables;
  FaceOutlines face_outlines;
  CutoutTextures cutouts;
  SurfaceCache cache;
  PreparedSkybox skybox;
  FogTables fog_tables;
  Warp warp;

  // The last frame, for pixel_faces: it lives in the arenas until the next one.
  int width = 0, height = 0, band_rows = 0;
  EdgeTable edges;
  SpanTable spans;
  SurfaceDraws items;

  void apply_settings(const Settings& settings) {
    const int threads = std::max(1, settings.threads);
    if (jobs && jobs->threads() == threads && job_backend == settings.job_backend) return;
    jobs.emplace(threads, settings.job_backend);
    job_backend = settings.job_backend;
  }
  void follow_level(const world::Level& now, const FrameBuffer& frame) {
    if (level != now.identity) set_level(now);
    // Also where the picture's size or format has changed since: one dives without waiting for memory.
    if (level_has_liquid) warp.prepare(frame);
  }
  void set_level(const world::Level& now) {
    level = now.identity;
    level_has_liquid = has_liquid(now);
    level_tables = make_level_tables(now);
    face_outlines = make_face_outlines(now);
    cutouts = CutoutTextures(now, color_tables);
  }

  // What has been made ready in edges, spans and items -> pixels.
  void draw_pixels(const Scene& scene, const Settings& settings, const ViewFrame& view,
                   const VisibleFaces& visible, StageClock& io_clock, FrameStats& io_stats,
                   FrameBuffer& io_frame);
  void prepare_models(const Scene& scene, const Settings& settings, const ViewFrame& view, PixelFormat format,
                      StageClock& io_clock, FrameStats& io_stats, BandedPicture& io_picture);
};

Renderer::Renderer(const formats::Palette& palette, const formats::Colormap& colormap)
    : state_(std::make_unique<State>(make_color_tables(palette, colormap))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::State::prepare_models(const Scene& scene, const Settings& settings, const ViewFrame& view,
                                     PixelFormat format, StageClock& io_clock, FrameStats& io_stats,
                                     BandedPicture& io_picture) {
  io_picture.alias_models =
      prepare_alias_models(scene, settings, view, color_tables, format, *jobs, arena, model_arenas);
  count_models(io_picture.alias_models, io_stats);
  io_clock.end(Stage::kModels);
  io_picture.sprites = place_sprites(scene, view, arena);
  io_clock.end(Stage::kSprites);
  io_picture.particles =
      place_particles(scene, settings, view, band_rows, color_tables, format, *jobs, arena);
  io_stats.particles = static_cast<std::uint32_t>(scene.particles.size());
  io_clock.end(Stage::kParticles);
}

void Renderer::State::draw_pixels(const Scene& scene, const Settings& settings, const ViewFrame& view,
                                  const VisibleFaces& visible, StageClock& io_clock, FrameStats& io_stats,
                                  FrameBuffer& io_frame) {
  const PixelFormat format = io_frame.format();
  const SpanSources sources =
      prepare_span_sources(scene, settings, view, items, color_tables, format, skybox, arena);
  const FrameFog fog(scene.fog, view.perspective, format, color_tables, fog_tables, settings.vector_kernels);
  const LateTarget deferred_target{spans, edges, sources, color_tables, fog, view};
  const DeferredFaces late = sort_deferred_faces(scene, visible, edges, spans, items, arena);
  const std::span<const TranslucentLayer> layers =
      sort_translucent(scene, view, visible, late.translucent, arena);
  const std::size_t banded_layers = leading_faces(layers);
  io_clock.end(Stage::kTranslucent);
  const PictureTint tint(scene.tint, color_tables, format, settings.vector_kernels);
  const bool is_tinted_by_bands = banded_layers == layers.size() && !scene.underwater;
  io_clock.end(Stage::kScreen);

  BandedPicture picture{.world = deferred_target,
                        .opaque_faces = late.opaque,
                        .translucent_faces = late.translucent.first(banded_layers),
                        .tint = is_tinted_by_bands ? tint : PictureTint()};
  if (settings.fill_depth) prepare_models(scene, settings, view, format, io_clock, io_stats, picture);
  StageTimes turns;
  draw_banded_picture(picture, settings, *jobs, arena, job_arenas, io_frame, turns);
  io_clock.end_in_parts(turns);

  if (settings.fill_depth)
    draw_translucent(scene, settings, layers.subspan(banded_layers), late.translucent, deferred_target, *jobs,
                     arena, job_arenas, io_frame);
  io_clock.end(Stage::kTranslucent);
  if (scene.underwater)
    warp.apply(scene.time_s, tint, *jobs, io_frame);
  else if (!is_tinted_by_bands)
    tint_picture(tint, *jobs, io_frame);
  io_clock.end(Stage::kScreen);
}

FrameStats Renderer::render(const Scene& scene, const Settings& asked, FrameBuffer& io_frame) {
  CHECK(scene.level != nullptr);
  Settings settings = asked;
  settings.fill_depth |= settings.show == Show::kDepth;
  State& s = *state_;
  FrameStats stats;
  s.apply_settings(settings);
  s.follow_level(*scene.level, io_frame);
  if (has_marks(scene) && !s.mark_look) s.mark_look.emplace(s.color_tables);
  s.arena.reset();
  s.width = io_frame.width();
  s.height = io_frame.height();
  CHECK(s.width >= 1 && s.width <= 8192 && s.height >= 1 && s.height <= 8192, "{}x{}", s.width, s.height);
  s.band_rows = choose_band_rows(settings, s.width, s.height, io_frame.format());

  StageClock clock(stats.stages);
  const ViewFrame view = make_view_frame(scene, s.width, s.height);
  clock.end(Stage::kView);
  const VisibleFaces visible =
      find_visible_faces(*scene.level, s.level_tables, view, world_opacities(scene, s.arena),
                         settings.use_pvs, s.arena, s.pvs_row);
  clock.end(Stage::kVisibility);
  s.edges = emit_edges(scene, view, visible, s.face_outlines, *s.jobs, s.arena, s.edge_arenas);
  clock.end(Stage::kEdges);
  settings.fill_depth |= needs_depth(scene, s.edges);
  s.spans = scan_edges(s.edges, scene, view, s.band_rows, *s.jobs, s.arena, s.band_arenas);
  clock.end(Stage::kScan);
  s.items = prepare_surfaces(scene, settings, view, s.edges, s.spans, s.color_tables, s.cutouts,
                             s.mark_look ? &*s.mark_look : nullptr, io_frame.format(), *s.jobs, s.arena,
                             s.job_arenas, s.cache, stats);
  clock.end(Stage::kSurfaces);
  s.draw_pixels(scene, settings, view, visible, clock, stats, io_frame);

  if (settings.show != Show::kPicture)
    draw_shown(settings.show, {*scene.level, view, s.edges, s.spans, s.items}, s.color_tables.palette,
               io_frame);
  stats.faces_in_pvs = visible.faces_in_pvs;
  stats.faces_drawn = static_cast<std::uint32_t>(s.edges.surfaces.size() - 1);
  stats.edges = static_cast<std::uint32_t>(s.edges.edges.size());
  stats.bands = static_cast<std::uint32_t>(s.spans.bands.size());
  count_seen(s.edges, s.spans, s.items, stats);
  return stats;
}

void Renderer::draw_overlay(const DrawList& list, FrameBuffer& io_frame, FrameStats& io_stats) const {
  StageClock clock(io_stats.stages);
  base::Jobs* const jobs = state_->jobs ? &*state_->jobs : nullptr;  // none before the first view
  render::draw_overlay(list, state_->color_tables, jobs, io_frame);
  clock.end(Stage::kOverlay);
}

void Renderer::pixel_faces(std::span<PixelFace> out_faces, std::span<std::uint8_t> out_writes) const {
  const State& s = *state_;
  const std::size_t pixels = static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height);
  CHECK(out_faces.size() == pixels && out_writes.size() == pixels, "{} pixels", pixels);
  std::fill(out_writes.begin(), out_writes.end(), std::uint8_t{0});
  for (const Band& band : s.spans.bands)
    for (std::size_t position = 0; position < band.items.size(); ++position) {
      if (band.items[position] >= s.items.first_late) break;
      const ScreenSurface& surface =
          s.edges.surfaces[base::to_size(s.items.items[band.items[position]].surface)];
      const PixelFace face = band.items[position] == 0
                                 ? PixelFace{PixelFace::kNothing, 0}
                                 : PixelFace{surface.instance, static_cast<std::uint32_t>(surface.face)};
      for (std::uint32_t i = band.run_begin[position]; i < band.run_begin[position + 1]; ++i) {
        const std::size_t first =
            std::size_t{band.runs[i].y} * static_cast<std::size_t>(s.width) + band.runs[i].x;
        for (std::size_t pixel = first; pixel < first + band.runs[i].count; ++pixel) {
          out_faces[pixel] = face;
          ++out_writes[pixel];
        }
      }
    }
}

void Renderer::drop_surfaces() {
  state_->cache.forget();
}

}  // namespace temblor::render
