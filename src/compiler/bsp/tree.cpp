// Method: each brush starts as one piece. A node cuts the pieces that its plane crosses, so a piece is always
// the part of a brush inside the node, closed by the cut surfaces. When no piece has a side left that splits,
// every remaining piece fills the whole node, which becomes a leaf.
//
// Parts of brushes that would be slivers are not cut off: the piece goes to the side that has nearly all of
// it. That makes trees smaller, and a leaf's contents wrong by less than kSliver.
#include "compiler/bsp/tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace temblor::compiler {
namespace {

// A node with more brushes is split by a plane near its center.
constexpr std::size_t kMaxWeighed = 96;

constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

// A side of a piece, clipped to the node.
struct PieceSide {
  PlaneIndex plane;
  // The number of its plane, either way, among all planes of the tree's brushes; kNoNumber: made by a cut.
  std::uint32_t number;
  bool splits;
  Winding winding;
};

// The part of a brush that is inside a node.
struct Piece {
  std::uint32_t brush;
  bool is_detail;
  Box box;
  std::vector<PieceSide> sides;
};

using Pieces = std::vector<Piece>;

enum class Where { kFront, kBack, kBoth };

// How far a piece reaches in front of a plane and behind it, in units. If both are at least kSliver, they may
// be underestimates.
struct Reach {
  double front, back;
};

// A part that sticks out by less is not worth a piece.
constexpr double kSliver = 0.1;  // units

// Boxes give a quick answer for axial planes, and for others if they are clear of the plane.
Reach compute_reach(const Piece& piece, const Plane& plane) {
  // Stored planes along an axis face up that axis.
  if (plane.axis < 3)
    return {piece.box.maxs[plane.axis] - plane.distance, plane.distance - piece.box.mins[plane.axis]};
  const math::Vec3d middle = (piece.box.mins + piece.box.maxs) * 0.5,
                    half = (piece.box.maxs - piece.box.mins) * 0.5;
  const double at = plane.distance_to(middle), wide = glm::dot(half, glm::abs(plane.normal));
  if (at - wide >= -kOnPlaneEpsilon || at + wide <= kOnPlaneEpsilon) return {at + wide, wide - at};
  Reach found{-1e30, -1e30};
  for (const PieceSide& side : piece.sides) {
    for (const math::Vec3d& point : side.winding) {
      const double d = plane.distance_to(point);
      found = {std::max(found.front, d), std::max(found.back, -d)};
    }
    if (found.front >= kSliver && found.back >= kSliver) break;
  }
  return found;
}

// On which side of a plane a piece counts as being; both: it must be cut.
Where find_side(const Reach& reach) {
  if (reach.back <= kOnPlaneEpsilon) return Where::kFront;
  if (reach.front <= kOnPlaneEpsilon) return Where::kBack;
  if (reach.back < kSliver && reach.front > kSliver) return Where::kFront;
  if (reach.front < kSliver && reach.back > kSliver) return Where::kBack;
  return Where::kBoth;
}

// Whether an earlier cut, rather than a side of its brush, ends a piece in front of a plane or behind it.
// Then the brush goes on beyond the cut.
bool ends_at_cut(const Piece& piece, const Plane& plane, Where beyond, const PlaneSet& planes) {
  constexpr double kNearlyParallel = 0.995;  // cosine
  const double way = beyond == Where::kFront ? 1 : -1;
  return std::ranges::any_of(piece.sides, [&](const PieceSide& side) {
    return side.number == kNoNumber &&
           way * glm::dot(planes[side.plane].normal, plane.normal) > kNearlyParallel;
  });
}

Box compute_box(const Piece& piece) {
  Box box;
  for (const PieceSide& side : piece.sides) box.add(side.winding);
  return box;
}

// Memory that is reused from one cut to the next.
struct CutScratch {
  std::vector<WindingSide> lies;  // by side of the piece
  Winding between;                // the cut surface, in the plane
};

// Splits a piece into its parts in front of a plane and behind it. If one of them would have no volume, the
// other is the whole piece, unchanged.
std::pair<Piece, Piece> split(Piece piece, PlaneIndex number, const PlaneSet& planes, CutScratch& scratch) {
  const Plane& plane = planes[number];
  scratch.between = make_base_winding(plane);
  for (const PieceSide& side : piece.sides) {
    cut_to_back(scratch.between, planes[side.plane], true);
    if (scratch.between.empty()) break;
  }
  const bool is_closed = !scratch.between.empty();
  std::size_t front_count = is_closed ? 1 : 0, back_count = front_count;
  scratch.lies.clear();
  for (const PieceSide& side : piece.sides) {
    const WindingSide lies = scratch.lies.emplace_back(find_side(side.winding, plane));
    front_count += lies == WindingSide::kFront || lies == WindingSide::kBoth ? 1 : 0;
    back_count += lies == WindingSide::kBack || lies == WindingSide::kBoth ? 1 : 0;
  }
  std::pair<Piece, Piece> parts;
  auto& [front, back] = parts;
  constexpr std::size_t kMinSides = 4;
  if (front_count < kMinSides || back_count < kMinSides) {
    (front_count >= kMinSides ? front : back) = std::move(piece);
    return parts;
  }
  front.brush = back.brush = piece.brush;
  front.is_detail = back.is_detail = piece.is_detail;
  front.sides.reserve(front_count);
  back.sides.reserve(back_count);
  for (std::size_t i = 0; i < piece.sides.size(); ++i) {
    PieceSide& side = piece.sides[i];
    if (scratch.lies[i] == WindingSide::kFront) {
      front.sides.push_back(std::move(side));
    } else if (scratch.lies[i] == WindingSide::kBack) {
      back.sides.push_back(std::move(side));
    } else if (scratch.lies[i] == WindingSide::kBoth) {
      // However narrow the part is: without it, the piece would be open on that side.
      WindingParts cut = split(side.winding, plane);
      front.sides.push_back({side.plane, side.number, side.splits, std::move(cut.front)});
      back.sides.push_back({side.plane, side.number, side.splits, std::move(cut.back)});
    }
  }
  if (is_closed) {
    // The cut surface closes both parts. Each lies behind it as seen from the other.
    front.sides.push_back(
        {flipped(number), kNoNumber, false, Winding(scratch.between.rbegin(), scratch.between.rend())});
    back.sides.push_back({number, kNoNumber, false, scratch.between});
  }
  front.box = compute_box(front);
  back.box = compute_box(back);
  return parts;
}

class TreeBuilder {
 public:
  TreeBuilder(std::span<const Brush> brushes, const PlaneSet& planes, Cover cover,
              base::FunctionRef<void(double)> grown)
      : brushes_(brushes), planes_(planes), cover_(cover), grown_(grown) {}

