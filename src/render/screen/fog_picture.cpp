#include "render/screen/fog_picture.h"

namespace temblor::render {

namespace {

void fog_run(const FrameFog& fog, const DrawItem& item, const SpanRun& run, FrameBuffer& io_frame) {
  const std::size_t pixel = std::size_t{run.y} * static_cast<std::size_t>(io_frame.width()) + run.x;
  const std::span<const float> depth = io_frame.depth().subspan(pixel, run.count);
  void* const pixels = io_frame.format() == PixelFormat::kIndexed
                           ? static_cast<void*>(io_frame.indexed().data() + pixel)
                           : io_frame.rgb().data() + pixel;
  if (item.kind != ItemKind::kSky) {
    fog.apply(pixels, depth);
    return;
  }
  // In the order and precision of the span kernels.
  const ScreenPlane& plane = item.depth;
  fog.apply_sky(pixels, depth, static_cast<float>(plane.at_origin + plane.dx * run.x + plane.dy * run.y),
                static_cast<float>(plane.dx));
}

}  // namespace

// Runs of all but late items cover each pixel once.
void fog_picture(const FrameFog& fog, const SpanTable& spans, const DrawItems& items, base::Jobs& jobs,
                 FrameBuffer& io_frame) {
  if (!fog.is_on()) return;
  jobs.parallel_for(spans.bands.size(), [&](std::size_t number) {
    const Band& band = spans.bands[number];
    for (std::size_t position = 0; position < band.items.size(); ++position) {
      if (band.items[position] >= items.first_late) break;
      for (const SpanRun& run : band.runs_at(position))
        fog_run(fog, items.items[band.items[position]], run, io_frame);
    }
  });
}

}  // namespace temblor::render
