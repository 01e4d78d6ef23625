#include "render/view/visible_faces.h"

#include <cmath>

#include "render/view/clip_box.h"
#include "render/view/model_view.h"
#include "world/visibility.h"

namespace temblor::render {

namespace {

// False in solid space, outside the level, and in levels without visibility data: then everything is visible.
bool has_pvs(const world::Level& level, world::LeafIndex eye) {
  return eye != world::LeafIndex{0} && base::to_size(eye) <= level.visible_leaf_count &&
         level.leaf(eye).visibility_offset >= 0 && !level.visibility.empty();
}

// The marking pass and the front-to-back walk. The walk keeps its own stack, since trees from files may be
// deep.
class TreeWalk {
 public:
  TreeWalk(const FrameContext& context, const ViewFrame& view, const LevelTables& tables,
           std::span<const FaceOpacity> opacities, base::Arena& arena)
      : level_(context.level()),
        tables_(tables),
        view_(view),
        draws_faces_(context.settings.draw_world),
        is_overview_(context.scene.is_overview),
        opacities_(opacities),
        face_marked_(arena.allocate_filled<std::uint8_t>(level_.faces.size(), 0)),
        node_marked_(arena.allocate_filled<std::uint8_t>(level_.nodes.size(), 0)),
        leaf_visible_(arena.allocate_filled<std::uint8_t>(level_.leaves.size(), 0)),
        leaf_keys_(arena.allocate_filled<SortKey>(level_.leaves.size(), kNotVisited)),
        faces_(arena, 1024),
        deferred_faces_(arena, 64),
        open_(arena, 256) {}

  // Marks a leaf, its faces, and its ancestors, up to the first ancestor that is already marked. A leaf lists
  // the faces whose front is in it.
  void mark_leaf(std::size_t leaf) {
    const world::Leaf& marked = level_.leaves[leaf];
    if (is_overview_ &&
        (marked.contents == world::Contents::kSky || marked.contents == world::Contents::kSolid))
      return;
    leaf_visible_[leaf] = 1;
    for (std::uint32_t i = 0; i < marked.marked_face_count; ++i) {
      std::uint8_t& mark = face_marked_[base::to_size(level_.marked_faces[marked.first_marked_face + i])];
      faces_in_pvs_ += mark == 0;
      mark = kInPvs;
    }
    for (std::uint32_t node = tables_.leaf_parent[leaf];
         node != LevelTables::kNoParent && node_marked_[node] == 0; node = tables_.node_parent[node])
      node_marked_[node] = 1;
  }

  // Bit i of a PVS row stands for leaf i + 1.
  void mark_row(std::span<const std::uint8_t> row) {
    for (std::size_t byte = 0; byte < row.size(); ++byte)
      for (unsigned bits = row[byte]; bits != 0; bits &= bits - 1) {
        const std::size_t leaf = byte * 8 + static_cast<std::size_t>(__builtin_ctz(bits)) + 1;
        if (leaf < level_.leaves.size()) mark_leaf(leaf);
      }
  }

  VisibleFaces find_faces() {
    const world::Child head = level_.world().head;
    open_.push_back({head, -1, kClipAll});
    while (!open_.empty()) {
      const Step step = open_.back();
      open_.pop_back();
      if (step.side >= 0)
        enter_faces(level_.node(step.child.node()), step.side);
      else if (step.child.is_leaf())
        enter_leaf(base::to_size(step.child.leaf()));
      else
        enter_node(step);
    }
    return {faces_.view(), deferred_faces_.view(), opacities_, leaf_keys_, node_marked_, faces_in_pvs_};
  }

 private:
  // An entry of the stack: a subtree to walk (side < 0), or the faces in a node's plane that face side 0 or
  // 1.
  struct Step {
    world::Child child;
    int side;
    int flags;
  };

