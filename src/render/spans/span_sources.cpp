#include "render/spans/span_sources.h"

#include "render/spans/kernel_planes.h"
#include "render/spans/repeat_spans.h"
#include "render/spans/sky_spans.h"

namespace temblor::render {

namespace {

KernelDivide divide_of(const Settings& settings, const ViewFrame& view) {
  if (!view.perspective) return KernelDivide::kNone;
  return settings.perspective == Perspective::kExact ? KernelDivide::kEveryPixel : KernelDivide::kEvery16;
}

void draw_surface(const SpanSources& sources, const SurfaceDraw& item, std::span<const SpanRun> runs,
                  const KernelTarget& target) {
  const SurfaceRuns job{kernel_plane(item.depth),
                        kernel_plane(item.s),
                        kernel_plane(item.t),
                        sources.divide,
                        item.block.texels,
                        item.block.shape.width,
                        item.block.shape.width - 1,
                        item.block.shape.height - 1,
                        runs.data(),
                        runs.size()};
  if (sources.format == PixelFormat::kIndexed)
    sources.vector_kernels ? draw_surface_runs_u8_simd(job, target)
                           : draw_surface_runs_u8_scalar(job, target);
  else
    sources.vector_kernels ? draw_surface_runs_u32_simd(job, target)
                           : draw_surface_runs_u32_scalar(job, target);
}

void draw_sky(const SpanSources& sources, SkyRuns job, const SurfaceDraw& item, std::span<const SpanRun> runs,
              const KernelTarget& target) {
  job.depth = kernel_plane(item.depth);
  job.runs = runs.data();
  job.run_count = runs.size();
  if (sources.format == PixelFormat::kIndexed)
    sources.vector_kernels ? draw_sky_runs_u8_simd(job, target) : draw_sky_runs_u8_scalar(job, target);
  else
    sources.vector_kernels ? draw_sky_runs_u32_simd(job, target) : draw_sky_runs_u32_scalar(job, target);
}

void draw_skybox(const SpanSources& sources, SkyboxRuns job, const SurfaceDraw& item,
                 std::span<const SpanRun> runs, const KernelTarget& target) {
  job.depth = kernel_plane(item.depth);
  job.runs = runs.data();
  job.run_count = runs.size();
  if (sources.format == PixelFormat::kIndexed)
    sources.vector_kernels ? draw_skybox_runs_u8_simd(job, target) : draw_skybox_runs_u8_scalar(job, target);
  else
    sources.vector_kernels ? draw_skybox_runs_u32_simd(job, target)
                           : draw_skybox_runs_u32_scalar(job, target);
}

void draw_repeating(const SpanSources& sources, RepeatRuns job, std::span<const SpanRun> runs,
                    const KernelTarget& target) {
  job.runs = runs.data();
  job.run_count = runs.size();
  if (sources.format == PixelFormat::kIndexed)
    sources.vector_kernels ? draw_repeat_runs_u8_simd(job, target) : draw_repeat_runs_u8_scalar(job, target);
  else
    sources.vector_kernels ? draw_repeat_runs_u32_simd(job, target)
                           : draw_repeat_runs_u32_scalar(job, target);
}

}  // namespace

SpanSources prepare_span_sources(const Scene& scene, const Settings& settings, const ViewFrame& view,
                                 const SurfaceDraws& items, const ColorTables& tables, PixelFormat format,
                                 PreparedSkybox& io_skybox, base::Arena& arena) {
  std::optional<SkyboxRuns> skybox;
  std::span<const SkyRuns*> skies;
  if (scene.skybox != nullptr) {
    io_skybox.follow(*scene.skybox, scene.fog, tables, format);
    skybox = io_skybox.runs(view);
  } else {
    skies = prepare_sky_runs(scene, view, items, tables, format, arena);
  }
  return {items,
          skies,
          prepare_repeat_runs(scene, view, items, tables, format, arena),
          skybox,
          format,
          divide_of(settings, view),
          settings.vector_kernels};
}

void draw_runs(const SpanSources& sources, std::uint32_t number, std::span<const SpanRun> runs,
               const KernelTarget& target) {
  const SurfaceDraw& item = sources.items.items[number];
  switch (item.kind) {
    case ItemKind::kUnused:
    case ItemKind::kNothing:
      break;
    case ItemKind::kSurface:
      draw_surface(sources, item, runs, target);
      break;
    case ItemKind::kSky:
      if (sources.skybox)
        draw_skybox(sources, *sources.skybox, item, runs, target);
      else
        draw_sky(sources, *sources.skies[number], item, runs, target);
      break;
    case ItemKind::kTexture:
    case ItemKind::kLiquid:
      draw_repeating(sources, *sources.repeating[number], runs, target);
      break;
  }
}

}  // namespace temblor::render
