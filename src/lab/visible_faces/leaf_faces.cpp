#include "lab/visible_faces/leaf_faces.h"

#include <cmath>

#include "render/view/clip_box.h"

namespace temblor::lab {

namespace {

// The engine's walk (render/view/visible_faces.cpp) with the test moved from nodes to leaves.
class LeafWalk {
 public:
  LeafWalk(const render::FrameContext& context, const render::ViewFrame& view,
           const render::LevelTables& tables)
      : level_(context.level()),
        tables_(tables),
        view_(view),
        draws_faces_(context.settings.draw_world),
        is_overview_(context.scene.is_overview),
        opacities_(render::world_opacities(context.scene, context.arena())),
        states_(context.arena().allocate_filled(level_.faces.size(), State::kOutsidePvs)),
        node_marked_(context.arena().allocate_filled<std::uint8_t>(level_.nodes.size(), 0)),
        leaf_visible_(context.arena().allocate_filled<std::uint8_t>(level_.leaves.size(), 0)),
        leaf_keys_(context.arena().allocate_filled(level_.leaves.size(), render::kNotVisited)),
        faces_(context.arena(), 1024),
        deferred_faces_(context.arena(), 64),
        open_(context.arena(), 256) {}

  void mark_leaves(std::span<const std::uint8_t> row) {
    for (std::size_t byte = 0; byte < row.size(); ++byte)
      for (unsigned bits = row[byte]; bits != 0; bits &= bits - 1) {
        const std::size_t leaf = byte * 8 + static_cast<std::size_t>(__builtin_ctz(bits)) + 1;
        if (leaf < level_.leaves.size()) mark_leaf(leaf);
      }
  }

  render::VisibleFaces find_faces() {
    open_.push_back({level_.world().head, -1, render::kClipAll});
    while (!open_.empty()) {
      const Step step = open_.back();
      open_.pop_back();
      if (step.side >= 0)
        add_faces(level_.node(step.child.node()), step.side);
      else if (step.child.is_leaf())
        enter_leaf(base::to_size(step.child.leaf()));
      else
        enter_node(step);
    }
    return {faces_.view(), deferred_faces_.view(), opacities_, leaf_keys_, node_marked_, faces_in_pvs_};
  }
  std::uint64_t planes_tested() const { return planes_tested_; }

 private:
  enum class State : std::uint8_t { kOutsidePvs, kInPvs, kFrontVisible, kBackVisible };

  // A subtree to walk (side < 0), or the faces of a node on its side 0 or 1.
  struct Step {
    world::Child child;
    int side;
    int flags;
  };

  void mark_leaf(std::size_t leaf) {
    const world::Leaf& marked = level_.leaves[leaf];
    if (is_overview_ &&
        (marked.contents == world::Contents::kSky || marked.contents == world::Contents::kSolid))
      return;
    leaf_visible_[leaf] = 1;
    for (const world::FaceIndex face : marked_faces(marked)) {
      State& state = states_[base::to_size(face)];
      faces_in_pvs_ += state == State::kOutsidePvs;
      state = State::kInPvs;
    }
    for (std::uint32_t node = tables_.leaf_parent[leaf];
         node != render::LevelTables::kNoParent && node_marked_[node] == 0; node = tables_.node_parent[node])
      node_marked_[node] = 1;
  }

  std::span<const world::FaceIndex> marked_faces(const world::Leaf& leaf) const {
    return std::span(level_.marked_faces).subspan(leaf.first_marked_face, leaf.marked_face_count);
  }

  // Does what render::facing() does, for a plane of the world.
  double compute_facing(const world::Plane& plane) {
    ++planes_tested_;
    const math::Vec3d normal(plane.normal);
    return view_.perspective ? glm::dot(normal, view_.eye_world) - static_cast<double>(plane.distance)
                             : -glm::dot(normal, view_.axes.forward);
  }

