#include "lab/space_battle.h"

#include <algorithm>

#include "base/check.h"
#include "lab/hidden_surfaces/intersecting_scan.h"
#include "lab/hidden_surfaces/stack_scan.h"
#include "lab/space_battle/solid_edges.h"

namespace temblor::lab::space {

namespace {

constexpr std::size_t kStars = 4000;

SceneEdges emit_battle_edges(const BattleView& view, std::span<const Solid> solids,
                             std::span<const FormationSlot> slots, double time_s, base::Arena& arena) {
  SolidEdges edges(view, arena);
  for (const FormationSlot& slot : slots)
    edges.add(solids[slot.solid], find_placement(slot, time_s), slot.color);
  return edges.finish();
}

struct BattleSpans {
  std::span<const render::DrawSpan> spans;
  std::uint64_t comparisons;
};

BattleSpans scan_with_rule(const SceneEdges& scene, const BattleView& view, const DepthRule& rule,
                           base::Arena& arena) {
  DepthStack stack(DepthOrder(scene.depths, rule), scene.depths.size(), arena);
  const auto spans = scan_with_stack(scene.table, {0, view.height}, view.width, stack, arena);
  return {spans, stack.order().counts().comparisons};
}

BattleSpans scan_battle(const SceneEdges& scene, const BattleView& view, DepthSorting sorting,
                        base::Arena& arena) {
  switch (sorting) {
    case DepthSorting::kIndependent:
      break;
    case DepthSorting::kAbutting:
      return scan_with_rule(scene, view, {.epsilon = 1e-5, .uses_gradient = true}, arena);
    case DepthSorting::kIntersecting: {
      IntersectingScan scan(scene.table, scene.depths, 0, view.width, arena);
      for (int row = 0; row < view.height; ++row) scan.scan_row(row);
      return {scan.spans(), scan.comparisons()};
    }
  }
  // Equal depths do not occur: faces of one solid that touch do not overlap on the screen.
  return scan_with_rule(scene, view, {.epsilon = 0, .uses_gradient = false}, arena);
}

// Spans and stars come in the order of their pixels, so that one pass over both is enough.
void fill_spans(std::span<const render::DrawSpan> spans, std::span<const std::uint32_t> colors,
                std::span<const StarPixel> stars, int width, std::span<std::uint32_t> out_pixels) {
  std::size_t star = 0;
  for (const auto& [surface, span] : spans) {
    const std::size_t begin = span.y * static_cast<std::size_t>(width) + span.x, end = begin + span.count;
    std::fill(out_pixels.begin() + static_cast<std::ptrdiff_t>(begin),
              out_pixels.begin() + static_cast<std::ptrdiff_t>(end), colors[surface]);
    const bool is_background = surface == base::to_size(render::kBackground);
    for (; star < stars.size() && stars[star].place < end; ++star)
      if (is_background) out_pixels[stars[star].place] = stars[star].color;
  }
}

}  // namespace

Battle::Battle(const BattleOptions& options)
    : stars_(make_stars(kStars, options.seed)), sorting_(options.sorting) {
  CHECK(options.solids <= kMaxSolids, "{} solids", options.solids);
  const auto add = [&](std::vector<Solid> solids) {
    for (Solid& solid : solids) solids_.push_back(std::move(solid));
  };
  if (options.shapes != BattleShapes::kConcave) add(make_convex_ships());
  if (options.shapes != BattleShapes::kConvex) add(make_concave_ships());
  std::vector<std::uint32_t> ships;
  for (std::uint32_t i = 0; i < solids_.size(); ++i) ships.push_back(i);
  const auto shot = static_cast<std::uint32_t>(solids_.size());
  solids_.push_back(make_shot());
  formation_ = make_formation(options.solids, ships, shot, options.spacing, options.seed);
}

math::Basis Battle::lookout_axes() const {
  math::Basis axes;
  axes.forward = glm::normalize(-formation_.lookout);
  axes.right = {0, -1, 0};  // the lookout has y = 0
  axes.up = glm::cross(axes.right, axes.forward);
  return axes;
}

BattleCounts Battle::draw(const BattleView& view, double time_s, std::span<std::uint32_t> out_pixels) {
  CHECK(out_pixels.size() == static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
        "a picture of {} pixels for {}x{}", out_pixels.size(), view.width, view.height);
  arena_.reset();
  const SceneEdges scene = emit_battle_edges(view, solids_, formation_.slots, time_s, arena_);
  const BattleSpans found = scan_battle(scene, view, sorting_, arena_);
  fill_spans(found.spans, scene.colors, find_star_pixels(stars_, view, arena_), view.width, out_pixels);
  return {scene.table.edges.size(), scene.depths.size() - 1, found.spans.size(), found.comparisons};
}

// A row of a surface is as long as the way from its first edge to the right border, minus that from its last
// edge.
double Battle::measure_depth_complexity(const BattleView& view, double time_s) {
  arena_.reset();
  const SceneEdges scene = emit_battle_edges(view, solids_, formation_.slots, time_s, arena_);
  double covered_px = 0;
  for (const render::Edge& edge : scene.table.edges) {
    const int begins =
        (edge.leading != render::kBackground ? 1 : 0) - (edge.trailing != render::kBackground ? 1 : 0);
    if (begins == 0) continue;
    for (int row = 0; row <= edge.last_row - edge.first_row; ++row)
      covered_px += begins * std::max(0.0, view.width - render::crossing(edge.x_first, edge.step, row));
  }
  return covered_px / (static_cast<double>(view.width) * view.height);
}

}  // namespace temblor::lab::space