  Tree build() {
    const std::vector<PlaneIndex> used = collect_planes();
    weighed_.assign(used.size(), 0);
    Pieces pieces;
    for (std::size_t i = 0; i < brushes_.size(); ++i) {
      const Brush& brush = brushes_[i];
      Piece piece{static_cast<std::uint32_t>(i), brush.is_detail, brush.box, {}};
      for (const BrushSide& side : brush.sides)
        if (!side.winding.empty())
          piece.sides.push_back({side.plane, find_number(used, side.plane), side.splits, side.winding});
      tree_.box.add(brush.box.mins);
      tree_.box.add(brush.box.maxs);
      pieces.push_back(std::move(piece));
    }
    if (tree_.box.is_empty()) tree_.box.add(math::Vec3d(0.0));
    tree_.box.mins -= kRoomAround;
    tree_.box.maxs += kRoomAround;
    tree_.root = grow(std::move(pieces), tree_.box, 1);
    return std::move(tree_);
  }

 private:
  // In order, and only those of this tree: a map with many models has far more planes than any model.
  std::vector<PlaneIndex> collect_planes() const {
    std::vector<PlaneIndex> used;
    for (const Brush& brush : brushes_)
      for (const BrushSide& side : brush.sides) used.push_back(stored(side.plane));
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
  }

