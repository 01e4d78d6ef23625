#include "render/screen/fog_picture.h"

#include <algorithm>

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

// Runs of all but late items cover each pixel once. Without sky it is the rows that they fill.
void fog_picture(const FrameFog& fog, const SpanTable& spans, const DrawItems& items, base::Jobs& jobs,
                 FrameBuffer& io_frame) {
  if (!fog.is_on()) return;
  jobs.parallel_for(spans.bands.size(), [&](std::size_t number) {
    const Band& band = spans.bands[number];
    const auto listed = band.items.first(static_cast<std::size_t>(
        std::lower_bound(band.items.begin(), band.items.end(), items.first_late) - band.items.begin()));
    const bool has_sky = std::any_of(listed.begin(), listed.end(), [&](std::uint32_t item) {
      return items.items[item].kind == ItemKind::kSky;
    });
    if (!has_sky) {
      const auto width = static_cast<std::uint16_t>(io_frame.width());
      for (int row = band.first_row; row < band.first_row + band.row_count; ++row)
        fog_run(fog, DrawItem{}, {0, static_cast<std::uint16_t>(row), width}, io_frame);
      return;
    }
    for (std::size_t position = 0; position < listed.size(); ++position)
      for (const SpanRun& run : band.runs_at(position))
        fog_run(fog, items.items[listed[position]], run, io_frame);
  });
}

}  // namespace temblor::render
