// Hot loop of the techniques that sort edges by 1/z.
#include "lab/hidden_surfaces/depth_stack.h"

#include <cmath>

#include "lab/hidden_surfaces/pair_orders.h"

namespace temblor::lab {

using render::kBackground;
using render::SurfaceIndex;

bool DepthOrder::is_nearer(const BegunSurface& begun, SurfaceIndex other) {
  ++comparisons_;
  const render::ScreenPlane& plane = depths_[base::to_size(begun.surface)];
  const render::ScreenPlane& other_plane = depths_[base::to_size(other)];
  const double other_depth = other_plane.at(begun.x, begun.row);
  // Orthographic depths are negative, so the tolerance is relative to the absolute value.
  const double tolerance = rule_.epsilon * std::abs(begun.depth);
  if (begun.depth - tolerance > other_depth) return true;
  if (begun.depth + tolerance < other_depth) return false;
  return !rule_.uses_gradient || plane.dx > other_plane.dx;
}

template <typename Order>
DepthStack<Order>::DepthStack(const Order& order, std::size_t surface_count, base::Arena& arena)
    : order_(order),
      passed_(arena.allocate_filled<Passed>(surface_count, {-1, 0})),
      links_(arena.allocate_filled<Links>(surface_count, {kBackground, kBackground})) {}

template <typename Order>
void DepthStack<Order>::walk(int row, std::span<const double> x, std::span<const render::EdgeRecord> records,
                             base::ArenaVector<DepthStackSwitch>& out_switches) {
  links(kBackground) = {kBackground, kBackground};
  out_switches.clear();
  SurfaceIndex front = kBackground;
  for (std::size_t place = 0; place < records.size(); ++place) {
    const SurfaceIndex trailing = records[place].trailing, leading = records[place].leading;
    const bool ends = trailing != kBackground && --inside(trailing, row) == 0;
    const bool begins = leading != kBackground && ++inside(leading, row) == 1;
    // Edges left of the screen are all at 0, in no order, so the surface that ends may be anywhere in the
    // stack.
    if (ends && begins && order_.keeps_mesh() && x[place] > 0) {
      replace(trailing, leading);
    } else {
      if (ends) remove(trailing);
      if (begins) insert(leading, x[place], row);
    }
    const SurfaceIndex now = links(kBackground).farther;
    if (now == front) continue;
    front = now;
    out_switches.push_back({static_cast<std::uint32_t>(place), front});
  }
}

template <typename Order>
std::int32_t& DepthStack<Order>::inside(SurfaceIndex surface, int row) {
  Passed& found = passed_[base::to_size(surface)];
  if (found.row != row) found = {row, 0};
  return found.inside;
}

template <typename Order>
void DepthStack<Order>::remove(SurfaceIndex surface) {
  const Links around = links(surface);
  links(around.nearer).farther = around.farther;
  links(around.farther).nearer = around.nearer;
}

template <typename Order>
void DepthStack<Order>::replace(SurfaceIndex old, SurfaceIndex surface) {
  const Links around = links(old);
  links(surface) = around;
  links(around.nearer).farther = surface;
  links(around.farther).nearer = surface;
}

template <typename Order>
void DepthStack<Order>::insert(SurfaceIndex surface, double x, int row) {
  const BegunSurface begun = order_.begin(surface, x, row);
  SurfaceIndex nearer = kBackground, farther = links(kBackground).farther;
  while (farther != kBackground && !order_.is_nearer(begun, farther)) {
    nearer = farther;
    farther = links(farther).farther;
  }
  links(surface) = {nearer, farther};
  links(nearer).farther = surface;
  links(farther).nearer = surface;
}

template class DepthStack<DepthOrder>;
template class DepthStack<CachedOrder>;

}  // namespace temblor::lab
