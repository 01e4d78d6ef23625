// Polygons on the screen as an edge table, without a level: for tests of the scan, and of the laboratory's
// techniques that replace it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/edges/edge_table.h"
#include "support/random.h"

namespace temblor::test {

struct ScreenPolygon {
  std::vector<math::Vec2d> corners;  // convex, in order
  render::SortKey key;
  render::ScreenPlane depth;  // decides among equal keys
};

// Often partly outside the screen, or larger than it.
ScreenPolygon any_polygon(const render::ViewFrame& view, Random& io_random);

// An edge table by the definition of Edge: the rows whose centers are between its ends, and where it crosses
// them. Edges right of the screen stay in. The surfaces count as brush models, so that fragments hold their
// depths.
class HandMadeTable {
 public:
  // `view` must outlive it.
  HandMadeTable(const render::ViewFrame& view, const std::vector<ScreenPolygon>& polygons);
  // Refers to this object. Surface, draw, and fragment i + 1 belong to polygon i.
  render::EdgeTable view() const;

 private:
  void add(const ScreenPolygon& polygon);
  void add_surface(render::SortKey key);

  const render::ViewFrame& view_;
  std::vector<render::Edge> edges_;
  std::vector<std::uint32_t> order_, row_begin_;
  std::vector<render::ScreenSurface> surfaces_;
  std::vector<render::BrushFragment> fragments_;
};

// The draw of each pixel by definition, row by row: in front is the smallest key, and among equal keys the
// largest depth. Nothing where rounding decides.
std::vector<std::optional<std::uint32_t>> find_shown_draws(const render::ViewFrame& view,
                                                           const std::vector<ScreenPolygon>& polygons);

}  // namespace temblor::test
