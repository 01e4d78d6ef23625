#include "compiler/bsp/leaf_portals.h"

#include <cmath>

namespace temblor::compiler {
namespace {

// Visits every node. `outsides_` are the planes of its ancestors, facing away from it, so cutting a winding
// to the back of all of them leaves the part inside the node.
class PortalMaker {
 public:
  PortalMaker(const Tree& tree, const PlaneSet& planes) : tree_(tree), planes_(planes) {
    out_.is_outermost.assign(tree.leaves.size(), false);
  }

  // The six faces of the tree's box say which leaves are at the edge; the nodes give the portals.
  LeafPortals make() {
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        Plane wall;
        wall.normal[axis] = side;
        wall.axis = axis;
        wall.distance = side > 0 ? tree_.box.maxs[axis] : -tree_.box.mins[axis];
        walls_.push_back(wall);
      }
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      Winding winding = make_base_winding(walls_[i]);
      for (std::size_t other = 0; other < walls_.size(); ++other)
        if (other != i) cut_to_back(winding, walls_[other], true);
      spread(tree_.root, std::move(winding), -walls_[i].normal, [&](std::uint32_t leaf, Winding part) {
        out_.is_outermost[leaf] = true;
        out_.exits.push_back({leaf, walls_[i].axis, std::move(part)});
      });
    }
    if (tree_.root >= 0) visit(tree_.root);
    return std::move(out_);
  }

 private:
  // Makes the portals in the plane of a node, then in its subtrees.
  void visit(std::int32_t number) {
    const TreeNode& node = tree_.nodes[static_cast<std::size_t>(number)];
    const Plane& plane = planes_[node.plane];
    Winding winding = make_base_winding(plane);
    for (const Plane& wall : walls_) cut_to_back(winding, wall, true);
    // From the node upward: the nearest ancestors cut off most.
    for (std::size_t i = outsides_.size(); i-- > 0 && !winding.empty();)
      cut_to_back(winding, planes_[outsides_[i]], true,
                  on_plane_epsilon(plane.normal, planes_[outsides_[i]].normal));
    if (!is_tiny(winding))
      spread(node.children[0], std::move(winding), plane.normal, [&](std::uint32_t front, Winding part) {
        spread(node.children[1], std::move(part), -plane.normal, [&](std::uint32_t back, Winding piece) {
          out_.portals.push_back({std::move(piece), static_cast<std::uint32_t>(number), {front, back}});
        });
      });
    for (const int side : {0, 1}) {
      if (node.children[static_cast<std::size_t>(side)] < 0) continue;
      outsides_.push_back(side == 0 ? flipped(node.plane) : node.plane);
      visit(node.children[static_cast<std::size_t>(side)]);
      outsides_.pop_back();
    }
  }

  // Pushes a winding on the surface of a subtree's volume down to the leaves: calls found(leaf, part) for
  // each leaf below `child` that it touches. `inward` points into the volume.
  template <typename Found>
  void spread(std::int32_t child, Winding winding, const math::Vec3d& inward, const Found& found) {
    while (child >= 0) {
      const TreeNode& node = tree_.nodes[static_cast<std::size_t>(child)];
      const Plane& plane = planes_[node.plane];
      const double on_plane = on_plane_epsilon(inward, plane.normal);
      switch (find_side(winding, plane, on_plane)) {
        case WindingSide::kOn:
          child = node.children[glm::dot(inward, plane.normal) > 0 ? 0 : 1];
          continue;
        case WindingSide::kFront:
          child = node.children[0];
          continue;
        case WindingSide::kBack:
          child = node.children[1];
          continue;
        case WindingSide::kBoth:
          break;
      }
      WindingParts parts = split(winding, plane, on_plane);
      const bool in_front = !is_tiny(parts.front), behind = !is_tiny(parts.back);
      if (!in_front && !behind) return;
      if (in_front && behind) spread(node.children[0], std::move(parts.front), inward, found);
      winding = std::move(behind ? parts.back : parts.front);
      child = node.children[behind ? 1 : 0];
    }
    found(static_cast<std::uint32_t>(~child), std::move(winding));
  }

  const Tree& tree_;
  const PlaneSet& planes_;
  std::vector<Plane> walls_;
  std::vector<PlaneIndex> outsides_;  // of the ancestors of the current node, facing away from it
  LeafPortals out_;
};

}  // namespace

LeafPortals make_leaf_portals(const Tree& tree, const PlaneSet& planes) {
  return PortalMaker(tree, planes).make();
}

}  // namespace temblor::compiler
