#include "lab/perspective/affine_spans.h"

#include "lab/perspective/affine_error.h"

namespace temblor::lab {

namespace {

Counts find_errors(const render::Band& band, const render::SpanSources& sources, int pixels) {
  Counts counts;
  for (std::size_t position = 0; position < band.draws.size(); ++position) {
    const std::uint32_t number = band.draws[position];
    if (number >= sources.draws.first_deferred) break;
    const render::SurfaceDraw& draw = sources.draws.all[number];
    if (draw.kind == render::SurfaceKind::kBlock)
      counts += find_affine_error(draw, band.spans_at(position), pixels);
  }
  return counts;
}

}  // namespace

render::FrameStages make_affine_spans(std::span<const double> values, Counter* counter) {
  const int pixels = static_cast<int>(values[0]);
  render::FrameStages stages;
  stages.draw_band_spans = [=](const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    render::SpanSources affine = sources;
    // Parallel projection is affine anyway.
    if (view.perspective) affine.divide = render::KernelDivide::kAffine;
    affine.affine_pixels = pixels;
    render::draw_band_spans(context, view, band, affine, io_frame);
    if (counter != nullptr && view.perspective) counter->add(find_errors(band, sources, pixels));
  };
  return stages;
}

}  // namespace temblor::lab