  static std::uint32_t find_number(std::span<const PlaneIndex> used, PlaneIndex plane) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(used, stored(plane)) - used.begin());
  }

  // Builds the subtree for the pieces in `box`, whose share of the whole work is `share`. Returns a child
  // number.
  std::int32_t grow(Pieces pieces, const Box& box, double share) {
    keep_cover_alone(pieces);
    bool is_detail = false;
    const std::optional<PlaneIndex> plane = choose(pieces, box, is_detail);
    if (!plane) {
      grown_(share);
      return add_leaf(pieces);
    }
    Pieces front, back;
    divide(std::move(pieces), *plane, front, back);
    const auto index = static_cast<std::int32_t>(tree_.nodes.size());
    tree_.nodes.push_back({*plane, {}, is_detail});
    Box front_box = box, back_box = box;
    const Plane& p = planes_[*plane];
    if (p.axis < 3) front_box.mins[p.axis] = back_box.maxs[p.axis] = p.distance;
    const auto pieces_in_front = static_cast<double>(front.size());
    const double front_share =
        share * pieces_in_front / std::max(1.0, pieces_in_front + static_cast<double>(back.size()));
    const std::int32_t front_child = grow(std::move(front), front_box, front_share);
    const std::int32_t back_child = grow(std::move(back), back_box, share - front_share);
    tree_.nodes[static_cast<std::size_t>(index)].children = {front_child, back_child};
    return index;
  }

  // If a solid brush fills the whole node, removes all others from it.
  void keep_cover_alone(Pieces& io_pieces) const {
    if (cover_ == Cover::kNone || io_pieces.size() < 2) return;
    std::uint32_t last = 0;
    for (const Piece& piece : io_pieces) last = std::max(last, piece.brush);
    for (Piece& piece : io_pieces) {
      if (brushes_[piece.brush].fill != Fill::kSolid || (cover_ == Cover::kLast && piece.brush != last))
        continue;
      const auto splits = [](const PieceSide& side) { return side.splits; };
      if (std::any_of(piece.sides.begin(), piece.sides.end(), splits)) continue;
      Piece cover = std::move(piece);
      io_pieces.clear();
      io_pieces.push_back(std::move(cover));
      return;
    }
  }

  // A side in a node's plane must not ask for another node. It also decides where its piece goes. Distances
  // cannot: all of a very thin piece counts as in the plane, and it would fill the wrong half of the node.
  static std::optional<Where> settle_sides(PlaneIndex number, Piece& io_piece) {
    std::optional<Where> where;
    for (PieceSide& side : io_piece.sides) {
      if (stored(side.plane) != number) continue;
      side.splits = false;
      where = side.plane == number ? Where::kBack : Where::kFront;
    }
    return where;
  }

  // A sliver in which the brush does not end is cut off after all: otherwise, the brush would have a crack.
  Where find_division(const Piece& piece, const Plane& plane) const {
    const Reach reach = compute_reach(piece, plane);
    const Where where = find_side(reach);
    if (where == Where::kBoth || reach.front <= kOnPlaneEpsilon || reach.back <= kOnPlaneEpsilon)
      return where;
    const Where beyond = where == Where::kFront ? Where::kBack : Where::kFront;
    return ends_at_cut(piece, plane, beyond, planes_) ? Where::kBoth : where;
  }

  // Distributes the pieces of a node to its two sides.
  void divide(Pieces pieces, PlaneIndex number, Pieces& out_front, Pieces& out_back) {
    const Plane& plane = planes_[number];
    for (Piece& piece : pieces) {
      switch (settle_sides(number, piece).value_or(find_division(piece, plane))) {
        case Where::kFront:
          out_front.push_back(std::move(piece));
          break;
        case Where::kBack:
          out_back.push_back(std::move(piece));
          break;
        case Where::kBoth: {
          auto [front, back] = split(std::move(piece), number, planes_, scratch_);
          if (!front.sides.empty()) out_front.push_back(std::move(front));
          if (!back.sides.empty()) out_back.push_back(std::move(back));
        }
      }
    }
  }

  // The splitting plane for a node; nothing: it becomes a leaf.
  std::optional<PlaneIndex> choose(const Pieces& pieces, const Box& box, bool& out_is_detail) {
    for (const bool detail : {false, true}) {
      out_is_detail = detail;
      if (pieces.size() > kMaxWeighed)
        if (const auto plane = find_middle_plane(pieces, box, detail)) return plane;
      if (const auto plane = find_cheapest_plane(pieces, detail)) return plane;
    }
    return std::nullopt;
  }

  // The axial plane nearest to the center of the node's longest side, within the middle half.
  std::optional<PlaneIndex> find_middle_plane(const Pieces& pieces, const Box& box, bool detail) const {
    const math::Vec3d size = box.maxs - box.mins;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double middle = (box.mins[axis] + box.maxs[axis]) / 2;
    double nearest = size[axis] / 4;
    std::optional<PlaneIndex> found;
    for (const Piece& piece : pieces) {
      if (piece.is_detail != detail) continue;
      for (const PieceSide& side : piece.sides) {
        const Plane& plane = planes_[stored(side.plane)];
        if (!side.splits || plane.axis != axis) continue;
        const double away = std::abs(plane.distance - middle);
        if (away >= nearest) continue;
        nearest = away;
        found = stored(side.plane);
      }
    }
    return found;
  }

  // The plane with the lowest cost among the sides that still split.
  std::optional<PlaneIndex> find_cheapest_plane(const Pieces& pieces, bool detail) {
    // With very many candidates, an evenly spaced sample of them is enough.
    constexpr std::size_t kMaxTests = 40000;
    const std::size_t step = std::max<std::size_t>(1, pieces.size() * pieces.size() * 6 / kMaxTests);
    ++round_;
    long least = 0;
    std::optional<PlaneIndex> found;
    std::size_t candidate = 0;
    for (const Piece& piece : pieces) {
      if (piece.is_detail != detail) continue;
      for (const PieceSide& side : piece.sides) {
        const PlaneIndex plane = stored(side.plane);
        if (!side.splits || std::exchange(weighed_[side.number], round_) == round_) continue;
        if (found && candidate++ % step != 0) continue;
        const long cost = compute_cost(plane, pieces);
        if (found && cost >= least) continue;
        least = cost;
        found = plane;
      }
    }
    return found;
  }

  // The cost that build_tree() describes.
  long compute_cost(PlaneIndex number, const Pieces& pieces) const {
    const Plane& plane = planes_[number];
    long split = 0, facing = 0, balance = 0;
    for (const Piece& piece : pieces) {
      const Reach by = compute_reach(piece, plane);
      const Where where = find_side(by);
      split += where == Where::kBoth ? 1 : 0;
      balance += where == Where::kFront ? 1 : where == Where::kBack ? -1 : 0;
      if (std::abs(by.front) > kOnPlaneEpsilon && std::abs(by.back) > kOnPlaneEpsilon) continue;
      for (const PieceSide& side : piece.sides) facing += stored(side.plane) == number ? 1 : 0;
    }
    return 8 * split - 4 * facing + std::abs(balance) - (plane.axis < 3 ? 6 : 0);
  }

  // Makes a leaf that its strongest brush fills.
  std::int32_t add_leaf(const Pieces& pieces) {
    TreeLeaf leaf;
    for (const Piece& piece : pieces) leaf.brushes.push_back(piece.brush);
    std::sort(leaf.brushes.rbegin(), leaf.brushes.rend());
    for (const Piece& piece : pieces) {
      const Fill fill = brushes_[piece.brush].fill;
      leaf.fill = std::max(leaf.fill, fill);
      if (!piece.is_detail) leaf.structure = std::max(leaf.structure, fill);
    }
    tree_.leaves.push_back(std::move(leaf));
    return ~static_cast<std::int32_t>(tree_.leaves.size() - 1);
  }

  std::span<const Brush> brushes_;
  const PlaneSet& planes_;
  Cover cover_;
  base::FunctionRef<void(double)> grown_;
  std::vector<std::uint32_t> weighed_;  // by PieceSide::number: the last round that tried the plane
  std::uint32_t round_ = 0;
  CutScratch scratch_;
  Tree tree_;
};

}  // namespace

