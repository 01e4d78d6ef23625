#include "render_gl/gl_renderer.h"

#include "base/check.h"
#include "render/frame/resolve_settings.h"
#include "render/frame/stage_clock.h"
#include "render/screen/debug_view.h"
#include "render_gl/frame/target.h"
#include "render_gl/models/alias_pass.h"
#include "render_gl/particles/particle_pass.h"
#include "render_gl/screen/finish_pass.h"
#include "render_gl/screen/line_pass.h"
#include "render_gl/sprites/sprite_pass.h"
#include "render_gl/world/world_pass.h"

namespace temblor::render_gl {

// The functions come first, since everything below refers to them.
struct GlRenderer::State {
  State(const Functions& functions, render::ColorTables colors) : gl(functions), caches(std::move(colors)) {}

  const Functions gl;
  render::FrameCaches caches;
  std::optional<WorldPass> world;
  std::optional<AliasPass> models;
  std::optional<SpritePass> sprites;
  std::optional<ParticlePass> particles;
  std::optional<FinishPass> finish;
  std::optional<LinePass> lines;
  Target target;
  WorldMethod method = WorldMethod::kLitTextures;

  base::Result<render::FrameRecord> build_surfaces(const render::FrameContext& context,
                                                   const render::FrameBuffer& frame);
  base::Status draw(const FrameInput& input, std::uint32_t background, render::FrameBuffer& io_frame);
};

GlRenderer::GlRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
GlRenderer::~GlRenderer() = default;
GlRenderer::GlRenderer(GlRenderer&&) noexcept = default;
GlRenderer& GlRenderer::operator=(GlRenderer&&) noexcept = default;

base::Result<GlRenderer> GlRenderer::make(const std::function<void*(const char* name)>& find_function,
                                          const formats::Palette& palette, const formats::Colormap& colormap,
                                          const CacheOptions& cache) {
  TRY(const Functions functions, load_functions(find_function));
  auto state = std::make_unique<State>(functions, render::make_color_tables(palette, colormap));
  TRY(state->world, WorldPass::make(state->gl, cache));
  TRY(state->models, AliasPass::make(state->gl, state->caches.colors));
  TRY(state->sprites, SpritePass::make(state->gl));
  TRY(state->particles, ParticlePass::make(state->gl));
  TRY(state->finish, FinishPass::make(state->gl));
  TRY(state->lines, LinePass::make(state->gl));
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
  render::SurfaceRequests requests = render::find_surfaces(context, stages, caches.level, frame, record);
  render::StageClock clock(record.times);
  TRY_STATUS(world->take_lit_tiles(gl, context, choose_options(method, context.settings), requests));
  render::begin_surface_frame(context, caches.surfaces);
  record.surfaces = render::reserve_surfaces(context, requests, caches.surfaces);
  render::build_surfaces(context, record.surfaces, caches.mark_tables ? &*caches.mark_tables : nullptr);
  clock.end(render::Stage::kSurfaces);
  return record;
}

base::Result<render::FrameStats> GlRenderer::render(const render::Scene& scene, const render::Settings& asked,
                                                    render::FrameBuffer& io_frame) {
  CHECK(scene.level != nullptr);
  CHECK(io_frame.format() == render::PixelFormat::kRgb);
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
  const DrawOptions options = choose_options(state_->method, settings);
  const FrameInput input{context, record, sources, order, caches.level, options};
  // Where nothing is drawn, there is only fog.
  const std::uint32_t background =
      fog.is_on() ? render::to_rgb(render::to_bytes(scene.fog.color)) : caches.colors.rgb[0];
  render::StageClock clock(record.times);
  TRY_STATUS(state_->draw(input, background, io_frame));
  clock.end(render::Stage::kSpans);
  if (settings.show != render::Show::kDepth)  // which the card keeps
    render::draw_debug_view(settings.show,
                            {*scene.level, record.view, record.edges, record.spans, record.surfaces.draws},
                            caches.colors.palette, io_frame);
  render::FrameStats stats = render::collect_frame_stats(record, scene);
  state_->models->count(stats);
  return stats;
}

// Brings everything to the card first, then draws in the order of the CPU's stages.
base::Status GlRenderer::State::draw(const FrameInput& input, std::uint32_t background,
                                     render::FrameBuffer& io_frame) {
  using Kind = render::TranslucentLayer::Kind;
  if (target.width() != io_frame.width() || target.height() != io_frame.height()) {
    TRY(target, Target::make(gl, io_frame.width(), io_frame.height()));
  }
  TRY_STATUS(world->prepare(gl, input));
  TRY_STATUS(sprites->prepare(gl, input));
  target.begin(gl, background);
  world->draw_opaque(gl, input);
  TRY_STATUS(models->draw_opaque(gl, input));
  sprites->draw_opaque(gl, input);
  TRY_STATUS(particles->draw(gl, input));
  for (const render::TranslucentLayer& layer : input.order.layers) {
    if (layer.kind == Kind::kFace) world->draw_translucent(gl, input, layer.number);
    if (layer.kind == Kind::kSprite) sprites->draw_translucent(gl, input, layer.number);
    TRY_STATUS(models->draw_translucent(gl, input, layer, target));
  }
  TRY_STATUS(finish->draw(gl, input.scene(), target));
  TRY_STATUS(lines->draw(gl, input.scene(), input.record.view));
  return target.read(gl, io_frame.rgb());
}

CacheCounts GlRenderer::cache_counts() const {
  return state_->world->counts();
}

std::size_t GlRenderer::cache_bytes() const {
  return state_->world->cache_bytes();
}

std::string GlRenderer::describe() const {
  return describe_driver(state_->gl);
}

}  // namespace temblor::render_gl
