// The surfaces that cover the current pixel, ordered by 1/z: the active polygon list of Abrash's "Sorted
// Spans in Action". The engine's SurfaceStack does the same by sort keys.
#pragma once

#include <cstdint>
#include <span>

#include "lab/technique.h"
#include "render/edges/active_edges.h"
#include "render/edges/edge_table.h"

namespace temblor::lab {

// How two depths are compared where a surface begins.
struct DepthRule {
  double epsilon = 0;         // relative difference up to which depths count as equal
  bool uses_gradient = true;  // equal: the surface whose 1/z grows faster to the right is nearer
  bool keeps_mesh = true;     // a surface takes the place of the one that ends at the same edge
};

class DepthStack {
 public:
  // From the edge at `place` on, `surface` is in front.
  struct Switch {
    std::uint32_t place;
    render::SurfaceIndex surface;
  };

  DepthStack(std::span<const render::ScreenPlane> depths, const DepthRule& rule, base::Arena& arena);

  // Passes all edges of a row from left to right, beginning with only the background in the stack.
  void walk(int row, std::span<const double> x, std::span<const render::EdgeRecord> records,
            base::ArenaVector<Switch>& out_switches);

  std::uint64_t comparisons() const { return comparisons_; }

 private:
  // A surface counts the edges that it is inside of. Valid only for `row`.
  struct Passed {
    std::int32_t row, inside;
  };
  struct Links {
    render::SurfaceIndex nearer, farther;
  };

  std::int32_t& inside(render::SurfaceIndex surface, int row);
  void remove(render::SurfaceIndex surface);
  void insert(render::SurfaceIndex surface, double x, int row);
  void replace(render::SurfaceIndex old, render::SurfaceIndex surface);
  bool is_nearer(render::SurfaceIndex begun, double depth, render::SurfaceIndex other, double x,
                 int row) const;
  Links& links(render::SurfaceIndex surface) { return links_[base::to_size(surface)]; }

  std::span<const render::ScreenPlane> depths_;
  DepthRule rule_;
  std::span<Passed> passed_;  // by surface
  // By surface, for those in the stack. The background is always the farthest; its `farther` is the nearest
  // surface, so the list is a ring.
  std::span<Links> links_;
  std::uint64_t comparisons_ = 0;
};

}  // namespace temblor::lab