std::uint32_t Tree::leaf_at(const math::Vec3d& point, const PlaneSet& planes) const {
  std::int32_t child = root;
  while (child >= 0) {
    const TreeNode& node = nodes[static_cast<std::size_t>(child)];
    child = node.children[planes[node.plane].distance_to(point) >= 0 ? 0 : 1];
  }
  return static_cast<std::uint32_t>(~child);
}

// A leaf near a corner of the box may be on the near side of all planes without touching it.
std::vector<std::uint32_t> Tree::leaves_touching(const Box& box_world, const PlaneSet& planes) const {
  const math::Vec3d center = (box_world.mins + box_world.maxs) * 0.5;
  const math::Vec3d half_size = (box_world.maxs - box_world.mins) * 0.5;
  std::vector<std::uint32_t> found;
  std::vector<std::int32_t> pending{root};
  while (!pending.empty()) {
    const std::int32_t child = pending.back();
    pending.pop_back();
    if (is_leaf(child)) {
      found.push_back(static_cast<std::uint32_t>(~child));
      continue;
    }
    const TreeNode& node = nodes[static_cast<std::size_t>(child)];
    const Plane& plane = planes[node.plane];
    const double distance = plane.distance_to(center), reach = glm::dot(half_size, glm::abs(plane.normal));
    if (distance >= -reach) pending.push_back(node.children[0]);
    if (distance <= reach) pending.push_back(node.children[1]);
  }
  return found;
}

Tree build_tree(std::span<const Brush> brushes, const PlaneSet& planes, Cover cover,
                base::FunctionRef<void(double)> grown) {
  return TreeBuilder(brushes, planes, cover, grown).build();
}

// Unused nodes and leaves stay in the lists; only the children change.
void prune(Tree& io_tree, base::FunctionRef<bool(const TreeLeaf&, const TreeLeaf&)> same) {
  // Children have higher numbers than their parents, so this goes from the leaves up.
  for (std::size_t i = io_tree.nodes.size(); i-- > 0;) {
    TreeNode& node = io_tree.nodes[i];
    for (std::int32_t& child : node.children) {
      if (child < 0) continue;
      const auto& below = io_tree.nodes[static_cast<std::size_t>(child)].children;
      if (below[0] >= 0 || below[1] >= 0) continue;
      if (same(io_tree.leaves[static_cast<std::size_t>(~below[0])],
               io_tree.leaves[static_cast<std::size_t>(~below[1])]))
        child = below[0];
    }
  }
}

}  // namespace temblor::compiler
