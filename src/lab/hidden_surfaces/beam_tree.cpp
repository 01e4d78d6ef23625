#include "lab/hidden_surfaces/beam_tree.h"

#include <algorithm>

#include "lab/beam_tree/screen_tree.h"
#include "lab/hidden_surfaces/draw_order.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

// The input of all trees of a frame.
struct BeamInput {
  const render::EdgeTable& table;
  const SurfaceEdges& edges;
  std::span<const std::uint32_t> back_to_front;
  int width, height;
  double max_nodes;  // of the frame
  Counter* counter;
};

std::span<const render::DrawSpan> build_tree(const BeamInput& input, render::RowRange rows,
                                             base::Arena& arena) {
  const double share = static_cast<double>(rows.end - rows.first) / input.height;
  ScreenTree tree(input.table, input.edges, rows, input.width,
                  static_cast<std::size_t>(input.max_nodes * share), arena);
  for (auto surface = input.back_to_front.rbegin(); surface != input.back_to_front.rend(); ++surface)
    if (*surface != 0) tree.add_surface(*surface);
  const std::span<const render::DrawSpan> spans = tree.finish();
  if (input.counter != nullptr) input.counter->add(tree.counts());
  return spans;
}

// Spans by band: those of band i are spans[begin[i]] to spans[begin[i + 1] - 1], in the order that they had.
struct SpansByBand {
  std::span<const render::DrawSpan> spans;
  std::span<const std::uint32_t> begin;
};

SpansByBand group_by_band(std::span<const render::DrawSpan> unsorted, int band_rows, int height,
                          base::Arena& arena) {
  const auto bands = static_cast<std::size_t>((height + band_rows - 1) / band_rows);
  const std::span<std::uint32_t> begin = arena.allocate_filled<std::uint32_t>(bands + 1, 0);
  const auto find_band = [&](const render::DrawSpan& span) {
    return static_cast<std::size_t>(span.span.y / band_rows);
  };
  for (const render::DrawSpan& span : unsorted) ++begin[find_band(span)];
  // From counts to positions: of the last span first, because placing one moves the position down.
  std::uint32_t before = 0;
  for (std::uint32_t& count : begin) before = count += before;
  const std::span<render::DrawSpan> spans = arena.allocate<render::DrawSpan>(unsorted.size());
  for (auto span = unsorted.rbegin(); span != unsorted.rend(); ++span)
    spans[--begin[find_band(*span)]] = *span;
  return {spans, begin};
}

}  // namespace

render::FrameStages make_beam_tree(std::span<const double> values, Counter* counter) {
  render::FrameStages stages;
  const bool by_band = values[0] != 0;
  const double max_nodes = values[1];
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    base::Arena& arena = context.arena();
    const SurfaceEdges edges = group_edges(context, table);
    const BeamInput input{table,      edges,       order_back_to_front(context, table, edges, view.width),
                          view.width, view.height, max_nodes,
                          counter};
    if (by_band) {
      return render::make_span_table(context, view, table,
                                     [&](render::RowRange rows, base::Arena& band_arena) {
                                       return build_tree(input, rows, band_arena);
                                     });
    }
    const int band_rows = context.settings.band_rows;
    const SpansByBand by_band_spans =
        group_by_band(build_tree(input, {0, view.height}, arena), band_rows, view.height, arena);
    return render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena&) {
      const auto band = static_cast<std::size_t>(rows.first / band_rows);
      const std::uint32_t begin = by_band_spans.begin[band];
      return by_band_spans.spans.subspan(begin, by_band_spans.begin[band + 1] - begin);
    });
  };
  return stages;
}

}  // namespace temblor::lab
