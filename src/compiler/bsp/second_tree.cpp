// Method: a side of a brush is kept as a splitting side if some portal of the first tree in its plane
// separates leaves with different contents, or shows a face. The tree is then built again from the same
// brushes, and each of its leaves takes its contents from the first tree. Faces, which were made from the
// first tree, are pushed down the second one. If the contents differ anywhere, the brushes there keep all
// their sides, and the tree is built once more.
#include "compiler/bsp/second_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace temblor::compiler {
namespace {

// Whether boxes overlap or touch.
bool touch(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.mins - kOnPlaneEpsilon, b.maxs)) &&
         glm::all(glm::lessThanEqual(b.mins - kOnPlaneEpsilon, a.maxs));
}

// Returns whether that changes the brush.
bool split_by_all_sides(Brush& io_brush) {
  bool has_changed = false;
  for (BrushSide& side : io_brush.sides) has_changed |= !std::exchange(side.splits, true);
  return has_changed;
}

// The brushes with only those sides splitting at which the contents change or a face is visible. Sides of
// hint brushes always split.
std::vector<Brush> keep_bounding_sides(const Tree& tree, std::span<const LeafPortal> portals,
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
    const bool is_seen = find_surface_between(front, back, plane, brushes) != kNoSurface ||
                         find_surface_between(back, front, flipped(plane), brushes) != kNoSurface;
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
    // No brush of these leaves has a side there: the plane belongs to another brush and is so near to a side
    // of one of these that the tree took them for one. Keep all their sides.
    for (const TreeLeaf* leaf : {&front, &back})
      for (const std::uint32_t brush : leaf->brushes) split_by_all_sides(kept[brush]);
    // Or neither leaf has a brush: the outside was filled up to here, through a gap too thin for the flood.
    // The wall behind that gap bounds the level, but a filled leaf hides it.
    if (front.brushes.empty() && back.brushes.empty())
      for (Brush& brush : kept)
        if (touch(brush.box, box)) split_by_all_sides(brush);
  }
  return kept;
}

// Leaves with fewer portals are slivers, whose inner point may lie on their rim.
constexpr int kMinWalls = 4;

// A point inside each bounded leaf: the mean of its portals' corners.
struct InnerPoint {
  math::Vec3d sum{0.0};
  double count = 0;
  int portals = 0;
};

std::vector<InnerPoint> find_inner_points(const Tree& tree, std::span<const LeafPortal> portals) {
  std::vector<InnerPoint> points(tree.leaves.size());
  for (const LeafPortal& portal : portals)
    for (const std::uint32_t leaf : portal.leaves) {
      for (const math::Vec3d& corner : portal.winding) points[leaf].sum += corner;
      points[leaf].count += static_cast<double>(portal.winding.size());
      ++points[leaf].portals;
    }
  return points;
}

// Whether a winding is so near to a plane everywhere that a tree may take it to be in that plane, although
// they meet at an angle.
bool nearly_in(const Winding& winding, const math::Vec3d& normal, const Plane& plane) {
  constexpr double kNearPlane = 0.15;  // units
  return on_plane_epsilon(normal, plane.normal) < kOnPlaneEpsilon &&
         std::ranges::all_of(winding, [&](const math::Vec3d& point) {
           return std::abs(plane.distance_to(point)) < kNearPlane;
         });
}

// Moves faces down a tree.
class FacePlacer {
 public:
  FacePlacer(const Tree& tree, const PlaneSet& planes) : tree_(tree), planes_(planes) {}

  std::vector<TreeFace> place(std::span<const TreeFace> faces) {
    for (const TreeFace& face : faces) find_node(face, face.winding, tree_.root);
    return std::move(placed_);
  }

