#include "lab/world_light/gouraud.h"

#include <algorithm>
#include <memory>

#include "lab/world_light/gouraud_faces.h"
#include "lab/world_light/lit_draws.h"
#include "lab/world_light/polygon_row.h"

namespace temblor::lab {

namespace {

// The state of one frame. Its memory is kept for the next one.
struct Gouraud {
  render::ViewFrame view;
  render::EdgeTable edges;
  LitDraws draws;
  std::span<GouraudPolygons> polygons;  // by draw number
  LitPreparation preparation;           // of `polygons`
};

void prepare(const render::FrameContext& context, const render::SurfaceRequests& requests,
             const GouraudCut& cut, Gouraud& io_state) {
  io_state.draws = choose_lit_draws(context, requests);
  io_state.polygons = context.arena().allocate<GouraudPolygons>(requests.draws.size());
  io_state.preparation.run(context, io_state.draws.own, [&](std::uint32_t number, base::Arena& arena) {
    const render::SurfaceDraw& draw = requests.draws[number];
    const render::ScreenSurface& surface = io_state.edges.surfaces[base::to_size(draw.surface)];
    io_state.polygons[number] = make_gouraud_polygons(
        context, io_state.view, cut,
        {*io_state.draws.all[number].request, io_state.edges.model_views[surface.instance]}, arena);
  });
}

Counts count(const Gouraud& state) {
  Counts counts;
  counts.bytes = state.preparation.used_bytes();
  for (const std::uint32_t number : state.draws.own) {
    const std::size_t polygons = state.polygons[number].all.size();
    if (polygons > 1) counts.splits += polygons - 1;
  }
  return counts;
}

// `x`: the first pixel of the span. `pixels_before`: of the part in it.
LineLight make_line(const RowInterval& interval, int x, int pixels_before) {
  const RowLight& row = interval.row;
  LineLight line{};
  line.pixels_before = pixels_before;
  for (std::size_t i = 0; i < kMaxChannels; ++i) {
    const LightStep light = row.steps_from(x, i);
    line.base[i] = static_cast<float>(light.first);
    line.step[i] = static_cast<float>(light.step);
    line.least[i] = interval.polygon->least[i];
    line.most[i] = interval.polygon->most[i];
  }
  return line;
}

constexpr LitKernels kGouraudKernels{draw_line_lit_u8_simd, draw_line_lit_u8_scalar, draw_line_lit_u32_simd,
                                     draw_line_lit_u32_scalar};

// Draws the spans of one draw, in batches.
class SpanLighter {
 public:
  SpanLighter(const LitSpans& spans, LineLights lights, const render::SpanSources& sources,
              const render::KernelTarget& target)
      : spans_(spans), lights_(lights), sources_(sources), target_(target) {}

  void draw(const GouraudPolygons& polygons, std::span<const render::Span> spans) {
    for (const render::Span& span : spans) {
      if (row_.y() != span.y) row_.find(polygons.all, span.y);
      row_.split(span, [&](const RowPart& part) { add_part(span, part); });
    }
    flush();
  }

 private:
  void add_part(const render::Span& span, const RowPart& part) {
    if (count_ == kBatch) flush();
    parts_[count_] = part.pixels;
    lines_[count_++] = make_line(part.interval, span.x, part.pixels.x - span.x);
  }

  void flush() {
    spans_.spans = parts_.data();
    spans_.span_count = count_;
    lights_.lines = lines_.data();
    count_ = 0;
    kGouraudKernels.choose(sources_)(spans_, lights_, target_);
  }

  static constexpr std::size_t kBatch = 64;
  LitSpans spans_;
  LineLights lights_;
  const render::SpanSources& sources_;
  const render::KernelTarget& target_;
  PolygonRow row_;
  std::size_t count_ = 0;
  std::array<render::Span, kBatch> parts_;
  std::array<LineLight, kBatch> lines_;
};

}  // namespace

render::FrameStages make_gouraud(std::span<const double> values, Counter* counter) {
  const GouraudCut cut{values[0] != 0, values[1] != 0, values[2] != 0,
                       values[3] > 0 ? std::max(static_cast<int>(values[3]), 16) : 0};
  const auto state = std::make_shared<Gouraud>();
  render::FrameStages stages;
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    state->view = view;
    state->edges = table;
    return render::scan_edges(context, view, table);
  };
  stages.reserve_surfaces = [=](const render::FrameContext& context, const render::SurfaceRequests& requests,
                                render::SurfaceCache& io_cache) {
    const std::size_t before = context.arena().used_bytes();
    prepare(context, requests, cut, *state);
    if (counter != nullptr) {
      Counts counts = count(*state);
      counts.bytes += context.arena().used_bytes() - before;
      counter->add(counts);
    }
    return render::reserve_surfaces(context, state->draws.left, io_cache);
  };
  stages.draw_band_spans = [=](const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    draw_lit_band(
        {context, view, band, sources}, state->draws.all,
        [&](std::uint32_t number, std::span<const render::Span> spans, const render::KernelTarget& target) {
          const GouraudPolygons& polygons = state->polygons[number];
          SpanLighter(make_lit_spans(context, view, sources.draws.all[number], state->draws.all[number]),
                      {nullptr, polygons.channels, cut.perspective && view.perspective}, sources, target)
              .draw(polygons, spans);
        },
        io_frame);
  };
  return stages;
}

}  // namespace temblor::lab
