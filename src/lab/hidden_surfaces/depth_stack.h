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

// A surface that begins at x, and its depth there.
struct BegunSurface {
  render::SurfaceIndex surface;
  double x;
  int row;
  double depth;
};

// Compares surfaces by 1/z.
class DepthOrder {
 public:
  DepthOrder(std::span<const render::ScreenPlane> depths, const DepthRule& rule)
      : depths_(depths), rule_(rule) {}

  BegunSurface begin(render::SurfaceIndex surface, double x, int row) const {
    return {surface, x, row, depths_[base::to_size(surface)].at(x, row)};
  }
  bool is_nearer(const BegunSurface& begun, render::SurfaceIndex other);
  bool keeps_mesh() const { return rule_.keeps_mesh; }
  // Since the object was made.
  Counts counts() const { return {.comparisons = comparisons_}; }

 private:
  std::span<const render::ScreenPlane> depths_;  // by surface
  DepthRule rule_;
  std::uint64_t comparisons_ = 0;
};

// From the edge at `place` on, `surface` is in front.
struct DepthStackSwitch {
  std::uint32_t place;
  render::SurfaceIndex surface;
};

// `Order` says which of two surfaces is nearer: DepthOrder, or another class with the same functions, for
// which depth_stack.cpp has an instance.
template <typename Order>
class DepthStack {
 public:
  // For surfaces with numbers below `surface_count`.
  DepthStack(const Order& order, std::size_t surface_count, base::Arena& arena);

  // Passes all edges of a row from left to right, beginning with only the background in the stack.
  void walk(int row, std::span<const double> x, std::span<const render::EdgeRecord> records,
            base::ArenaVector<DepthStackSwitch>& out_switches);

  const Order& order() const { return order_; }

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
  Links& links(render::SurfaceIndex surface) { return links_[base::to_size(surface)]; }

  Order order_;
  std::span<Passed> passed_;  // by surface
  // By surface, for those in the stack. The background is always the farthest; its `farther` is the nearest
  // surface, so the list is a ring.
  std::span<Links> links_;
};

}  // namespace temblor::lab
