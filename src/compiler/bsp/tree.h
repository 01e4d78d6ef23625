// A binary space partition of brushes. Every leaf lies inside a fixed set of brushes: no brush ends within a
// leaf.
//
// The builder picks a splitting plane among the brushes' sides, cuts every brush in two, and recurses until
// no side is left (Fuchs, Kedem and Naylor, "On visible surface generation by a priori tree structures",
// 1980).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "compiler/bsp/brushes/brush.h"

namespace temblor::compiler {

// A child >= 0 is a node; a child < 0 is leaf ~child.
struct TreeNode {
  PlaneIndex plane;                        // stored(), so it faces along its main axis
  std::array<std::int32_t, 2> children{};  // in front, behind
  bool is_detail = false;                  // made for a detail brush: all leaves below are one cluster
};

// A convex region that no brush's side cuts.
struct TreeLeaf {
  Fill fill = Fill::kEmpty;            // the strongest of its brushes' fills
  Fill structure = Fill::kEmpty;       // the same without detail brushes
  std::vector<std::uint32_t> brushes;  // indices of the brushes that fill it, the highest first
};

// The margin of a tree's box around the brushes, in units.
constexpr double kRoomAround = 128;

// Children have higher numbers than their parents.
struct Tree {
  std::vector<TreeNode> nodes;
  std::vector<TreeLeaf> leaves;
  std::int32_t root = -1;
  Box box;  // of all brushes, with a margin

  bool is_leaf(std::int32_t child) const { return child < 0; }
  // The leaf at a point; a point on a plane counts as in front.
  std::uint32_t leaf_at(const math::Vec3d& point, const PlaneSet& planes) const;
  // The leaves that touch a box, and perhaps some that only come near it.
  std::vector<std::uint32_t> leaves_touching(const Box& box_world, const PlaneSet& planes) const;
};

// Which brush that fills a whole node makes all others in it irrelevant, so that the node becomes a leaf at
// once.
enum class Cover : std::uint8_t {
  kNone,     // none: some sides do not split, so whether a brush fills a node is unknown
  kLast,     // a solid brush with the highest index: its textures are the ones that show
  kAnySolid  // any solid brush: the hull is never drawn
};
// Builds a tree. Structural brushes split first, so that detail splits only the leaves they leave. The
// splitting plane is the one with the lowest cost:
//
//   + 8 for each brush that it splits
//   - 4 for each side in it, since that side then needs no node of its own
//   + 1 for each brush by which its two sides are out of balance
//   - 6 if it is along an axis
//
// A node with more than 96 brushes takes the axial plane nearest to its center instead, which is much faster
// to find. `grown` is called for each new leaf with its share of the work; all shares add up to 1.
Tree build_tree(std::span<const Brush> brushes, const PlaneSet& planes, Cover cover,
                base::FunctionRef<void(double share)> grown);

// Removes nodes whose two children are leaves that `same` calls equal; the first leaf remains.
void prune(Tree& io_tree, base::FunctionRef<bool(const TreeLeaf&, const TreeLeaf&)> same);

}  // namespace temblor::compiler
