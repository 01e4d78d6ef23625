// Finds the entities whose boxes touch a box.
//
// Method: two binary trees over the level's ground plan, one for solids and one for triggers. Each cut halves
// the longer side. An entity is in the smallest part that holds its whole box:
//
//   +-------+---+---+
//   |   a   | b |   |     a, b: in a half and in a quarter
//   |     +-c-+ |   |     c: crosses the first cut, so it is in the whole level's part
//   |     +-+-+ |   |
//   +-------+---+---+
//
// The trees know boxes and numbers, not entities.
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

  // Appends an entity to its part's list, or moves it there. A box with NaN goes into the whole level's part,
  // and touches nothing.
  void link(vm::EntityIndex entity, const math::Bounds& box, AreaKind kind);
  // Does nothing if the entity is not linked.
  void unlink(vm::EntityIndex entity);

  // Appends the entities of this kind whose boxes touch `box`: those of the whole level's part first, then
  // those of smaller ones; in each part in the order in which they were linked. For triggers that is the
  // original's order.
  void find(const math::Bounds& box, AreaKind kind, std::vector<vm::EntityIndex>& io_found) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // Parts are numbered as in a binary heap: the halves of part p are 2p + 1 (above the cut) and 2p + 2 (below
  // it).
  struct Part {
    int axis = 0;
    float distance = 0;
    bool is_cut = false;
    std::uint32_t first = kNone, last = kNone;  // of the part's list
  };
  struct Tree {
    std::vector<Part> parts;

    Tree(const math::Bounds& bounds, int cuts);
    void cut(std::size_t part, const math::Bounds& bounds, int cuts_left);
    // The smallest part that holds the whole box.
    std::size_t find_part(const math::Bounds& box) const;
  };
  struct Link {
    math::Bounds box;
    std::uint32_t previous = kNone, next = kNone;
    std::uint32_t part = kNone;  // kNone: not linked
    AreaKind kind{};
  };

  void find_below(const Tree& tree, std::size_t part, const math::Bounds& box,
                  std::vector<vm::EntityIndex>& io_found) const;

  // The trees, and a doubly linked list for each part, threaded through links_: linking allocates nothing.
  std::array<Tree, 2> trees_;  // by kind
  std::vector<Link> links_;    // by entity
};

}  // namespace temblor::server
