// The polygons of a face on one row of the screen, and the parts of spans that lie in them.
#pragma once

#include <array>
#include <span>

#include "base/function_ref.h"
#include "lab/world_light/lit_polygons.h"
#include "render/edges/span.h"

namespace temblor::lab {

// A polygon on a row.
struct RowInterval {
  RowLight row;
  const LitPolygon* polygon;
};

struct RowPart {
  const RowInterval& interval;
  render::Span pixels;
};

class PolygonRow {
 public:
  // Finds the polygons on row `y`; if none covers it, the nearest one. There must be at least one, and they
  // must not overlap. Those beyond kMaxIntervals are left out.
  void find(std::span<const LitPolygon> polygons, int y);
  int y() const { return y_; }

  // Cuts a span of the row where polygons begin. The first and the last polygon reach to its ends, because by
  // rounding, a face has pixels beside its outline.
  void split(const render::Span& span, base::FunctionRef<void(const RowPart&)> use) const;

 private:
  // A row of a tile crosses at most 16 cells of 16 texels along each axis, in two triangles each.
  static constexpr std::size_t kMaxIntervals = 72;
  int y_ = -1;
  std::size_t count_ = 0;
  std::array<RowInterval, kMaxIntervals> intervals_;
};

}  // namespace temblor::lab
