#include "world/naive_tree.h"

#include <cmath>

namespace temblor::world {
namespace {

long double distance(const formats::BspPlane& plane, const Point& point) {
  return point[0] * plane.normal.x + point[1] * plane.normal.y + point[2] * plane.normal.z - plane.distance;
}

Point between(const Point& a, const Point& b, long double along) {
  return {a[0] + (b[0] - a[0]) * along, a[1] + (b[1] - a[1]) * along, a[2] + (b[2] - a[2]) * along};
}

void walk(const formats::Bsp& bsp, std::int32_t node, const Point& start, const Point& end,
          std::vector<LeafPiece>& out_pieces) {
  if (node < 0) {
    const Point path = {end[0] - start[0], end[1] - start[1], end[2] - start[2]};
    out_pieces.push_back({static_cast<std::size_t>(-(node + 1)),
                          std::sqrt(path[0] * path[0] + path[1] * path[1] + path[2] * path[2])});
    return;
  }
  const formats::BspNode& bsp_node = bsp.nodes[static_cast<std::size_t>(node)];
  const formats::BspPlane& plane = bsp.planes[bsp_node.plane];
  const long double from = distance(plane, start);
  const long double to = distance(plane, end);
  const std::size_t side = from >= 0 ? 0 : 1;
  if ((from >= 0) == (to >= 0)) return walk(bsp, bsp_node.children[side], start, end, out_pieces);
  const Point cut = between(start, end, from / (from - to));
  walk(bsp, bsp_node.children[side], start, cut, out_pieces);
  walk(bsp, bsp_node.children[1 - side], cut, end, out_pieces);
}

}  // namespace

Point to_point(const math::Vec3& position) {
  return {position.x, position.y, position.z};
}

std::size_t naive_leaf(const formats::Bsp& bsp, std::int32_t node, const Point& point) {
  if (node < 0) return static_cast<std::size_t>(-(node + 1));
  const formats::BspNode& bsp_node = bsp.nodes[static_cast<std::size_t>(node)];
  const bool front = distance(bsp.planes[bsp_node.plane], point) >= 0;
  return naive_leaf(bsp, bsp_node.children[front ? 0 : 1], point);
}

std::int32_t naive_contents(const formats::Bsp& bsp, std::size_t model, std::size_t hull,
                            const Point& point) {
  std::int32_t node = bsp.models[model].head_nodes[hull];
  if (hull == 0) return bsp.leaves[naive_leaf(bsp, node, point)].contents;
  while (node >= 0) {
    const formats::BspClipnode& clipnode = bsp.clipnodes[static_cast<std::size_t>(node)];
    node = clipnode.children[distance(bsp.planes[clipnode.plane], point) >= 0 ? 0 : 1];
  }
  return node;
}

std::vector<LeafPiece> leaves_along(const formats::Bsp& bsp, const Point& start, const Point& end) {
  std::vector<LeafPiece> pieces;
  walk(bsp, bsp.models[0].head_nodes[0], start, end, pieces);
  return pieces;
}

}  // namespace temblor::world