 private:
  // `near`: the last node on the way down whose plane the winding is nearly in; -1: none.
  void find_node(const TreeFace& face, Winding winding, std::int32_t child, std::int32_t near = -1) {
    while (child >= 0) {
      const TreeNode& node = tree_.nodes[static_cast<std::size_t>(child)];
      const Plane& plane = planes_[node.plane];
      const math::Vec3d& outward = planes_[face.plane].normal;
      if (nearly_in(winding, outward, plane)) near = child;
      const double on_plane = on_plane_epsilon(outward, plane.normal);
      const WindingSide side = find_side(winding, plane, on_plane);
      if (side == WindingSide::kFront || side == WindingSide::kBack) {
        child = node.children[side == WindingSide::kFront ? 0 : 1];
        continue;
      }
      if (side == WindingSide::kOn) {
        const std::size_t facing = glm::dot(outward, plane.normal) > 0 ? 0 : 1;
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
    // The winding sticks out from a plane by a sliver; here it counted as behind, while in the first tree it
    // did not.
    const PlaneIndex plane = tree_.nodes[static_cast<std::size_t>(near)].plane;
    const bool facing = glm::dot(planes_[face.plane].normal, planes_[plane].normal) > 0;
    place_at(near, facing ? plane : flipped(plane), face, std::move(winding));
  }

  // Adds the face to a node, in one of its plane's two directions.
  void place_at(std::int32_t number, PlaneIndex plane, const TreeFace& face, Winding winding) {
    const TreeNode& node = tree_.nodes[static_cast<std::size_t>(number)];
    TreeFace placed{winding, plane, face.surface, static_cast<std::uint32_t>(number), {}};
    find_leaves(std::move(winding), planes_[plane].normal, node.children[node.plane == plane ? 0 : 1],
                placed.leaves);
    placed_.push_back(std::move(placed));
  }

  // Collects the leaves in front of the winding, which see it.
  void find_leaves(Winding winding, const math::Vec3d& outward, std::int32_t child,
                   std::vector<std::uint32_t>& out) {
    while (child >= 0) {
      const TreeNode& node = tree_.nodes[static_cast<std::size_t>(child)];
      const Plane& plane = planes_[node.plane];
      const double on_plane = on_plane_epsilon(outward, plane.normal);
      const WindingSide side = find_side(winding, plane, on_plane);
      if (side != WindingSide::kBoth) {
        const bool front =
            side == WindingSide::kFront || (side == WindingSide::kOn && glm::dot(outward, plane.normal) > 0);
        child = node.children[front ? 0 : 1];
        continue;
      }
      WindingParts parts = split(winding, plane, on_plane);
      const bool in_front = !is_tiny(parts.front), behind = !is_tiny(parts.back);
      if (!in_front && !behind) return;
      if (in_front && behind) find_leaves(std::move(parts.front), outward, node.children[0], out);
      winding = std::move(behind ? parts.back : parts.front);
      child = node.children[behind ? 1 : 0];
    }
    out.push_back(static_cast<std::uint32_t>(~child));
  }

  const Tree& tree_;
  const PlaneSet& planes_;
  std::vector<TreeFace> placed_;
};

// By leaf, whether it reaches less than this from its inner point in some direction.
constexpr double kThin = 0.1;  // units
std::vector<bool> find_thin_leaves(const Tree& tree, std::span<const LeafPortal> portals,
                                   std::span<const InnerPoint> points, const PlaneSet& planes) {
  std::vector<bool> is_thin(tree.leaves.size());
  for (const LeafPortal& portal : portals) {
    const Plane& plane = planes[tree.nodes[portal.node].plane];
    for (const std::uint32_t leaf : portal.leaves)
      if (std::abs(plane.distance_to(points[leaf].sum / points[leaf].count)) <= kThin) is_thin[leaf] = true;
  }
  return is_thin;
}

// A thin leaf may reach through a room and through brushes in it, because pieces of brushes that are as thin
// get lost. It must not be a sheet across the room, so the weakest fill at its portals counts.
void weaken_thin_leaves(const Tree& first, const PlaneSet& planes, std::span<const InnerPoint> points,
                        SecondTree& io_second) {
  const std::vector<bool> is_thin =
      find_thin_leaves(io_second.tree, io_second.portals.portals, points, planes);
  for (const LeafPortal& portal : io_second.portals.portals)
    for (const std::uint32_t leaf : portal.leaves) {
      if (!is_thin[leaf] || points[leaf].portals < kMinWalls || io_second.portals.is_outermost[leaf])
        continue;
      math::Vec3d center(0.0);
      for (const math::Vec3d& corner : portal.winding)
        center += corner / static_cast<double>(portal.winding.size());
      constexpr double kInward = 0.5;  // of the way to the inner point
      const math::Vec3d inside = glm::mix(center, points[leaf].sum / points[leaf].count, kInward);
      const TreeLeaf& known = first.leaves[first.leaf_at(inside, planes)];
      TreeLeaf& io_leaf = io_second.tree.leaves[leaf];
      io_leaf.fill = std::min(io_leaf.fill, known.fill);
      io_leaf.structure = std::min(io_leaf.structure, known.structure);
    }
}

// A leaf of the second tree may lie in any number of brushes, so its fill comes from the first tree, at a
// point inside it.
SecondTree build_second_tree(const Tree& first, const std::vector<Brush>& brushes, const PlaneSet& planes) {
  SecondTree second;
  second.tree = build_tree(brushes, planes, Cover::kNone, [](double) {});
  second.portals = make_leaf_portals(second.tree, planes);
  const std::vector<InnerPoint> points = find_inner_points(second.tree, second.portals.portals);
  for (std::size_t i = 0; i < second.tree.leaves.size(); ++i) {
    TreeLeaf& leaf = second.tree.leaves[i];
    if (!second.portals.is_outermost[i] && points[i].portals < kMinWalls)
      continue;  // a sliver: keep the fill that its brushes gave it
    // Outside is the same everywhere, so one corner of the box stands for all of it.
    const math::Vec3d inside =
        second.portals.is_outermost[i] ? first.box.mins + 1.0 : points[i].sum / points[i].count;
    const TreeLeaf& known = first.leaves[first.leaf_at(inside, planes)];
    leaf.fill = known.fill;
    leaf.structure = known.structure;
  }
  weaken_thin_leaves(first, planes, points, second);
  return second;
}

// By leaf of the first tree, whether the second one has other contents at its inner point. Thin leaves do not
// count.
std::vector<bool> find_wrong_leaves(const Tree& first, std::span<const LeafPortal> portals,
                                    const Tree& second, const PlaneSet& planes) {
  const std::vector<InnerPoint> points = find_inner_points(first, portals);
  const std::vector<bool> is_thin = find_thin_leaves(first, portals, points, planes);
  std::vector<bool> is_wrong(first.leaves.size());
  for (std::size_t i = 0; i < is_wrong.size(); ++i) {
    if (points[i].portals < kMinWalls || is_thin[i]) continue;
    const math::Vec3d inside = points[i].sum / points[i].count;
    is_wrong[i] = second.leaves[second.leaf_at(inside, planes)].fill != first.leaves[i].fill;
  }
  return is_wrong;
}

// Makes every side of the brushes at wrong leaves split. Returns whether that changes any brush.
bool keep_sides_at(const std::vector<bool>& is_wrong, const Tree& first, std::span<const LeafPortal> portals,
                   std::vector<Brush>& io_kept) {
  bool has_changed = false;
  for (const LeafPortal& portal : portals) {
    if (!is_wrong[portal.leaves[0]] && !is_wrong[portal.leaves[1]]) continue;
    for (const std::uint32_t leaf : portal.leaves)
      for (const std::uint32_t brush : first.leaves[leaf].brushes)
        has_changed |= split_by_all_sides(io_kept[brush]);
  }
  return has_changed;
}

}  // namespace

SecondTree make_second_tree(const Tree& first, std::span<const LeafPortal> portals,
                            std::span<const Brush> brushes, const PlaneSet& planes) {
  std::vector<Brush> kept = keep_bounding_sides(first, portals, brushes);
  // Where planes are so near to each other that the trees took different ones, more sides must split.
  for (;;) {
    SecondTree second = build_second_tree(first, kept, planes);
    const std::vector<bool> is_wrong = find_wrong_leaves(first, portals, second.tree, planes);
    if (!keep_sides_at(is_wrong, first, portals, kept)) return second;
  }
}

std::vector<TreeFace> place_faces(std::span<const TreeFace> faces, const Tree& tree, const PlaneSet& planes) {
  return FacePlacer(tree, planes).place(faces);
}

}  // namespace temblor::compiler
