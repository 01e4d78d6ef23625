// Method: walk the path through the tree front to back. Where the path crosses a plane, cut it 1/32 unit
// before the plane. Walk the near part first, then the far part, until the space after a cut is solid: that
// cut ends the trace.
//
// Written from the observed behavior of the original, with one difference: a path that starts in solid is
// followed through any number of solid leaves, so that all_solid is exact.
#include "world/trace.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace temblor::world {
namespace {

constexpr double kSurfaceGap = 1.0 / 32;  // units that a trace keeps from a surface
constexpr double kStepBack = 0.1;         // fraction of a piece
constexpr float kLowHeight = 36;          // units, of Half-Life's ducking player

// A common view of the nodes and leaves of hull 0 and the clipnodes of the other hulls and of parts of hulls.
class HullTree {
 public:
  HullTree(const Level& level, ModelIndex model_index, Hull hull)
      : level_(level), clipnodes_(level.clipnodes), is_drawn_(hull == Hull::kPoint) {
    const Model& model = level.models[base::to_size(model_index)];
    head_ = is_drawn_ ? model.head.value : model.clip_heads[static_cast<std::size_t>(hull) - 1];
  }
  HullTree(const Level& level, const HullPart& part)
      : level_(level), clipnodes_(part.clipnodes), is_drawn_(false), head_(part.head) {}

  // A position in the tree: >= 0 is a node, < 0 is a leaf or contents.
  std::int32_t head() const { return head_; }
  const Plane& plane(std::int32_t node) const {
    const auto i = static_cast<std::size_t>(node);
    return level_.planes[is_drawn_ ? level_.nodes[i].plane : clipnodes_[i].plane];
  }
  std::int32_t child(std::int32_t node, std::size_t side) const {
    const auto i = static_cast<std::size_t>(node);
    return is_drawn_ ? level_.nodes[i].children[side].value : clipnodes_[i].children[side];
  }
  Contents contents_at_end(std::int32_t end) const {
    if (is_drawn_) return level_.leaf(Child{end}.leaf()).contents;
    return static_cast<Contents>(end);
  }

  Contents contents_below(std::int32_t node, const math::Vec3d& point) const {
    while (node >= 0) node = child(node, distance_to(plane(node), point) >= 0 ? 0 : 1);
    return contents_at_end(node);
  }

 private:
  const Level& level_;
  std::span<const Clipnode> clipnodes_;
  bool is_drawn_;  // the tree of nodes and leaves that is drawn
  std::int32_t head_;
};

// A piece of the path from `start` to `end`, with both ends as fractions of the whole path.
struct Piece {
  math::Vec3d start, end;
  double start_fraction, end_fraction;

  math::Vec3d point(double along) const { return start + (end - start) * along; }
  double fraction(double along) const { return start_fraction + (end_fraction - start_fraction) * along; }
};

// A cut: the part of the path after it is traced if everything before it is open.
struct Crossing {
  std::int32_t node;
  std::size_t near_side;
  Piece piece;   // as it reached the node
  double along;  // the fraction at which the piece is cut
};

// A stack without heap allocations for trees of ordinary depth.
class CrossingStack {
 public:
  void push(const Crossing& crossing) {
    if (size_ < first_.size())
      first_[size_] = crossing;
    else
      rest_.push_back(crossing);
    ++size_;
  }
  std::optional<Crossing> pop() {
    if (size_ == 0) return std::nullopt;
    --size_;
    if (size_ < first_.size()) return first_[size_];
    const Crossing crossing = rest_.back();
    rest_.pop_back();
    return crossing;
  }