  void enter_node(const Step& step) {
    const world::Node& node = level_.node(step.child.node());
    if (node_marked_[base::to_size(step.child.node())] == 0) return;
    const int flags = clip_box(view_.frustum, node.bounds, step.flags);
    if (flags == kOutside) return;
    const world::Plane& plane = level_.planes[node.plane];
    // The side that the eye is on; in parallel projection, the side that the view comes from.
    const double towards = view_.perspective ? glm::dot(math::Vec3d(plane.normal), view_.eye_world) -
                                                   static_cast<double>(plane.distance)
                                             : -glm::dot(math::Vec3d(plane.normal), view_.axes.forward);
    const int side = towards >= 0 ? 0 : 1;
    // The stack is last in, first out: the far subtree, then the node's faces, then the near subtree are
    // pushed, so that they are visited in the opposite order.
    open_.push_back({node.children[static_cast<std::size_t>(1 - side)], -1, flags});
    if (draws_faces_ && node.face_count > 0 && std::abs(towards) >= kEdgeOn)
      open_.push_back({step.child, side, 0});
    open_.push_back({node.children[static_cast<std::size_t>(side)], -1, flags});
  }

  // Promotes the leaf's faces from "in the PVS" to "reached". Leaves in front of a node's plane are entered
  // before its faces are emitted, so a face is emitted only if a leaf that it borders was reached.
  void enter_leaf(std::size_t leaf) {
    if (leaf_visible_[leaf] == 0) return;
    leaf_keys_[leaf] = next_key_++;
    const world::Leaf& reached = level_.leaves[leaf];
    for (std::uint32_t i = 0; i < reached.marked_face_count; ++i)
      face_marked_[base::to_size(level_.marked_faces[reached.first_marked_face + i])] = kReached;
  }

  void enter_faces(const world::Node& node, int side) {
    for (std::uint32_t number = node.first_face; number < node.first_face + node.face_count; ++number) {
      const world::Face& face = level_.faces[number];
      if (face_marked_[number] != kReached || face.back_side != (side == 1)) continue;
      // Compilers store faces with the node whose plane they lie in, but a file may violate that.
      if (face.plane != node.plane && compute_facing(face) < kEdgeOn) continue;
      const FaceOpacity& opacity = opacities_[base::to_size(face.texture)];
      if (opacity.opacity <= 0) continue;
      (opacity.is_deferred() ? deferred_faces_ : faces_)
          .push_back({base::to_index<world::FaceIndex>(number), next_key_++});
    }
  }

  double compute_facing(const world::Face& face) const {
    const FacePlane plane = place_plane(level_, face, ModelView{});
    return facing(view_, plane.normal, plane.distance);
  }

  static constexpr std::uint8_t kInPvs = 1, kReached = 2;
  const world::Level& level_;
  const LevelTables& tables_;
  const ViewFrame& view_;
  const bool draws_faces_, is_overview_;
  std::span<const FaceOpacity> opacities_;
  std::span<std::uint8_t> face_marked_, node_marked_, leaf_visible_;
  std::span<SortKey> leaf_keys_;
  base::ArenaVector<VisibleFace> faces_, deferred_faces_;
  base::ArenaVector<Step> open_;
  SortKey next_key_ = kNotVisited + 1;
  std::uint32_t faces_in_pvs_ = 0;
};

}  // namespace

std::span<const std::uint8_t> find_leaves_in_pvs(const FrameContext& context, const ViewFrame& view) {
  const world::Level& level = context.level();
  std::vector<std::uint8_t>& row = context.arenas.pvs_row;
  const world::LeafIndex leaf = context.scene.pvs_leaf.value_or(view.eye_leaf);
  if (context.settings.use_pvs && view.perspective && has_pvs(level, leaf)) {
    world::decompress_pvs(level, leaf, row);
    const std::size_t bit = base::to_size(leaf) - 1;
    row[bit / 8] |= static_cast<std::uint8_t>(1 << bit % 8);
  } else {
    row.assign((level.leaves.size() + 6) / 8, 0xff);
  }
  return row;
}

VisibleFaces find_faces_in_leaves(const FrameContext& context, const ViewFrame& view,
                                  const LevelTables& tables, std::span<const std::uint8_t> leaves) {
  TreeWalk walk(context, view, tables, world_opacities(context.scene, context.arena()), context.arena());
  walk.mark_row(leaves);
  return walk.find_faces();
}

VisibleFaces find_visible_faces(const FrameContext& context, const ViewFrame& view,
                                const LevelTables& tables) {
  return find_faces_in_leaves(context, view, tables, find_leaves_in_pvs(context, view));
}

}  // namespace temblor::render