  void enter_node(const Step& step) {
    const world::Node& node = level_.node(step.child.node());
    if (node_marked_[base::to_size(step.child.node())] == 0) return;
    const int flags = render::clip_box(view_.frustum, node.bounds, step.flags);
    if (flags == render::kOutside) return;
    const double towards = compute_facing(level_.planes[node.plane]);  // for the order only
    const int side = towards >= 0 ? 0 : 1;
    // Last in, first out, so this is the opposite of the order of visits.
    open_.push_back({node.children[static_cast<std::size_t>(1 - side)], -1, flags});
    if (node.face_count > 0 && std::abs(towards) >= render::kEdgeOn) open_.push_back({step.child, side, 0});
    open_.push_back({node.children[static_cast<std::size_t>(side)], -1, flags});
  }

  void enter_leaf(std::size_t leaf) {
    if (leaf_visible_[leaf] == 0) return;
    leaf_keys_[leaf] = next_key_++;
    if (!draws_faces_) return;
    for (const world::FaceIndex number : marked_faces(level_.leaves[leaf])) {
      State& state = states_[base::to_size(number)];
      if (state != State::kInPvs) continue;  // another leaf has tested it
      const world::Face& face = level_.face(number);
      const double facing = compute_facing(level_.planes[face.plane]);
      state =
          (face.back_side ? -facing : facing) >= render::kEdgeOn ? State::kFrontVisible : State::kBackVisible;
    }
  }

  // A face's place in the order is that of its node. A file may store it with a node of another plane.
  void add_faces(const world::Node& node, int side) {
    for (std::uint32_t number = node.first_face; number < node.first_face + node.face_count; ++number) {
      if (states_[number] != State::kFrontVisible) continue;
      const world::Face& face = level_.faces[number];
      const render::FaceOpacity& opacity = opacities_[base::to_size(face.texture)];
      if (face.back_side != (side == 1) || opacity.opacity <= 0) continue;
      (opacity.is_deferred() ? deferred_faces_ : faces_)
          .push_back({base::to_index<world::FaceIndex>(number), next_key_++});
    }
  }

  const world::Level& level_;
  const render::LevelTables& tables_;
  const render::ViewFrame& view_;
  const bool draws_faces_, is_overview_;
  std::span<const render::FaceOpacity> opacities_;
  std::span<State> states_;  // by face
  std::span<std::uint8_t> node_marked_, leaf_visible_;
  std::span<render::SortKey> leaf_keys_;
  base::ArenaVector<render::VisibleFace> faces_, deferred_faces_;
  base::ArenaVector<Step> open_;
  render::SortKey next_key_ = render::kNotVisited + 1;
  std::uint32_t faces_in_pvs_ = 0;
  std::uint64_t planes_tested_ = 0;
};

}  // namespace

render::FrameStages make_leaf_faces(std::span<const double> /*values*/, Counter* counter) {
  render::FrameStages stages;
  stages.find_visible_faces = [=](const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::LevelTables& tables) {
    LeafWalk walk(context, view, tables);
    walk.mark_leaves(render::find_leaves_in_pvs(context, view));
    const render::VisibleFaces visible = walk.find_faces();
    if (counter != nullptr) counter->add({.planes_tested = walk.planes_tested()});
    return visible;
  };
  return stages;
}

std::uint64_t count_planes_tested(const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::VisibleFaces& visible) {
  const world::Level& level = context.level();
  struct Subtree {
    world::Child child;
    int flags;
  };
  base::ArenaVector<Subtree> open(context.arena(), 256);
  open.push_back({level.world().head, render::kClipAll});
  std::uint64_t count = 0;
  while (!open.empty()) {
    const Subtree subtree = open.back();
    open.pop_back();
    if (subtree.child.is_leaf() || visible.node_marked[base::to_size(subtree.child.node())] == 0) continue;
    const world::Node& node = level.node(subtree.child.node());
    const int flags = render::clip_box(view.frustum, node.bounds, subtree.flags);
    if (flags == render::kOutside) continue;
    ++count;
    for (const world::Child child : node.children) open.push_back({child, flags});
  }
  return count;
}

}  // namespace temblor::lab
