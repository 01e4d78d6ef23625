#include "render/renderer.h"

#include <algorithm>

#include "base/check.h"
#include "render/frame/frame_caches.h"
#include "render/frame/render_frame.h"
#include "render/frame/render_views.h"
#include "render/frame/resolve_settings.h"
#include "render/frame/stage_clock.h"
#include "render/screen/draw_overlay.h"

namespace temblor::render {

struct Renderer::State {
  explicit State(ColorTables colors) : caches(std::move(colors)) {}

  FrameCaches caches;
  FrameStages stages;
  // The results of the last frame's stages. They point into the arenas of `caches`; pixel_faces() reads them.
  FrameRecord last;
};

Renderer::Renderer(const formats::Palette& palette, const formats::Colormap& colormap)
    : state_(std::make_unique<State>(make_color_tables(palette, colormap))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

namespace {

void check_input(const Scene& scene, const FrameBuffer& frame) {
  // Spans store x, y, and count as 16-bit numbers.
  constexpr int kMaxSize = 8192;
  const int width = frame.width(), height = frame.height();
  CHECK(scene.level != nullptr);
  CHECK(width >= 1 && width <= kMaxSize && height >= 1 && height <= kMaxSize, "{}x{}", width, height);
}

void set_palette_tint(const Scene& scene, FrameBuffer& io_frame) {
  io_frame.set_palette_tint(io_frame.format() == PixelFormat::kIndexed ? scene.tint : Tint());
}

}  // namespace

FrameStats Renderer::render(const Scene& scene, const Settings& asked, FrameBuffer& io_frame) {
  check_input(scene, io_frame);
  const Settings settings = resolve_settings(asked, scene, io_frame);
  FrameCaches& caches = state_->caches;
  caches.prepare(scene, settings);
  caches.view.prepare(caches.level, io_frame);
  set_palette_tint(scene, io_frame);
  const FrameContext context{scene,         settings,     io_frame.format(),
                             caches.colors, *caches.jobs, caches.view.arenas};
  const FrameRecord& record = state_->last = render_frame(context, state_->stages, caches, io_frame);
  draw_over_picture(context, record, io_frame);
  return collect_frame_stats(record, scene);
}

void Renderer::render_views(std::span<const View> views, const Settings& settings) {
  for (const View& view : views) {
    CHECK(view.scene != nullptr && view.frame != nullptr);
    check_input(*view.scene, *view.frame);
    CHECK(view.scene->level->identity == views.front().scene->level->identity, "views of two levels");
    CHECK(view.frame->format() == views.front().frame->format(), "views in two formats");
    set_palette_tint(*view.scene, *view.frame);
  }
  render::render_views(views, settings, state_->caches);
}

// Const, but runs jobs: an overlay may be drawn before the first frame, when there are no threads yet.
void Renderer::draw_overlay(const DrawList& list, FrameBuffer& io_frame, FrameStats& io_stats) const {
  StageClock clock(io_stats.stages);
  FrameCaches& caches = state_->caches;
  render::draw_overlay(list, caches.colors, caches.jobs ? &*caches.jobs : nullptr, io_frame);
  clock.end(Stage::kOverlay);
}

void Renderer::pixel_faces(std::span<PixelFace> out_faces, std::span<std::uint8_t> out_writes) const {
  const FrameRecord& last = state_->last;
  const SurfaceDraws& draws = last.surfaces.draws;
  const auto width = static_cast<std::size_t>(last.view.width);
  const std::size_t pixels = width * static_cast<std::size_t>(last.view.height);
  CHECK(out_faces.size() == pixels && out_writes.size() == pixels, "{} pixels", pixels);
  std::fill(out_writes.begin(), out_writes.end(), std::uint8_t{0});
  for (const Band& band : last.spans.bands)
    for (std::size_t position = 0; position < band.draws.size(); ++position) {
      const std::uint32_t draw = band.draws[position];
      // Deferred faces overlap the opaque picture, so they would count as overdraw.
      if (draw >= draws.first_deferred) break;
      const ScreenSurface& surface = last.edges.surfaces[base::to_size(draws.all[draw].surface)];
      const PixelFace face = draw == 0
                                 ? PixelFace{PixelFace::kNothing, 0}
                                 : PixelFace{surface.instance, static_cast<std::uint32_t>(surface.face)};
      for (const Span& span : band.spans_at(position)) {
        const std::size_t first = std::size_t{span.y} * width + span.x;
        for (std::size_t pixel = first; pixel < first + span.count; ++pixel) {
          out_faces[pixel] = face;
          ++out_writes[pixel];
        }
      }
    }
}

void Renderer::make_blend_tables() const {
  state_->caches.colors.blends.make_all();
}

void Renderer::replace_stages(const FrameStages& stages) {
  state_->stages = stages;
  // Other stages may build other texels.
  drop_surfaces();
}

void Renderer::drop_surfaces() {
  state_->caches.surfaces.clear();
}

}  // namespace temblor::render