 private:
  std::array<Crossing, 64> first_;
  std::vector<Crossing> rest_;
  std::size_t size_ = 0;
};

// Follows a piece down the near sides to the leaf that contains its start, and records the planes it crosses.
std::int32_t descend(const HullTree& tree, std::int32_t node, Piece piece, CrossingStack& io_crossings) {
  while (node >= 0) {
    const Plane& plane = tree.plane(node);
    const double start_distance = distance_to(plane, piece.start);
    const double end_distance = distance_to(plane, piece.end);
    const std::size_t near_side = start_distance >= 0 ? 0 : 1;
    if ((end_distance >= 0) == (start_distance >= 0)) {
      node = tree.child(node, near_side);
      continue;
    }
    const double gap = near_side == 0 ? -kSurfaceGap : kSurfaceGap;
    const double along = std::clamp((start_distance + gap) / (start_distance - end_distance), 0.0, 1.0);
    io_crossings.push({node, near_side, piece, along});
    piece.end = piece.point(along);
    piece.end_fraction = piece.fraction(along);
    node = tree.child(node, near_side);
  }
  return node;
}

// Adds the contents of a leaf that the path enters to the result.
void record_contents(Contents contents, Trace& io_trace) {
  if (contents == Contents::kSolid) return;
  io_trace.all_solid = false;
  (contents == Contents::kEmpty ? io_trace.in_open : io_trace.in_water) = true;
}

// Ends the trace at a cut, and sets the plane, facing the start of the path.
void stop_at(const HullTree& tree, const Crossing& crossing, Trace& io_trace) {
  const Plane& plane = tree.plane(crossing.node);
  const float sign = crossing.near_side == 0 ? 1.0f : -1.0f;
  io_trace.plane_normal = plane.normal * sign;
  io_trace.plane_distance = plane.distance * sign;
  // Where planes meet at a sharp angle, the cut may be behind another plane, so step back along the piece
  // until the end is open, as the original does.
  double along = crossing.along;
  math::Vec3 end(crossing.piece.point(along));
  while (along > 0 && tree.contents_below(tree.head(), math::Vec3d(end)) == Contents::kSolid) {
    along = std::max(0.0, along - kStepBack);
    end = math::Vec3(crossing.piece.point(along));
  }
  io_trace.end = end;
  io_trace.fraction = static_cast<float>(crossing.piece.fraction(along));
}

Trace trace_tree(const HullTree& tree, const math::Vec3& start, const math::Vec3& end) {
  Trace trace;
  trace.end = end;
  trace.all_solid = true;
  CrossingStack crossings;
  const Piece path{math::Vec3d(start), math::Vec3d(end), 0, 1};
  Contents contents = tree.contents_at_end(descend(tree, tree.head(), path, crossings));
  trace.start_solid = contents == Contents::kSolid;
  record_contents(contents, trace);
  while (const std::optional<Crossing> crossing = crossings.pop()) {
    const Piece& piece = crossing->piece;
    const std::int32_t far_child = tree.child(crossing->node, 1 - crossing->near_side);
    const Piece far{piece.point(crossing->along), piece.end, piece.fraction(crossing->along),
                    piece.end_fraction};
    contents = tree.contents_at_end(descend(tree, far_child, far, crossings));
    if (contents == Contents::kSolid && !trace.all_solid) {
      stop_at(tree, *crossing, trace);
      break;
    }
    record_contents(contents, trace);
  }
  return trace;
}

}  // namespace

HullChoice choose_hull(const Level& level, const math::Vec3& box_mins, const math::Vec3& box_maxs) {
  const float width = box_maxs.x - box_mins.x;
  if (width < 3) return {Hull::kPoint, box_mins};
  Hull hull = width <= 32 ? Hull::kPlayer : Hull::kLarge;
  if (level.is_half_life && hull == Hull::kPlayer && box_maxs.z - box_mins.z <= kLowHeight) hull = Hull::kLow;
  return {hull, box_mins - level.hull_boxes[static_cast<std::size_t>(hull) - 1].mins};
}

Trace trace_line(const Level& level, ModelIndex model, Hull hull, const math::Vec3& start,
                 const math::Vec3& end) {
  return trace_tree(HullTree(level, model, hull), start, end);
}

Trace trace_line(const Level& level, const HullPart& part, const math::Vec3& start, const math::Vec3& end) {
  return trace_tree(HullTree(level, part), start, end);
}

Trace trace_box_through_model(const Level& level, ModelIndex model, const math::Vec3& model_origin,
                              const math::Bounds& box, const math::Vec3& start, const math::Vec3& end) {
  const HullChoice choice = choose_hull(level, box.mins, box.maxs);
  const math::Vec3 to_hull = choice.offset - model_origin;
  Trace trace = trace_line(level, model, choice.hull, start + to_hull, end + to_hull);
  trace.end = trace.fraction == 1 ? end : trace.end - to_hull;
  return trace;
}

Contents hull_contents(const Level& level, ModelIndex model, Hull hull, const math::Vec3& point) {
  const HullTree tree(level, model, hull);
  return tree.contents_below(tree.head(), math::Vec3d(point));
}

Contents hull_contents(const Level& level, const HullPart& part, const math::Vec3& point) {
  return HullTree(level, part).contents_below(part.head, math::Vec3d(point));
}

}  // namespace temblor::world
