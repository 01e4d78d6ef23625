// The edges of a band's triangles, and the two structures that keep those of the current row in order of
// their columns: a linked list, and a balanced tree.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/alias/affine_triangle.h"

namespace temblor::lab {

constexpr std::uint32_t kNoEdge = 0xffffffff;

// A side of a triangle that crosses rows. Neighbors do not share it: each has its own.
struct ModelEdge {
  render::EdgeColumns columns;
  std::int32_t column;   // in the current row: the first pixel right of the edge
  std::int32_t end_row;  // exclusive
  std::uint32_t triangle;
  bool is_leading;  // the triangle is to its right
};

// Edges as a list, as the article's edge table has them. The edges of a row are sorted among themselves by
// walking a list, then merged into the active ones.
class EdgeList {
 public:
  EdgeList(std::span<ModelEdge> edges, base::Arena& arena)
      : edges_(edges), links_(arena.allocate<Links>(edges.size())) {}

  // Adds the edges that begin in a row.
  void add(std::span<const std::uint32_t> numbers);
  // Moves all edges to the next row, except those that end there.
  void advance(int row, double width);
  // In order, with kNoEdge after the last.
  std::uint32_t first() const { return first_; }
  std::uint32_t next(std::uint32_t edge) const { return links_[edge].next; }
  // Edges that were passed to find a place.
  std::uint64_t steps() const { return steps_; }

 private:
  struct Links {
    std::uint32_t before, next;
  };
  void unlink(std::uint32_t edge);
  void link_after(std::uint32_t before, std::uint32_t edge);

  std::span<ModelEdge> edges_;
  std::span<Links> links_;
  std::uint32_t first_ = kNoEdge;
  std::uint64_t steps_ = 0;
};

// Edges as a treap (Seidel and Aragon, "Randomized Search Trees", 1996), which stays balanced because each
// edge has a random rank. Neighbors are linked as well, so that a row is walked like a list.
class EdgeTree {
 public:
  EdgeTree(std::span<ModelEdge> edges, base::Arena& arena)
      : edges_(edges), nodes_(arena.allocate<Node>(edges.size())), displaced_(arena, 256) {}

  void add(std::span<const std::uint32_t> numbers) {
    for (const std::uint32_t edge : numbers) insert(edge);
  }
  void advance(int row, double width);
  std::uint32_t first() const { return first_; }
  std::uint32_t next(std::uint32_t edge) const { return nodes_[edge].next; }
  std::uint64_t steps() const { return steps_; }

 private:
  struct Node {
    std::uint32_t parent, left, right;
    std::uint32_t before, next;
    std::uint32_t rank;  // no smaller than that of its children
  };
  void insert(std::uint32_t edge);
  void erase(std::uint32_t edge);
  // Lifts a node above its parent.
  void rotate_up(std::uint32_t edge);
  std::uint32_t& child_link(std::uint32_t parent, std::uint32_t child);

  std::span<ModelEdge> edges_;
  std::span<Node> nodes_;
  base::ArenaVector<std::uint32_t> displaced_;
  std::uint32_t root_ = kNoEdge, first_ = kNoEdge;
  std::uint64_t steps_ = 0;
};

}  // namespace temblor::lab
