#include "lab/hidden_surfaces/z_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/hidden_surfaces/depth_kernels.h"
#include "lab/hidden_surfaces/draw_order.h"
#include "lab/hidden_surfaces/surface_depths.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

constexpr float kFarthest = std::numeric_limits<float>::lowest();

// The input of all bands of a frame.
struct DepthScan {
  const render::EdgeTable& table;
  const SurfaceEdges& edges;
  std::span<const render::ScreenPlane> depths;  // by surface
  std::span<const std::uint32_t> order;         // surfaces, in the order in which they are tested
  int width;
  bool simd;
};

// Tests the surfaces of one band against a depth buffer of its own.
class BandTest {
 public:
  BandTest(const DepthScan& scan, render::RowRange rows, base::Arena& arena)
      : scan_(scan),
        rows_(rows),
        depth_(arena.allocate_filled(
            static_cast<std::size_t>(rows.end - rows.first) * static_cast<std::size_t>(scan.width) +
                kDepthPadding,
            kFarthest)),
        runs_(arena.allocate<PixelRun>(static_cast<std::size_t>(scan.width) / 2 + 1)),
        spans_(arena, 4096) {}

  void test_surfaces(base::Arena& arena) {
    SurfaceScan surface_scan(scan_.table, scan_.edges, rows_, scan_.width, arena);
    for (const std::uint32_t surface : scan_.order) {
      if (surface == 0) continue;
      const render::RowRange rows = surface_scan.scan(surface);
      for (int row = rows.first; row < rows.end; ++row)
        test_row(scan_.table.surfaces[surface].first_draw, scan_.depths[surface], row,
                 surface_scan.span_at(row));
    }
  }
  // The background is where nothing was drawn: just nearer than an empty buffer.
  void test_background() {
    const render::ScreenPlane plane{std::nextafter(kFarthest, 0.0f), 0, 0};
    for (int row = rows_.first; row < rows_.end; ++row) test_row(0, plane, row, {0, scan_.width});
  }

  std::span<const render::DrawSpan> spans() const { return spans_.view(); }
  Counts counts() const { return {.pixels_tested = tested_, .bytes = depth_.size_bytes()}; }

 private:
  void test_row(std::uint32_t draw, const render::ScreenPlane& plane, int row, RowSpan pixels) {
    if (pixels.first >= pixels.end) return;
    const std::size_t row_begin =
        static_cast<std::size_t>(row - rows_.first) * static_cast<std::size_t>(scan_.width);
    const DepthSpan span{depth_.data() + row_begin + pixels.first, pixels.end - pixels.first,
                         static_cast<float>(plane.at(pixels.first, row)), static_cast<float>(plane.dx)};
    const std::int32_t count =
        scan_.simd ? test_depth_simd(span, runs_.data()) : test_depth_scalar(span, runs_.data());
    tested_ += static_cast<std::uint64_t>(span.count);
    for (std::int32_t i = 0; i < count; ++i)
      spans_.push_back({draw,
                        {static_cast<std::uint16_t>(pixels.first + runs_[static_cast<std::size_t>(i)].begin),
                         static_cast<std::uint16_t>(row),
                         static_cast<std::uint16_t>(runs_[static_cast<std::size_t>(i)].end -
                                                    runs_[static_cast<std::size_t>(i)].begin)}});
  }

  const DepthScan& scan_;
  render::RowRange rows_;
  std::span<float> depth_;
  std::span<PixelRun> runs_;
  base::ArenaVector<render::DrawSpan> spans_;
  std::uint64_t tested_ = 0;
};

}  // namespace

render::FrameStages make_z_buffer(std::span<const double> values, Counter* counter) {
  render::FrameStages stages;
  const bool front_to_back = values[0] == 0;
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    const SurfaceEdges edges = group_edges(context, table);
    const std::span<const std::uint32_t> back_to_front =
        order_back_to_front(context, table, edges, view.width);
    std::span<std::uint32_t> order = context.arena().allocate<std::uint32_t>(back_to_front.size());
    std::copy(back_to_front.begin(), back_to_front.end(), order.begin());
    if (front_to_back) std::reverse(order.begin(), order.end());
    const DepthScan scan{table, edges,      find_surface_depths(context, view, table),
                         order, view.width, context.settings.simd_kernels};
    const render::SpanTable spans =
        render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena& arena) {
          BandTest test(scan, rows, arena);
          test.test_surfaces(arena);
          test.test_background();
          if (counter != nullptr) counter->add(test.counts());
          return test.spans();
        });
    return order_draws(context, table, spans, order);
  };
  return stages;
}

}  // namespace temblor::lab
