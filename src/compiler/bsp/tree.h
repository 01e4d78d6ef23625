// A binary space partition of brushes: every leaf is filled by the same brushes throughout.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "compiler/bsp/brushes/brush.h"

namespace temblor::compiler {

// A child of a node: another node (>= 0), or leaf ~child.
struct TreeNode {
  PlaneIndex plane;                        // as stored
  std::array<std::int32_t, 2> children{};  // in front, behind
  bool is_detail = false;                  // made for a detail brush: what is below is seen together
};

struct TreeLeaf {
  Fill fill = Fill::kEmpty;
  Fill structure = Fill::kEmpty;       // of what is not detail
  std::vector<std::uint32_t> brushes;  // in it, as places in the span; later ones first
};

struct Tree {
  std::vector<TreeNode> nodes;
  std::vector<TreeLeaf> leaves;
  std::int32_t root = -1;
  Box box;  // of everything, with some room around

  bool is_leaf(std::int32_t child) const { return child < 0; }
  std::uint32_t leaf_at(const math::Vec3d& point, const PlaneSet& planes) const;
};

// Structural brushes first, so that detail splits only what structure has left. Among the sides of the
// brushes in a node the plane is taken that costs least: 8 for a brush that it splits, 4 less for one that
// has a side in it, 1 for each brush that is more on one side than on the other, 6 less along an axis; where
// many brushes are left, the plane along an axis next to the node's middle, which is found quicker.
//
// `cover`: which brush, when it fills a node, makes all others in it meaningless.
enum class Cover : std::uint8_t {
  kNone,     // sides that do not split leave it open whether a brush fills a node
  kLast,     // a solid one behind which no other comes: what shows is known, too
  kAnySolid  // of what is never drawn
};
//
// `grown` is told of each leaf which share of the brushes' pieces it holds; all shares are 1 together.
Tree build_tree(std::span<const Brush> brushes, const PlaneSet& planes, Cover cover,
                base::FunctionRef<void(double share)> grown);

// Takes away nodes whose children are leaves that `same` says are one; the first keeps its number.
void prune(Tree& io_tree, base::FunctionRef<bool(const TreeLeaf&, const TreeLeaf&)> same);

}  // namespace temblor::compiler
