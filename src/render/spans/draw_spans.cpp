#include "render/spans/draw_spans.h"

#include <algorithm>
#include <limits>

#include "render/spans/kernel_planes.h"
#include "render/spans/prefetch_texels.h"
#include "render/spans/repeat_runs.h"
#include "render/spans/sky_runs.h"
#include "render/spans/span_kernels.h"

namespace temblor::render {

namespace {

KernelDivide divide_of(const Settings& settings, const ViewFrame& view) {
  if (!view.perspective) return KernelDivide::kNone;
  return settings.perspective == Perspective::kExact ? KernelDivide::kEveryPixel : KernelDivide::kEvery16;
}

void draw_surface(const DrawItem& item, std::span<const SpanRun> runs, KernelDivide divide,
                  bool vector_kernels, const KernelTarget& target, PixelFormat format) {
  const SurfaceRuns job{kernel_plane(item.depth),
                        kernel_plane(item.s),
                        kernel_plane(item.t),
                        divide,
                        item.block.texels,
                        item.block.shape.width,
                        item.block.shape.width - 1,
                        item.block.shape.height - 1,
                        runs.data(),
                        runs.size()};
  if (format == PixelFormat::kIndexed)
    vector_kernels ? draw_surface_runs_u8_vector(job, target) : draw_surface_runs_u8_plain(job, target);
  else
    vector_kernels ? draw_surface_runs_u32_vector(job, target) : draw_surface_runs_u32_plain(job, target);
}

void draw_sky(SkyRuns job, const DrawItem& item, std::span<const SpanRun> runs, bool vector_kernels,
              const KernelTarget& target, PixelFormat format) {
  job.depth = kernel_plane(item.depth);
  job.runs = runs.data();
  job.run_count = runs.size();
  if (format == PixelFormat::kIndexed)
    vector_kernels ? draw_sky_runs_u8_vector(job, target) : draw_sky_runs_u8_plain(job, target);
  else
    vector_kernels ? draw_sky_runs_u32_vector(job, target) : draw_sky_runs_u32_plain(job, target);
}

void draw_repeating(RepeatRuns job, std::span<const SpanRun> runs, bool vector_kernels,
                    const KernelTarget& target, PixelFormat format) {
  job.runs = runs.data();
  job.run_count = runs.size();
  if (format == PixelFormat::kIndexed)
    vector_kernels ? draw_repeat_runs_u8_vector(job, target) : draw_repeat_runs_u8_plain(job, target);
  else
    vector_kernels ? draw_repeat_runs_u32_vector(job, target) : draw_repeat_runs_u32_plain(job, target);
}

// Where nothing is: palette entry 0, infinitely far.
void draw_background(std::span<const SpanRun> runs, const ColourTables& tables, bool fill_depth,
                     FrameBuffer& io_frame) {
  for (const SpanRun& run : runs) {
    const std::size_t first = std::size_t{run.y} * static_cast<std::size_t>(io_frame.width()) + run.x;
    if (io_frame.format() == PixelFormat::kIndexed)
      std::fill_n(io_frame.indexed().data() + first, run.count, std::uint8_t{0});
    else
      std::fill_n(io_frame.rgb().data() + first, run.count, tables.rgb[0]);
    if (fill_depth)
      std::fill_n(io_frame.depth().data() + first, run.count, std::numeric_limits<float>::lowest());
  }
}

}  // namespace

void draw_spans(const Scene& scene, const Settings& settings, const ViewFrame& view, const SpanTable& spans,
                const DrawItems& items, const ColourTables& tables, base::Jobs& jobs, base::Arena& arena,
                FrameBuffer& io_frame) {
  const PixelFormat format = io_frame.format();
  const KernelDivide divide = divide_of(settings, view);
  const std::span<const SkyRuns*> skies = prepare_sky_runs(scene, view, items, tables, format, arena);
  const std::span<const RepeatRuns*> repeating =
      prepare_repeat_runs(scene, view, items, tables, format, arena);
  const bool indexed = format == PixelFormat::kIndexed;
  const KernelTarget target{indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data(),
                            settings.fill_depth ? io_frame.depth().data() : nullptr,
                            static_cast<std::size_t>(io_frame.width())};
  jobs.parallel_for(spans.bands.size(), [&](std::size_t number) {
    const Band& band = spans.bands[number];
    for (std::size_t position = 0; position < band.items.size(); ++position) {
      const std::uint32_t item_number = band.items[position];
      const DrawItem& item = items.items[item_number];
      const std::span<const SpanRun> runs = band.runs.subspan(
          band.run_begin[position], band.run_begin[position + 1] - band.run_begin[position]);
      switch (item.kind) {
        case ItemKind::kUnused:
          break;
        case ItemKind::kNothing:
          draw_background(runs, tables, settings.fill_depth, io_frame);
          break;
        case ItemKind::kSurface:
          if (settings.prefetch) prefetch_texels(item, runs, view.perspective, indexed ? 1 : 4);
          draw_surface(item, runs, divide, settings.vector_kernels, target, format);
          break;
        case ItemKind::kSky:
          draw_sky(*skies[item_number], item, runs, settings.vector_kernels, target, format);
          break;
        case ItemKind::kTexture:
        case ItemKind::kLiquid:
          draw_repeating(*repeating[item_number], runs, settings.vector_kernels, target, format);
          break;
      }
    }
  });
}

}  // namespace temblor::render
