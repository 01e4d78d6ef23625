#include "render_gl/gl_renderer.h"

#include "base/check.h"
#include "render/frame/resolve_settings.h"
#include "render/frame/stage_clock.h"
#include "render/screen/debug_view.h"
#include "render/screen/draw_overlay.h"
#include "render_gl/frame/target.h"
#include "render_gl/gl/card_timer.h"
#include "render_gl/models/alias_pass.h"
#include "render_gl/overlay/overlay_pass.h"
#include "render_gl/particles/particle_pass.h"
#include "render_gl/screen/depth_reader.h"
#include "render_gl/screen/finish_pass.h"
#include "render_gl/screen/line_pass.h"
#include "render_gl/sprites/sprite_pass.h"
#include "render_gl/world/world_pass.h"

namespace temblor::render_gl {

namespace {

// All passes, and their picture, for frames of one format.
struct Passes {
  static base::Result<Passes> make(const Functions& gl, const CacheOptions& cache,
                                   const render::ColorTables& colors, render::PixelFormat format);

  render::PixelFormat format;
  WorldPass world;
  AliasPass models;
  SpritePass sprites;
  ParticlePass particles;
  FinishPass finish;
  LinePass lines;
  OverlayPass overlay;
  PresentPass present;
  IndexTables index_tables = {};                 // indexed frames only
  std::optional<DepthReader> depth_reader = {};  // once depth was shown
  Target target = {};
};

base::Result<Passes> Passes::make(const Functions& gl, const CacheOptions& cache,
                                  const render::ColorTables& colors, render::PixelFormat format) {
  TRY(WorldPass world, WorldPass::make(gl, cache, format));
  TRY(AliasPass models, AliasPass::make(gl, colors, format));
  TRY(SpritePass sprites, SpritePass::make(gl, format));
  TRY(ParticlePass particles, ParticlePass::make(gl, format));
  TRY(FinishPass finish, FinishPass::make(gl));
  TRY(LinePass lines, LinePass::make(gl));
  TRY(OverlayPass overlay, OverlayPass::make(gl, format));
  TRY(PresentPass present, PresentPass::make(gl, format));
  return Passes{format,
                std::move(world),
                std::move(models),
                std::move(sprites),
                std::move(particles),
                std::move(finish),
                std::move(lines),
                std::move(overlay),
                std::move(present)};
}

}  // namespace

// The functions come first, since everything below refers to them.
struct GlRenderer::State {
  State(const Functions& functions, render::ColorTables colors, const CacheOptions& options)
      : gl(functions), timer(gl), caches(std::move(colors)), cache(options) {}

  // A query that runs longer than its context's renderer would hinder the next one.
  ~State() { timer.end(gl); }

  const Functions gl;
  CardTimer timer;
  render::FrameCaches caches;
  const CacheOptions cache;
  std::optional<Passes> passes;  // of the last frame's format; none after a failure

  WorldMethod method = WorldMethod::kBlocks;

