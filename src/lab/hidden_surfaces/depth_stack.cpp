// Hot loop of the techniques that sort edges by 1/z.
#include "lab/hidden_surfaces/depth_stack.h"

#include <cmath>

namespace temblor::lab {

using render::kBackground;
using render::SurfaceIndex;

DepthStack::DepthStack(std::span<const render::ScreenPlane> depths, const DepthRule& rule, base::Arena& arena)
    : depths_(depths),
      rule_(rule),
      passed_(arena.allocate_filled<Passed>(depths.size(), {-1, 0})),
      links_(arena.allocate_filled<Links>(depths.size(), {kBackground, kBackground})) {}

void DepthStack::walk(int row, std::span<const double> x, std::span<const render::EdgeRecord> records,
                      base::ArenaVector<Switch>& out_switches) {
  links(kBackground) = {kBackground, kBackground};
  out_switches.clear();
  SurfaceIndex front = kBackground;
  for (std::size_t place = 0; place < records.size(); ++place) {
    const SurfaceIndex trailing = records[place].trailing, leading = records[place].leading;
    const bool ends = trailing != kBackground && --inside(trailing, row) == 0;
    const bool begins = leading != kBackground && ++inside(leading, row) == 1;
    // Edges left of the screen are all at 0, in no order, so the surface that ends may be anywhere in the
    // stack.
    if (ends && begins && rule_.keeps_mesh && x[place] > 0) {
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

std::int32_t& DepthStack::inside(SurfaceIndex surface, int row) {
  Passed& found = passed_[base::to_size(surface)];
  if (found.row != row) found = {row, 0};
  return found.inside;
}

void DepthStack::remove(SurfaceIndex surface) {
  const Links around = links(surface);
  links(around.nearer).farther = around.farther;
  links(around.farther).nearer = around.nearer;
}

void DepthStack::replace(SurfaceIndex old, SurfaceIndex surface) {
  const Links around = links(old);
  links(surface) = around;
  links(around.nearer).farther = surface;
  links(around.farther).nearer = surface;
}

void DepthStack::insert(SurfaceIndex surface, double x, int row) {
  const double depth = depths_[base::to_size(surface)].at(x, row);
  SurfaceIndex nearer = kBackground, farther = links(kBackground).farther;
  while (farther != kBackground && !is_nearer(surface, depth, farther, x, row)) {
    nearer = farther;
    farther = links(farther).farther;
    ++comparisons_;
  }
  comparisons_ += farther != kBackground;
  links(surface) = {nearer, farther};
  links(nearer).farther = surface;
  links(farther).nearer = surface;
}

bool DepthStack::is_nearer(SurfaceIndex begun, double depth, SurfaceIndex other, double x, int row) const {
  const render::ScreenPlane &plane = depths_[base::to_size(begun)],
                            &other_plane = depths_[base::to_size(other)];
  const double other_depth = other_plane.at(x, row);
  // Orthographic depths are negative, so the tolerance is relative to the absolute value.
  const double tolerance = rule_.epsilon * std::abs(depth);
  if (depth - tolerance > other_depth) return true;
  if (depth + tolerance < other_depth) return false;
  return !rule_.uses_gradient || plane.dx > other_plane.dx;
}

}  // namespace temblor::lab
