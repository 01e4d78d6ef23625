#include "lab/unsplit_world/unsplit_edges.h"

#include <algorithm>
#include <memory>

#include "lab/hidden_surfaces/stack_scan.h"
#include "lab/hidden_surfaces/surface_depths.h"
#include "lab/hidden_surfaces/surface_edges.h"
#include "lab/unsplit_world/joined_faces.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

using render::DrawSpan;

// The joined faces of the level that was drawn last.
class KeptParts {
 public:
  std::span<const world::FaceIndex> find(const world::Level* level) {
    if (level == nullptr) return {};
    if (level_ != level->identity) {
      level_ = level->identity;
      first_parts_ = find_first_parts(*level);
    }
    return first_parts_;
  }

 private:
  std::shared_ptr<const world::LevelIdentity> level_;
  std::vector<world::FaceIndex> first_parts_;
};

// The pixels of a part on one row.
struct PartSpan {
  std::uint32_t joined_draw;  // the draw of the surface that stands for it
  std::uint32_t draw;
  RowSpan pixels;
};

// Cuts the spans of joined surfaces where another part begins.
class SpanCutter {
 public:
  SpanCutter(const render::EdgeTable& table, const JoinedTable& joined, const SurfaceEdges& edges,
             render::RowRange rows, base::Arena& arena)
      : rows_(rows),
        is_seen_(arena.allocate_filled<std::uint8_t>(table.draw_count, 0)),
        has_parts_(arena.allocate_filled<std::uint8_t>(table.draw_count, 0)),
        row_begin_(
            arena.allocate_filled<std::uint32_t>(static_cast<std::size_t>(rows.end - rows.first) + 1, 0)),
        parts_(arena, 1024),
        table_(table),
        joined_(joined),
        edges_(edges) {}

  std::span<const DrawSpan> cut(std::span<const DrawSpan> spans, int width, base::Arena& arena) {
    for (const DrawSpan& span : spans) is_seen_[span.draw] = 1;
    find_parts(width, arena);
    base::ArenaVector<DrawSpan> cut_spans(arena, spans.size() * 2);
    for (const DrawSpan& span : spans) {
      if (has_parts_[span.draw] == 0)
        cut_spans.push_back(span);
      else
        cut_at_parts(span, cut_spans);
    }
    cuts_ = cut_spans.size() - spans.size();
    return cut_spans.view();
  }
  std::uint64_t cuts() const { return cuts_; }

 private:
  // Scans each part of a visible surface alone, and sorts its spans by row, joined surface, and place.
  void find_parts(int width, base::Arena& arena) {
    struct Found {
      std::int32_t row;
      PartSpan part;
    };
    base::ArenaVector<Found> found(arena, 1024);
    SurfaceScan scan(table_, edges_, rows_, width, arena);
    for (std::size_t surface = 1; surface < joined_.surfaces.size(); ++surface) {
      const std::size_t stands_for = base::to_size(joined_.surfaces[surface]);
      if (joined_.part_counts[stands_for] < 2) continue;
      const std::uint32_t joined_draw = table_.surfaces[stands_for].first_draw;
      if (is_seen_[joined_draw] == 0) continue;
      has_parts_[joined_draw] = 1;
      const render::RowRange rows = scan.scan(surface);
      for (int row = rows.first; row < rows.end; ++row) {
        const RowSpan pixels = scan.span_at(row);
        if (pixels.first >= pixels.end) continue;
        found.push_back({row, {joined_draw, table_.surfaces[surface].first_draw, pixels}});
        ++row_begin_[static_cast<std::size_t>(row - rows_.first)];
      }
    }
    // From counts to positions: of the last part first, because adding one moves the position down.
    std::uint32_t before = 0;
    for (std::uint32_t& count : row_begin_) before = count += before;
    parts_.resize(found.size());
    for (std::size_t i = found.size(); i-- > 0;)
      parts_[--row_begin_[static_cast<std::size_t>(found[i].row - rows_.first)]] = found[i].part;
    for (std::size_t row = 0; row + 1 < row_begin_.size(); ++row)
      std::sort(parts_.begin() + row_begin_[row], parts_.begin() + row_begin_[row + 1],
                [](const PartSpan& a, const PartSpan& b) {
                  return std::pair(a.joined_draw, a.pixels.first) < std::pair(b.joined_draw, b.pixels.first);
                });
  }

  // Pixels between two parts, which rounding may leave where their edges differ, go to the part before.
  void cut_at_parts(const DrawSpan& span, base::ArenaVector<DrawSpan>& io_spans) const {
    const auto row = static_cast<std::size_t>(span.span.y - rows_.first);
    const auto parts = parts_.view().subspan(row_begin_[row], row_begin_[row + 1] - row_begin_[row]);
    const int end = span.span.x + span.span.count;
    int begin = span.span.x;
    std::uint32_t draw = span.draw;
    const auto add = [&](int next) {
      if (begin >= next) return;
      io_spans.push_back(
          {draw, {static_cast<std::uint16_t>(begin), span.span.y, static_cast<std::uint16_t>(next - begin)}});
      begin = next;
    };
    const auto first = std::ranges::lower_bound(parts, span.draw, {}, &PartSpan::joined_draw);
    bool has_part = false;
    for (auto part = first; part != parts.end() && part->joined_draw == span.draw; ++part) {
      if (part->pixels.end <= span.span.x) continue;
      if (part->pixels.first >= end) break;
      if (has_part) add(part->pixels.first);
      draw = part->draw;
      has_part = true;
    }
    add(end);
  }

  const render::RowRange rows_;
  std::span<std::uint8_t> is_seen_, has_parts_;  // by draw of a joined surface
  std::span<std::uint32_t> row_begin_;           // by row of the band, into `parts_`; one more at the end
  base::ArenaVector<PartSpan> parts_;
  const render::EdgeTable& table_;
  const JoinedTable& joined_;
  const SurfaceEdges& edges_;
  std::uint64_t cuts_ = 0;
};

// That of abutting-edges.
constexpr DepthRule kUnsplitRule{.epsilon = 1e-5, .uses_gradient = true, .keeps_mesh = true};

}  // namespace

render::FrameStages make_unsplit_edges(std::span<const double> /*values*/, Counter* counter) {
  render::FrameStages stages;
  const auto kept = std::make_shared<KeptParts>();
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    const JoinedTable joined = join_parts(context, table, kept->find(context.scene.level));
    const SurfaceEdges edges = group_edges(context, table);
    const std::span<const render::ScreenPlane> depths = find_surface_depths(context, view, table);
    if (counter != nullptr)
      counter->add({.bytes = depths.size_bytes() + joined.table.edges.size_bytes() + edges.sides.size_bytes(),
                    .edges_saved = joined.edges_saved});
    return render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena& arena) {
      DepthStack stack(DepthOrder(depths, kUnsplitRule), depths.size(), arena);
      const std::span<const DrawSpan> spans = scan_with_stack(joined.table, rows, view.width, stack, arena);
      SpanCutter cutter(table, joined, edges, rows, arena);
      const std::span<const DrawSpan> cut_spans = cutter.cut(spans, view.width, arena);
      if (counter != nullptr) {
        counter->add(stack.order().counts());
        counter->add({.splits = cutter.cuts()});
      }
      return cut_spans;
    });
  };
  return stages;
}

}  // namespace temblor::lab
