// Which entities are near a box: trees of the level's ground plan, cut in half again and again (each time
// across the longer side), every entity in the smallest part that holds all of it. Knows boxes, not entities.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"
#include "vm/program.h"

namespace temblor::server {

enum class AreaKind : std::uint8_t { kSolid, kTrigger };

class Areas {
 public:
  explicit Areas(const math::Bounds& world_bounds);

  // Puts an entity behind the others of its part, or moves it there. A box that is no box (NaN) belongs to
  // the whole level's part, and touches nothing.
  void link(vm::EntityIndex entity, const math::Bounds& box, AreaKind kind);
  // Nothing happens where it is not linked.
  void unlink(vm::EntityIndex entity);

  // Entities of that kind whose boxes touch `box`, appended: the whole level's part first, then the smaller
  // ones; in each part in the order that they were linked. The order of triggers is the original's.
  void find(const math::Bounds& box, AreaKind kind, std::vector<vm::EntityIndex>& io_found) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // Parts are numbered as in a heap: the halves of part p are 2p + 1, on the cut's upper side, and 2p + 2.
  struct Part {
    int axis = 0;
    float distance = 0;
    bool is_cut = false;
    std::uint32_t first = kNone, last = kNone;  // of its list
  };
  struct Tree {
    std::vector<Part> parts;

    Tree(const math::Bounds& bounds, int cuts);
    void cut(std::size_t part, const math::Bounds& bounds, int cuts_left);
    std::size_t part_of(const math::Bounds& box) const;
  };
  struct Link {
    math::Bounds box;
    std::uint32_t before = kNone, behind = kNone;
    std::uint32_t part = kNone;  // kNone: not linked
    AreaKind kind{};
  };

  void find_below(const Tree& tree, std::size_t part, const math::Bounds& box,
                  std::vector<vm::EntityIndex>& io_found) const;

  std::array<Tree, 2> trees_;  // by kind
  std::vector<Link> links_;    // by entity
};

}  // namespace temblor::server
