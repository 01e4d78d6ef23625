#include "lab/models/edges/model_edges.h"

namespace temblor::lab {

void EdgeList::unlink(std::uint32_t edge) {
  const Links links = links_[edge];
  (links.before == kNoEdge ? first_ : links_[links.before].next) = links.next;
  if (links.next != kNoEdge) links_[links.next].before = links.before;
}

// `before` may be kNoEdge: the edge becomes the first.
void EdgeList::link_after(std::uint32_t before, std::uint32_t edge) {
  std::uint32_t& link = before == kNoEdge ? first_ : links_[before].next;
  links_[edge] = {before, link};
  if (link != kNoEdge) links_[link].before = edge;
  link = edge;
}

void EdgeList::add(std::span<const std::uint32_t> numbers) {
  // A list of their own, linked by `next` only.
  std::uint32_t sorted = kNoEdge;
  for (const std::uint32_t edge : numbers) {
    std::uint32_t* link = &sorted;
    for (; *link != kNoEdge && edges_[*link].column < edges_[edge].column; link = &links_[*link].next)
      ++steps_;
    links_[edge].next = *link;
    *link = edge;
  }
  std::uint32_t before = kNoEdge, active = first_;
  while (sorted != kNoEdge) {
    const std::uint32_t rest = links_[sorted].next;
    for (; active != kNoEdge && edges_[active].column < edges_[sorted].column; active = links_[active].next) {
      before = active;
      ++steps_;
    }
    link_after(before, sorted);
    before = sorted;
    sorted = rest;
  }
}

void EdgeList::advance(int row, double width) {
  for (std::uint32_t edge = first_; edge != kNoEdge;) {
    const std::uint32_t next = links_[edge].next;
    ModelEdge& own = edges_[edge];
    if (own.end_row <= row) {
      unlink(edge);
      edge = next;
      continue;
    }
    own.column = own.columns.next(width);
    std::uint32_t before = links_[edge].before;
    if (before != kNoEdge && edges_[before].column > own.column) {
      unlink(edge);
      for (; before != kNoEdge && edges_[before].column > own.column; before = links_[before].before)
        ++steps_;
      link_after(before, edge);
    }
    edge = next;
  }
}

}  // namespace temblor::lab
