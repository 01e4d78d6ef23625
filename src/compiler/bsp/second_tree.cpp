#include "compiler/bsp/second_tree.h"

#include <algorithm>
#include <cmath>

namespace temblor::compiler {
namespace {

bool touch(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.mins - kOnPlane, b.maxs)) &&
         glm::all(glm::lessThanEqual(b.mins - kOnPlane, a.maxs));
}

// The brushes, only sides splitting at which the fill changes somewhere, or something is seen
// (and hints).
std::vector<Brush> only_bounding(const Tree& tree, std::span<const LeafPortal> portals,
                                 std::span<const Brush> brushes) {
  std::vector<Brush> kept(brushes.begin(), brushes.end());
  std::vector<std::vector<Box>> side_boxes(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (BrushSide& side : kept[i].sides) {
      side_boxes[i].emplace_back().add(side.winding);
      side.splits &= kept[i].fill == Fill::kEmpty;
    }
  for (const LeafPortal& portal : portals) {
    const TreeLeaf &front = tree.leaves[portal.leaves[0]], &back = tree.leaves[portal.leaves[1]];
    const PlaneIndex plane = tree.nodes[portal.node].plane;
    const bool is_seen = surface_between(front, back, plane, brushes) != kNoSurface ||
                         surface_between(back, front, turned(plane), brushes) != kNoSurface;
    if (front.fill == back.fill && front.structure == back.structure && !is_seen) continue;
    Box box;
    box.add(portal.winding);
    bool found = false;
    for (const TreeLeaf* leaf : {&front, &back})
      for (const std::uint32_t brush : leaf->brushes)
        for (std::size_t i = 0; i < kept[brush].sides.size(); ++i) {
          if (stored(kept[brush].sides[i].plane) != plane || !touch(side_boxes[brush][i], box)) continue;
          kept[brush].sides[i].splits = true;
          found = true;
        }
    if (found) continue;
    // The plane is another brush's, so near to one of these that the tree took both for one.
    for (const TreeLeaf* leaf : {&front, &back})
      for (const std::uint32_t brush : leaf->brushes)
        for (BrushSide& side : kept[brush].sides) side.splits = true;
  }
  return kept;
}

// A point inside of each bounded leaf: the mean of its portals' corners.
struct InnerPoint {
  math::Vec3d sum{0.0};
  double count = 0;
  int portals = 0;
};

std::vector<InnerPoint> inner_points(const Tree& tree, std::span<const LeafPortal> portals) {
  std::vector<InnerPoint> points(tree.leaves.size());
  for (const LeafPortal& portal : portals)
    for (const std::uint32_t leaf : portal.leaves) {
      for (const math::Vec3d& corner : portal.winding) points[leaf].sum += corner;
      points[leaf].count += static_cast<double>(portal.winding.size());
      ++points[leaf].portals;
    }
  return points;
}

// Whether a tree may take a plane and that of a winding for one, as far as the winding reaches, though they
// meet at an angle: a flatter one is the same plane, given twice.
bool nearly_in(const Winding& winding, const math::Vec3d& normal, const Plane& plane) {
  constexpr double kNear = 0.15;  // units
  return on_plane_for(normal, plane.normal) < kOnPlane &&
         std::ranges::all_of(
             winding, [&](const math::Vec3d& point) { return std::abs(plane.distance_to(point)) < kNear; });
}

// Places faces one after another.
class FacePlacer {
 public:
  FacePlacer(const Tree& tree, const PlaneSet& planes) : tree_(tree), planes_(planes) {}

  std::vector<TreeFace> place(std::span<const TreeFace> faces) {
    for (const TreeFace& face : faces) find_node(face, face.winding, tree_.root);
    return std::move(placed_);
  }

 private:
  // `near`: the last node on the way down in whose plane the winding nearly lies, -1 without one.
  void find_node(const TreeFace& face, Winding winding, std::int32_t child, std::int32_t near = -1) {
    while (child >= 0) {
      const TreeNode& node = tree_.nodes[static_cast<std::size_t>(child)];
      const Plane& plane = planes_[node.plane];
      const math::Vec3d& outwards = planes_[face.plane].normal;
      if (nearly_in(winding, outwards, plane)) near = child;
      const double on_plane = on_plane_for(outwards, plane.normal);
      const WindingSide side = side_of(winding, plane, on_plane);
      if (side == WindingSide::kFront || side == WindingSide::kBack) {
        child = node.children[side == WindingSide::kFront ? 0 : 1];
        continue;
      }
      if (side == WindingSide::kOn) {
        const std::size_t facing = glm::dot(outwards, plane.normal) > 0 ? 0 : 1;
        if (node.plane == stored(face.plane)) {
          place_at(child, face.plane, face, std::move(winding));
          return;
        }
        child = node.children[facing];
        continue;
      }
      WindingParts parts = split(winding, plane, on_plane);
      const bool in_front = !is_tiny(parts.front), behind = !is_tiny(parts.back);
      if (!in_front && !behind) return;
      if (in_front && behind) find_node(face, std::move(parts.front), node.children[0], near);
      winding = std::move(behind ? parts.back : parts.front);
      child = node.children[behind ? 1 : 0];
    }
    if (near < 0) return;
    // What stands out from a plane by a sliver counted as lying behind it, here and not in the first tree.
    const PlaneIndex plane = tree_.nodes[static_cast<std::size_t>(near)].plane;
    const bool facing = glm::dot(planes_[face.plane].normal, planes_[plane].normal) > 0;
    place_at(near, facing ? plane : turned(plane), face, std::move(winding));
  }

  void place_at(std::int32_t number, PlaneIndex plane, const TreeFace& face, Winding winding) {
    const TreeNode& node = tree_.nodes[static_cast<std::size_t>(number)];
    TreeFace placed{winding, plane, face.surface, static_cast<std::uint32_t>(number), {}};
    find_leaves(std::move(winding), planes_[plane].normal, node.children[node.plane == plane ? 0 : 1],
                placed.leaves);
    placed_.push_back(std::move(placed));
  }

  void find_leaves(Winding winding, const math::Vec3d& outwards, std::int32_t child,
                   std::vector<std::uint32_t>& out) {
    while (child >= 0) {
      const TreeNode& node = tree_.nodes[static_cast<std::size_t>(child)];
      const Plane& plane = planes_[node.plane];
      const double on_plane = on_plane_for(outwards, plane.normal);
      const WindingSide side = side_of(winding, plane, on_plane);
      if (side != WindingSide::kBoth) {
        const bool front =
            side == WindingSide::kFront || (side == WindingSide::kOn && glm::dot(outwards, plane.normal) > 0);
        child = node.children[front ? 0 : 1];
        continue;
      }
      WindingParts parts = split(winding, plane, on_plane);
      const bool in_front = !is_tiny(parts.front), behind = !is_tiny(parts.back);
      if (!in_front && !behind) return;
      if (in_front && behind) find_leaves(std::move(parts.front), outwards, node.children[0], out);
      winding = std::move(behind ? parts.back : parts.front);
      child = node.children[behind ? 1 : 0];
    }
    out.push_back(static_cast<std::uint32_t>(~child));
  }

  const Tree& tree_;
  const PlaneSet& planes_;
  std::vector<TreeFace> placed_;
};

}  // namespace