  base::Result<render::FrameRecord> build_surfaces(const render::FrameContext& context,
                                                   const render::FrameBuffer& frame);
  base::Status set_format(render::PixelFormat format);
  base::Status begin(const render::FrameBuffer& frame);
  base::Status draw(const FrameInput& input, std::uint32_t background);
  base::Status read(render::FrameBuffer& io_frame);
  base::Status read_depth(const render::ViewFrame& view, render::FrameBuffer& io_frame);
};

// The old ones go first: the card may lack memory for both.
base::Status GlRenderer::State::set_format(render::PixelFormat format) {
  if (passes && passes->format == format) return base::Ok{};
  passes.reset();
  TRY(passes, Passes::make(gl, cache, caches.colors, format));
  return base::Ok{};
}

GlRenderer::GlRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
GlRenderer::~GlRenderer() = default;
GlRenderer::GlRenderer(GlRenderer&&) noexcept = default;
GlRenderer& GlRenderer::operator=(GlRenderer&&) noexcept = default;

base::Result<GlRenderer> GlRenderer::make(const std::function<void*(const char* name)>& find_function,
                                          const formats::Palette& palette, const formats::Colormap& colormap,
                                          const CacheOptions& cache) {
  TRY(const Functions functions, load_functions(find_function));
  auto state = std::make_unique<State>(functions, render::make_color_tables(palette, colormap), cache);
  TRY_STATUS(state->set_format(render::PixelFormat::kRgb));
  return GlRenderer(std::move(state));
}

void GlRenderer::set_method(WorldMethod method) {
  state_->method = method;
}

// The stages on the CPU: everything up to the lit texels of the visible surfaces that have blocks.
base::Result<render::FrameRecord> GlRenderer::State::build_surfaces(const render::FrameContext& context,
                                                                    const render::FrameBuffer& frame) {
  const render::FrameStages stages;
  render::FrameRecord record;
  const DrawOptions options = choose_options(method, context);
  const render::FrameContext blocks{context.scene,  context.settings, find_block_format(options, context),
                                    context.colors, context.jobs,     context.arenas};
  render::SurfaceRequests requests = render::find_surfaces(blocks, stages, caches.level, frame, record);
  render::StageClock clock(record.times);
  TRY_STATUS(passes->world.take_lit_tiles(gl, context, options, requests));
  render::begin_surface_frame(blocks, caches.surfaces);
  record.surfaces = render::reserve_surfaces(blocks, requests, caches.surfaces);
  render::build_surfaces(blocks, record.surfaces, caches.mark_tables ? &*caches.mark_tables : nullptr);
  clock.end(render::Stage::kSurfaces);
  return record;
}

namespace {

// The tables that FrameFog has made.
const std::uint8_t* find_fog_rows(const render::FrameContext& context, render::ViewCaches& io_view) {
  return io_view.fog_tables.rows_for(context.scene.fog.color, context.colors.palette, context.colors.match);
}

// Where nothing is drawn, there is only fog. `fog_rows`: of indexed frames with fog.
std::uint32_t find_background(const render::FrameContext& context, const std::uint8_t* fog_rows) {
  if (context.is_indexed()) return fog_rows == nullptr ? 0 : fog_rows[std::size_t{render::kFogSteps} * 256];
  const render::Fog& fog = context.scene.fog;
  return fog.density > 0 ? render::to_rgb(render::to_bytes(fog.color)) : context.colors.rgb[0];
}

}  // namespace

base::Result<render::FrameStats> GlRenderer::render(const render::Scene& scene, const render::Settings& asked,
                                                    render::FrameBuffer& io_frame) {
  TRY(render::FrameStats stats, draw(scene, asked, io_frame));
  TRY_STATUS(read(io_frame));
  return stats;
}

base::Result<render::FrameStats> GlRenderer::draw(const render::Scene& scene, const render::Settings& asked,
                                                  render::FrameBuffer& io_frame) {
  CHECK(scene.level != nullptr);
  TRY_STATUS(state_->begin(io_frame));
  const render::Settings settings = render::resolve_settings(asked, scene, io_frame);
  render::FrameCaches& caches = state_->caches;
  caches.prepare(scene, settings);
  caches.view.prepare(caches.level, io_frame);
  const render::FrameContext context{scene,         settings,     io_frame.format(),
                                     caches.colors, *caches.jobs, caches.view.arenas};
  TRY(render::FrameRecord record, state_->build_surfaces(context, io_frame));
  const render::SpanSources sources =
      render::prepare_span_sources(context, record.view, record.surfaces.draws, caches.skybox);
  record.has_models = sources.fill_depth;
  const render::FrameFog fog(scene.fog, record.view.perspective, io_frame.format(), caches.colors,
                             caches.view.fog_tables, settings.simd_kernels);
  const render::TranslucentOrder order = render::sort_translucent(
      context, {record.spans, record.edges, sources, caches.colors, fog, record.view}, record.visible);
  IndexTables* const index_tables = context.is_indexed() ? &state_->passes->index_tables : nullptr;
  const std::uint8_t* const fog_rows =
      fog.is_on() && context.is_indexed() ? find_fog_rows(context, caches.view) : nullptr;
  if (index_tables != nullptr) TRY_STATUS(index_tables->set_fog(state_->gl, fog_rows));
  const DrawOptions options = choose_options(state_->method, context);
  const FrameInput input{context, record, sources, order, caches.level, options, index_tables};
  const std::uint32_t background = find_background(context, fog_rows);
  io_frame.set_palette_tint(context.is_indexed() ? scene.tint : render::Tint());
  render::StageClock clock(record.times);
  TRY_STATUS(state_->draw(input, background));
  clock.end(render::Stage::kSpans);
  if (settings.show != render::Show::kPicture) {
    if (settings.show == render::Show::kDepth)
      TRY_STATUS(state_->read_depth(record.view, io_frame));
    else
      TRY_STATUS(state_->read(io_frame));
    render::draw_debug_view(settings.show,
                            {*scene.level, record.view, record.edges, record.spans, record.surfaces.draws},
                            caches.colors.palette, io_frame);
    state_->passes->target.write(state_->gl, io_frame);
  }
  render::FrameStats stats = render::collect_frame_stats(record, scene);
  state_->passes->models.count(stats);
  return stats;
}

base::Status GlRenderer::State::begin(const render::FrameBuffer& frame) {
  TRY_STATUS(gl.check_context());
  TRY_STATUS(set_format(frame.format()));
  Target& target = passes->target;
  if (target.has_layout(frame.width(), frame.height(), frame.format())) return base::Ok{};
  TRY(target, Target::make(gl, frame.width(), frame.height(), frame.format()));
  return base::Ok{};
}

// Brings everything to the card first, then draws in the order of the CPU's stages.
base::Status GlRenderer::State::draw(const FrameInput& input, std::uint32_t background) {
  using Kind = render::TranslucentLayer::Kind;
  Passes& p = *passes;
  timer.begin(gl, {p.target.width(), p.target.height()});
  TRY_STATUS(p.world.prepare(gl, input));
  TRY_STATUS(p.sprites.prepare(gl, input));
  p.target.begin(gl, background);
  p.world.draw_opaque(gl, input, p.target);
  TRY_STATUS(p.models.draw_opaque(gl, input));
  p.sprites.draw_opaque(gl, input);
  TRY_STATUS(p.particles.draw(gl, input));
  for (const render::TranslucentLayer& layer : input.order.layers) {
    if (layer.kind == Kind::kFace) TRY_STATUS(p.world.draw_translucent(gl, input, layer.number, p.target));
    if (layer.kind == Kind::kSprite)
      TRY_STATUS(p.sprites.draw_translucent(gl, input, layer.number, p.target));
    TRY_STATUS(p.models.draw_translucent(gl, input, layer, p.target));
  }
  TRY_STATUS(p.finish.draw(gl, input.scene(), p.target));
  return p.lines.draw(gl, input);
}

base::Status GlRenderer::State::read(render::FrameBuffer& io_frame) {
  timer.end(gl);
  const Target& target = passes->target;
  if (target.format() == render::PixelFormat::kIndexed) return target.read(gl, io_frame.indexed());
  return target.read(gl, io_frame.rgb());
}

base::Status GlRenderer::State::read_depth(const render::ViewFrame& view, render::FrameBuffer& io_frame) {
  timer.end(gl);
  std::optional<DepthReader>& reader = passes->depth_reader;
  if (!reader) {
    TRY(reader, DepthReader::make(gl));
  }
  return reader->read(gl, view, passes->target, io_frame.depth());
}

base::Status GlRenderer::clear(const render::FrameBuffer& frame) {
  TRY_STATUS(state_->begin(frame));
  const render::ColorTables& colors = state_->caches.colors;
  const bool is_indexed = frame.format() == render::PixelFormat::kIndexed;
  state_->timer.begin(state_->gl, {frame.width(), frame.height()});
  state_->passes->target.begin(state_->gl, is_indexed ? 0u : colors.rgb[0]);
  return base::Ok{};
}

base::Status GlRenderer::draw_overlay(const render::DrawList& overlay, render::FrameBuffer& io_frame) {
  Passes& p = *state_->passes;
  render::FrameCaches& caches = state_->caches;
  TRY(const bool is_drawn, p.overlay.draw(state_->gl, overlay, caches.colors, p.index_tables, p.target));
  if (is_drawn) return base::Ok{};
  TRY_STATUS(state_->read(io_frame));
  render::draw_overlay(overlay, caches.colors, caches.jobs ? &*caches.jobs : nullptr, io_frame);
  p.target.write(state_->gl, io_frame);
  return base::Ok{};
}

base::Status GlRenderer::read(render::FrameBuffer& io_frame) const {
  if (!state_->passes ||
      !state_->passes->target.has_layout(io_frame.width(), io_frame.height(), io_frame.format()))
    return base::error(base::ErrorCode::kUsage, "nothing has been drawn yet");
  return state_->read(io_frame);
}

base::Status GlRenderer::show(const Shown& shown) {
  // Drivers may wait for the display before they draw into the window.
  state_->timer.end(state_->gl);
  return state_->passes->present.draw(state_->gl, state_->passes->target, shown);
}

void GlRenderer::make_blend_tables() const {
  state_->caches.colors.blends.make_all();
}

bool GlRenderer::has_card_timer() const {
  return state_->gl.has_timer;
}

std::optional<double> GlRenderer::card_seconds() const {
  return state_->timer.seconds();
}

CacheCounts GlRenderer::cache_counts() const {
  return state_->passes ? state_->passes->world.counts() : CacheCounts{};
}

std::size_t GlRenderer::cache_bytes() const {
  return state_->passes ? state_->passes->world.cache_bytes() : 0;
}

std::string GlRenderer::describe() const {
  return describe_driver(state_->gl);
}

}  // namespace temblor::render_gl
