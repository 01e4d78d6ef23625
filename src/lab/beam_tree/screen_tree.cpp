#include "lab/beam_tree/screen_tree.h"

#include <algorithm>
#include <bit>

namespace temblor::lab {

namespace {

// Children that are not nodes: a leaf that is covered, or the number of an open leaf.
constexpr std::uint32_t kCovered = 0xffffffff;
constexpr std::uint32_t kLeafBit = 0x80000000;
constexpr std::uint32_t kRootSlot = 0;  // the left child of node 0, which has no line
// Limits of memory and time.
constexpr std::size_t kMaxGroupsPerNode = 4;
constexpr std::uint64_t kMaxComparisonsPerNode = 16;

}  // namespace

OpenPixels::OpenPixels(int rows, int width, base::Arena& arena)
    : words_per_row_(static_cast<std::size_t>(width + 63) / 64),
      words_(arena.allocate_filled<std::uint64_t>(words_per_row_ * static_cast<std::size_t>(rows), 0)) {}

void OpenPixels::open(int row, int first, int end) {
  std::uint64_t* const words = words_.data() + static_cast<std::size_t>(row) * words_per_row_;
  for (int pixel = first; pixel < end; ++pixel) words[pixel / 64] |= std::uint64_t{1} << (pixel % 64);
}

template <typename Visit>
void OpenPixels::close(int row, int first, int end, Visit visit) {
  const std::span<std::uint64_t> words =
      words_.subspan(static_cast<std::size_t>(row) * words_per_row_, words_per_row_);
  for (int pixel = find(words, true, first, end); pixel < end; pixel = find(words, true, pixel, end)) {
    const int run_end = find(words, false, pixel, end);
    visit(pixel, run_end);
    for (; pixel < run_end; ++pixel)
      words[static_cast<std::size_t>(pixel) / 64] &= ~(std::uint64_t{1} << (pixel % 64));
  }
}

int OpenPixels::find(std::span<const std::uint64_t> row, bool is_open, int first, int end) const {
  for (int pixel = first; pixel < end;) {
    const std::uint64_t word = row[static_cast<std::size_t>(pixel) / 64];
    const std::uint64_t wanted = (is_open ? word : ~word) >> (pixel % 64);
    if (wanted != 0) return std::min(pixel + std::countr_zero(wanted), end);
    pixel = (pixel / 64 + 1) * 64;
  }
  return end;
}

RowGroup* RegionPool::allocate(int groups) {
  const auto count = static_cast<std::size_t>(groups);
  if (next_ + count > block_.size()) {
    block_ = arena_->allocate<RowGroup>(std::max(count, kBlockGroups));
    next_ = 0;
  }
  RowGroup* const region = block_.data() + next_;
  next_ += count;
  used_ += count;
  return region;
}

void RegionPool::give_back(const RowGroup* end) {
  const auto next = static_cast<std::size_t>(end - block_.data());
  used_ -= next_ - next;
  next_ = next;
}

ScreenTree::ScreenTree(const render::EdgeTable& table, const SurfaceEdges& edges, render::RowRange rows,
                       int width, std::size_t max_nodes, base::Arena& arena)
    : table_(table),
      rows_(rows),
      width_(width),
      max_nodes_(max_nodes),
      arena_(arena),
      outline_(table, edges, rows, width, arena),
      nodes_(arena, 4096),
      leaves_(arena, 4096),
      pool_(arena),
      stack_(arena, 256),
      scratch_(arena, 4096),
      spans_(arena, 4096) {
  const int groups = outline_.lines().group_count();
  PixelRegion screen{0, groups, pool_.allocate(groups)};
  std::fill_n(screen.groups, groups, kNoPixels);
  for (int row = 0; row < rows.end - rows.first; ++row) {
    RowGroup& group = screen.groups[row / kGroupRows];
    group.first[static_cast<std::size_t>(row % kGroupRows)] = 0;
    group.end[static_cast<std::size_t>(row % kGroupRows)] = static_cast<std::int16_t>(width);
  }
  leaves_.push_back(screen);
  nodes_.push_back({nullptr, {kLeafBit, kCovered}, kRootSlot});
}

void ScreenTree::add_surface(std::uint32_t surface) {
  draw_ = table_.surfaces[surface].first_draw;
  const std::size_t begin = spans_.size();
  outline_.begin(surface);
  while (outline_.next_piece()) add_piece();
  merge_spans(begin);
}

void ScreenTree::add_piece() {
  const PixelRegion piece = outline_.pixels();
  scratch_.clear();
  std::copy_n(piece.groups, piece.size(), scratch_.extend(static_cast<std::size_t>(piece.size())));
  stack_.clear();
  stack_.push_back({kRootSlot, piece.begin, piece.end, 0});
  while (!stack_.empty()) {
    const Part part = stack_.back();
    stack_.pop_back();
    // Parts that were pushed later are done, so their memory is free.
    scratch_.shrink(part.offset + static_cast<std::size_t>(part.end - part.begin));
    push_down(part);
  }
}

void ScreenTree::push_down(Part part) {
  while (part.begin < part.end) {
    if (!open_pixels_.is_made() && is_full()) replace_by_open_pixels();
    if (open_pixels_.is_made()) return clip_spans(region(part));
    const std::uint32_t child = child_at(part.slot);
    if (child == kCovered) return;
    if ((child & kLeafBit) != 0) return claim_leaf(part.slot, region(part));
    const Node& node = nodes_[child];
    ++counts_.comparisons;
    const LineSides sides = find_sides(region(part), node.line);
    if (sides.left && sides.right)
      split(node, child, part);
    else
      part.slot = 2 * child + (sides.right ? 1 : 0);
  }
}

void ScreenTree::split(const Node& node, std::uint32_t number, Part& io_part) {
  ++counts_.splits;
  const auto keep = [&](std::uint32_t slot, const PixelRegion& pixels) {
    return Part{slot, pixels.begin, pixels.end, static_cast<std::size_t>(pixels.groups - scratch_.data())};
  };
  // A covered side is only cut away.
  if (node.children[0] == kCovered) {
    const PixelRegion whole = region(io_part);
    io_part = keep(2 * number + 1, cut_right(whole, node.line, whole.groups));
    return;
  }
  if (node.children[1] == kCovered) {
    const PixelRegion whole = region(io_part);
    io_part = keep(2 * number, cut_left(whole, node.line, whole.groups));
    return;
  }
  RowGroup* const right_groups = scratch_.extend(static_cast<std::size_t>(io_part.end - io_part.begin));
  const PixelRegion whole = region(io_part);  // extend() may have moved it
  const Part right = keep(2 * number + 1, cut_right(whole, node.line, right_groups));
  stack_.push_back(keep(2 * number, cut_left(whole, node.line, whole.groups)));
  io_part = right;
}

void ScreenTree::claim_leaf(std::uint32_t slot, const PixelRegion& part) {
  for_each_row(part, [&](int row, int first, int end) { add_span(row, first, end); });
  PixelRegion leaf = leaves_[child_at(slot) & ~kLeafBit];
  for (const Bound& bound : outline_.bounds()) {
    ++counts_.comparisons;
    if (bound.edge != kNoEdge) outline_.lines().edge_line(bound.edge, {leaf.begin, leaf.end});
    const LineSides sides = find_sides(leaf, bound.line);
    if (bound.is_inside_right ? sides.left : sides.right) slot = divide_leaf(slot, bound, leaf);
  }
  cover(slot);
}

// Puts a node in place of the leaf. Returns the slot of the side where the surface is, and leaves the pixels
// of that side in `io_leaf`.
std::uint32_t ScreenTree::divide_leaf(std::uint32_t slot, const Bound& bound, PixelRegion& io_leaf) {
  RowGroup* const groups = pool_.allocate(io_leaf.size());
  const PixelRegion outside =
      bound.is_inside_right ? cut_left(io_leaf, bound.line, groups) : cut_right(io_leaf, bound.line, groups);
  pool_.give_back(outside.groups + outside.size());
  io_leaf = bound.is_inside_right ? cut_right(io_leaf, bound.line, io_leaf.groups)
                                  : cut_left(io_leaf, bound.line, io_leaf.groups);
  const auto leaf = static_cast<std::uint32_t>(leaves_.size()) | kLeafBit;
  leaves_.push_back(outside);
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  child_at(slot) = number;
  const std::uint32_t inside_side = bound.is_inside_right ? 1 : 0;
  Node node{bound.line, {leaf, leaf}, slot};
  node.children[inside_side] = kCovered;  // until it is divided further
  nodes_.push_back(node);
  return 2 * number + inside_side;
}

// Nodes with two covered sides are covered, too.
void ScreenTree::cover(std::uint32_t slot) {
  child_at(slot) = kCovered;
  while (slot != kRootSlot) {
    const Node& node = nodes_[slot / 2];
    if (node.children[0] != kCovered || node.children[1] != kCovered) return;
    slot = node.parent_slot;
    child_at(slot) = kCovered;
  }
}

bool ScreenTree::is_full() const {
  return nodes_.size() > max_nodes_ || pool_.used() > kMaxGroupsPerNode * max_nodes_ ||
         counts_.comparisons > kMaxComparisonsPerNode * max_nodes_;
}

template <typename Visit>
void ScreenTree::for_each_open_leaf(Visit visit) const {
  for (const Node& node : nodes_)
    for (const std::uint32_t child : node.children)
      if (child != kCovered && (child & kLeafBit) != 0) visit(leaves_[child & ~kLeafBit]);
}

void ScreenTree::replace_by_open_pixels() {
  open_pixels_ = OpenPixels(rows_.end - rows_.first, width_, arena_);
  for_each_open_leaf([&](const PixelRegion& leaf) {
    for_each_row(leaf, [&](int row, int first, int end) { open_pixels_.open(row, first, end); });
  });
}

void ScreenTree::clip_spans(const PixelRegion& part) {
  for_each_row(part, [&](int row, int first, int end) {
    ++counts_.spans_sorted;
    open_pixels_.close(row, first, end, [&](int begin, int open_end) { add_span(row, begin, open_end); });
  });
}

void ScreenTree::add_span(int row, int first, int end) {
  spans_.push_back({draw_,
                    {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(rows_.first + row),
                     static_cast<std::uint16_t>(end - first)}});
}

// Spans are drawn with steps along the texture that begin at their first pixel. So the picture depends on
// where a span begins, and it must not depend on where the tree has cut it.
void ScreenTree::merge_spans(std::size_t begin) {
  const std::span<render::DrawSpan> unsorted = spans_.view().subspan(begin);
  if (unsorted.empty()) return;
  const auto place = [](const render::DrawSpan& span) {
    return std::uint32_t{span.span.y} << 16 | std::uint32_t{span.span.x};
  };
  if (!std::ranges::is_sorted(unsorted, {}, place)) std::ranges::sort(unsorted, {}, place);
  std::size_t last = begin;
  for (std::size_t i = begin + 1; i < spans_.size(); ++i) {
    render::Span& before = spans_[last].span;
    const render::Span& here = spans_[i].span;
    if (before.y == here.y && before.x + before.count == here.x)
      before.count = static_cast<std::uint16_t>(before.count + here.count);
    else
      spans_[++last] = spans_[i];
  }
  spans_.shrink(last + 1);
}

std::span<const render::DrawSpan> ScreenTree::finish() {
  draw_ = 0;
  const std::size_t begin = spans_.size();
  if (open_pixels_.is_made()) {
    for (int row = 0; row < rows_.end - rows_.first; ++row)
      open_pixels_.close(row, 0, width_, [&](int first, int end) { add_span(row, first, end); });
  } else {
    for_each_open_leaf([&](const PixelRegion& leaf) {
      for_each_row(leaf, [&](int row, int first, int end) { add_span(row, first, end); });
    });
  }
  merge_spans(begin);
  return spans_.view();
}

Counts ScreenTree::counts() const {
  Counts counts = counts_;
  counts.bytes = nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(PixelRegion) +
                 pool_.used() * sizeof(RowGroup) + outline_.lines().bytes() + open_pixels_.bytes();
  return counts;
}

}  // namespace temblor::lab
