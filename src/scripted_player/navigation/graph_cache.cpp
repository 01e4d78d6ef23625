#include "scripted_player/navigation/graph_cache.h"

#include <bit>

namespace temblor::player {
namespace {

// Writes values as 32-bit words. Lists begin with their size, so different values have different words.
class Words {
 public:
  void add(std::uint32_t value) { words_.push_back(value); }
  void add(std::int32_t value) { add(static_cast<std::uint32_t>(value)); }
  void add(std::size_t value) { add(static_cast<std::uint32_t>(value)); }
  void add(bool value) { add(std::uint32_t{value}); }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  void add(const math::Vec3& value) {
    for (int axis = 0; axis < 3; ++axis) add(value[axis]);
  }
  void add(const math::Bounds& value) {
    add(value.mins);
    add(value.maxs);
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void add(Enum value) { add(static_cast<std::uint32_t>(value)); }
  void add(const world::Plane& plane) {
    add(plane.normal);
    add(plane.distance);
    add(plane.axis);
  }
  void add(const world::Node& node) {
    add(node.plane);
    for (const world::Child child : node.children) add(child.value);
  }
  void add(const world::Leaf& leaf) { add(leaf.contents); }
  void add(const world::Clipnode& node) {
    add(node.plane);
    for (const std::int32_t child : node.children) add(child);
  }
  void add(const world::Model& model) {
    add(model.bounds);
    add(model.head.value);
    for (const std::int32_t head : model.clip_heads) add(head);
  }
  void add(const MoverPart& part) {
    add(part.model);
    add(part.box);
    add_all(part.places);
  }
  void add(const Mover& mover) {
    add(mover.kind);
    add(mover.states);
    add_all(mover.parts);
  }
  void add(const Trigger& trigger) {
    add(trigger.kind);
    add(trigger.box);
    add(trigger.destination);
    add(trigger.velocity);
    add(trigger.damage);
    add(trigger.needs_use);
  }
  void add(const StaticModel& model) {
    add(model.model);
    add(model.origin);
  }
  template <typename List>
  void add_all(const List& list) {
    add(std::size(list));
    for (const auto& value : list) add(value);
  }
  std::vector<std::uint32_t> take() { return std::move(words_); }

 private:
  std::vector<std::uint32_t> words_;
};

std::vector<std::uint32_t> write_input(const NavSpace& space, std::span<const math::Vec3> starts) {
  Words words;
  const world::Level& level = space.level();
  words.add_all(level.planes);
  words.add_all(level.nodes);
  words.add_all(level.leaves);
  words.add_all(level.clipnodes);
  words.add_all(level.models);
  words.add_all(space.facts().movers);
  words.add_all(space.facts().triggers);
  words.add_all(space.facts().static_models);
  words.add_all(space.facts().static_boxes);
  words.add_all(starts);
  return words.take();
}

}  // namespace

std::shared_ptr<const NavGraph> GraphCache::find_or_make(const NavSpace& space,
                                                         std::span<const math::Vec3> starts) {
  std::vector<std::uint32_t> input = write_input(space, starts);
  for (const Entry& entry : entries_)
    if (entry.input == input) return entry.graph;
  entries_.push_back({std::move(input), std::make_shared<const NavGraph>(space, starts)});
  return entries_.back().graph;
}

}  // namespace temblor::player