SecondTree make_second_tree(const Tree& first, std::span<const LeafPortal> portals,
                            std::span<const Brush> brushes, const PlaneSet& planes) {
  SecondTree second;
  second.tree = build_tree(only_bounding(first, portals, brushes), planes, Cover::kNone, [](double) {});
  second.portals = make_leaf_portals(second.tree, planes);
  const std::vector<InnerPoint> points = inner_points(second.tree, second.portals.portals);
  for (std::size_t i = 0; i < second.tree.leaves.size(); ++i) {
    TreeLeaf& leaf = second.tree.leaves[i];
    constexpr int kMinWalls = 4;
    if (!second.portals.is_outermost[i] && points[i].portals < kMinWalls)
      continue;  // a sliver: what its brushes say
    // Outside is the same everywhere; the corner of the box is outside.
    const math::Vec3d inside =
        second.portals.is_outermost[i] ? first.box.mins + 1.0 : points[i].sum / points[i].count;
    const TreeLeaf& known = first.leaves[first.leaf_at(inside, planes)];
    leaf.fill = known.fill;
    leaf.structure = known.structure;
  }
  return second;
}

std::vector<TreeFace> place_faces(std::span<const TreeFace> faces, const Tree& tree, const PlaneSet& planes) {
  return FacePlacer(tree, planes).place(faces);
}

}  // namespace temblor::compiler
