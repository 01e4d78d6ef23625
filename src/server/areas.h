// Which entities are near a box: a tree of the level's ground plan, cut in half four times (each time across
// its longer side), every entity in the smallest part that holds all of it. Knows boxes, not entities.
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
  // ones; in each part in the order that they were linked.
  void find(const math::Bounds& box, AreaKind kind, std::vector<vm::EntityIndex>& io_found) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr int kCuts = 4;
  static constexpr std::size_t kParts = (1 << (kCuts + 1)) - 1;

  // Parts are numbered as in a heap: the halves of part p are 2p + 1, on the cut's upper side, and 2p + 2.
  struct Part {
    int axis = 0;
    float distance = 0;
    bool is_cut = false;
  };
  struct List {
    std::uint32_t first = kNone, last = kNone;
  };
  struct Link {
    math::Bounds box;
    std::uint32_t before = kNone, behind = kNone;
    std::uint32_t list = kNone;  // into lists_; kNone: not linked
  };

  void cut(std::size_t part, const math::Bounds& bounds, int cuts_left);
  std::size_t part_of(const math::Bounds& box) const;
  void find_below(std::size_t part, const math::Bounds& box, AreaKind kind,
                  std::vector<vm::EntityIndex>& io_found) const;

  std::array<Part, kParts> parts_{};
  std::array<List, 2 * kParts> lists_{};  // of part p: 2p solid, 2p + 1 triggers
  std::vector<Link> links_;               // by entity
};

}  // namespace temblor::server
