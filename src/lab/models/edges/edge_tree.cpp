#include "lab/models/edges/model_edges.h"

namespace temblor::lab {

namespace {

// A hash of the number, so that pictures and times do not depend on a state.
std::uint32_t find_rank(std::uint32_t edge) {
  std::uint32_t mixed = (edge + 1) * 0x9e3779b9u;
  mixed ^= mixed >> 16;
  mixed *= 0x85ebca6bu;
  return mixed ^ mixed >> 13;
}

}  // namespace

std::uint32_t& EdgeTree::child_link(std::uint32_t parent, std::uint32_t child) {
  if (parent == kNoEdge) return root_;
  return nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right;
}

void EdgeTree::rotate_up(std::uint32_t edge) {
  Node& node = nodes_[edge];
  const std::uint32_t parent = node.parent;
  Node& above = nodes_[parent];
  child_link(above.parent, parent) = edge;
  node.parent = above.parent;
  std::uint32_t& moved = above.left == edge ? node.right : node.left;
  (above.left == edge ? above.left : above.right) = moved;
  if (moved != kNoEdge) nodes_[moved].parent = parent;
  moved = parent;
  above.parent = edge;
}

void EdgeTree::insert(std::uint32_t edge) {
  std::uint32_t parent = kNoEdge, before = kNoEdge, next = kNoEdge;
  bool goes_left = false;
  for (std::uint32_t at = root_; at != kNoEdge; ++steps_) {
    parent = at;
    goes_left = edges_[edge].column < edges_[at].column;
    (goes_left ? next : before) = at;
    at = goes_left ? nodes_[at].left : nodes_[at].right;
  }
  nodes_[edge] = {parent, kNoEdge, kNoEdge, before, next, find_rank(edge)};
  (parent == kNoEdge ? root_ : goes_left ? nodes_[parent].left : nodes_[parent].right) = edge;
  (before == kNoEdge ? first_ : nodes_[before].next) = edge;
  if (next != kNoEdge) nodes_[next].before = edge;
  while (nodes_[edge].parent != kNoEdge && nodes_[nodes_[edge].parent].rank < nodes_[edge].rank)
    rotate_up(edge);
}

// Needs no order, so edges can be taken out after their columns have changed.
void EdgeTree::erase(std::uint32_t edge) {
  while (nodes_[edge].left != kNoEdge || nodes_[edge].right != kNoEdge) {
    const std::uint32_t left = nodes_[edge].left, right = nodes_[edge].right;
    const bool lifts_left = right == kNoEdge || (left != kNoEdge && nodes_[left].rank > nodes_[right].rank);
    rotate_up(lifts_left ? left : right);
  }
  const Node& node = nodes_[edge];
  child_link(node.parent, edge) = kNoEdge;
  (node.before == kNoEdge ? first_ : nodes_[node.before].next) = node.next;
  if (node.next != kNoEdge) nodes_[node.next].before = node.before;
}

void EdgeTree::advance(int row, double width) {
  displaced_.clear();
  std::int32_t largest = 0;
  for (std::uint32_t edge = first_; edge != kNoEdge;) {
    const std::uint32_t next = nodes_[edge].next;
    ModelEdge& own = edges_[edge];
    if (own.end_row <= row) {
      erase(edge);
    } else {
      own.column = own.columns.next(width);
      if (own.column < largest) {
        erase(edge);
        displaced_.push_back(edge);
      } else {
        largest = own.column;
      }
    }
    edge = next;
  }
  add(displaced_.view());
}

}  // namespace temblor::lab
