#include "render/spans/span_sources.h"

#include "render/spans/kernel_planes.h"
#include "render/spans/repeat_spans.h"
#include "render/spans/sky_spans.h"

namespace temblor::render {

namespace {

KernelDivide choose_divide(const Settings& settings, const ViewFrame& view) {
  if (!view.perspective) return KernelDivide::kNone;
  return settings.perspective == Perspective::kExact ? KernelDivide::kEveryPixel : KernelDivide::kAffine;
}

void draw_surface(const SpanSources& sources, const SurfaceDraw& draw, std::span<const Span> spans,
                  const KernelTarget& target) {
  const SurfaceSpans job{kernel_plane(draw.depth),
                         kernel_plane(draw.s),
                         kernel_plane(draw.t),
                         sources.divide,
                         draw.block.texels,
                         draw.block.shape.width,
                         draw.block.shape.width - 1,
                         draw.block.shape.height - 1,
                         spans.data(),
                         spans.size(),
                         sources.affine_pixels};
  if (sources.format == PixelFormat::kIndexed)
    sources.simd_kernels ? draw_surface_spans_u8_simd(job, target)
                         : draw_surface_spans_u8_scalar(job, target);
  else
    sources.simd_kernels ? draw_surface_spans_u32_simd(job, target)
                         : draw_surface_spans_u32_scalar(job, target);
}

void draw_sky(const SpanSources& sources, SkySpans job, const SurfaceDraw& draw, std::span<const Span> spans,
              const KernelTarget& target) {
  job.depth = kernel_plane(draw.depth);
  job.spans = spans.data();
  job.span_count = spans.size();
  if (sources.format == PixelFormat::kIndexed)
    sources.simd_kernels ? draw_sky_spans_u8_simd(job, target) : draw_sky_spans_u8_scalar(job, target);
  else
    sources.simd_kernels ? draw_sky_spans_u32_simd(job, target) : draw_sky_spans_u32_scalar(job, target);
}

void draw_skybox(const SpanSources& sources, SkyboxSpans job, const SurfaceDraw& draw,
                 std::span<const Span> spans, const KernelTarget& target) {
  job.depth = kernel_plane(draw.depth);
  job.spans = spans.data();
  job.span_count = spans.size();
  if (sources.format == PixelFormat::kIndexed)
    sources.simd_kernels ? draw_skybox_spans_u8_simd(job, target) : draw_skybox_spans_u8_scalar(job, target);
  else
    sources.simd_kernels ? draw_skybox_spans_u32_simd(job, target)
                         : draw_skybox_spans_u32_scalar(job, target);
}

void draw_repeating(const SpanSources& sources, RepeatSpans job, std::span<const Span> spans,
                    const KernelTarget& target) {
  job.spans = spans.data();
  job.span_count = spans.size();
  if (sources.format == PixelFormat::kIndexed)
    sources.simd_kernels ? draw_repeat_spans_u8_simd(job, target) : draw_repeat_spans_u8_scalar(job, target);
  else
    sources.simd_kernels ? draw_repeat_spans_u32_simd(job, target)
                         : draw_repeat_spans_u32_scalar(job, target);
}

}  // namespace

SpanSources prepare_span_sources(const FrameContext& context, const ViewFrame& view,
                                 const SurfaceDraws& draws, PreparedSkybox& io_skybox) {
  const Scene& scene = context.scene;
  SpanSources sources{.draws = draws,
                      .skies = {},
                      .repeating = prepare_repeat_spans(context, view, draws),
                      .skybox = {},
                      .skybox_version = 0,
                      .format = context.format,
                      .divide = choose_divide(context.settings, view),
                      .simd_kernels = context.settings.simd_kernels,
                      .fill_depth = context.settings.fill_depth || draws.has_deferred()};
  if (scene.skybox != nullptr) {
    io_skybox.update(*scene.skybox, scene.fog, context.colors, context.format);
    sources.skybox = io_skybox.spans(view);
    sources.skybox_version = io_skybox.version();
  } else {
    sources.skies = prepare_sky_spans(context, view, draws);
  }
  return sources;
}

void draw_spans(const SpanSources& sources, std::uint32_t number, std::span<const Span> spans,
                const KernelTarget& target) {
  const SurfaceDraw& draw = sources.draws.all[number];
  switch (draw.kind) {
    case SurfaceKind::kHidden:
    case SurfaceKind::kNothing:
      break;
    case SurfaceKind::kBlock:
      draw_surface(sources, draw, spans, target);
      break;
    case SurfaceKind::kSky:
      if (sources.skybox)
        draw_skybox(sources, *sources.skybox, draw, spans, target);
      else
        draw_sky(sources, *sources.skies[number], draw, spans, target);
      break;
    case SurfaceKind::kTexture:
    case SurfaceKind::kLiquid:
      draw_repeating(sources, *sources.repeating[number], spans, target);
      break;
  }
}

}  // namespace temblor::render
