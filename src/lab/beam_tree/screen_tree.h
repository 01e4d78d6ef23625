// The tree of one frame or band for beam_tree.h, and the spans of the parts that are visible.
#pragma once

#include <cstdint>
#include <span>

#include "lab/beam_tree/surface_outline.h"
#include "lab/technique.h"
#include "render/edges/scan_band.h"

namespace temblor::lab {

// One bit for each pixel that no surface covers.
class OpenPixels {
 public:
  OpenPixels() = default;
  OpenPixels(int rows, int width, base::Arena& arena);

  void open(int row, int first, int end);
  // Closes these pixels, and calls `visit(first, end)` for each run of them that was open.
  template <typename Visit>
  void close(int row, int first, int end, Visit visit);

  bool is_made() const { return !words_.empty(); }
  std::size_t bytes() const { return words_.size_bytes(); }

 private:
  // The first pixel from `first` on that is open or not, or `end`.
  int find(std::span<const std::uint64_t> row, bool is_open, int first, int end) const;

  std::size_t words_per_row_ = 0;
  std::span<std::uint64_t> words_;
};

// Memory for regions: blocks that never move. The last region can give back groups that it does not need.
class RegionPool {
 public:
  explicit RegionPool(base::Arena& arena) : arena_(&arena) {}

  RowGroup* allocate(int groups);
  // `end` is behind the last group in use of the last region.
  void give_back(const RowGroup* end);
  std::size_t used() const { return used_; }

 private:
  static constexpr std::size_t kBlockGroups = 1 << 14;  // 512 KiB, and more than a region has
  base::Arena* arena_;
  std::span<RowGroup> block_;
  std::size_t next_ = 0, used_ = 0;
};

class ScreenTree {
 public:
  // Rows of surfaces beyond `rows` are ignored. See beam_tree.h for the limit of nodes.
  ScreenTree(const render::EdgeTable& table, const SurfaceEdges& edges, render::RowRange rows, int width,
             std::size_t max_nodes, base::Arena& arena);

  // Surfaces must come from front to back.
  void add_surface(std::uint32_t surface);
  // Adds the background where nothing else is. Returns the spans of all surfaces; each surface's are sorted
  // by row, then from left to right, and those that touch are one.
  std::span<const render::DrawSpan> finish();
  Counts counts() const;

 private:
  struct Node {
    Line line;
    std::uint32_t children[2];  // at the left and right: a node, a leaf, or kCovered
    std::uint32_t parent_slot;
  };
  // A part of a surface that still has to be pushed down. Its pixels are in scratch_.
  struct Part {
    std::uint32_t slot;
    int begin, end;
    std::size_t offset;
  };

  std::uint32_t& child_at(std::uint32_t slot) { return nodes_[slot / 2].children[slot % 2]; }
  PixelRegion region(const Part& part) { return {part.begin, part.end, scratch_.data() + part.offset}; }
  void add_piece();
  void push_down(Part part);
  // Splits `io_part` by a node's line: pushes one side on the stack and goes on with the other.
  void split(const Node& node, std::uint32_t number, Part& io_part);
  // Draws a part in an open leaf, and divides the leaf.
  void claim_leaf(std::uint32_t slot, const PixelRegion& part);
  std::uint32_t divide_leaf(std::uint32_t slot, const Bound& bound, PixelRegion& io_leaf);
  void cover(std::uint32_t slot);
  bool is_full() const;
  void replace_by_open_pixels();
  void clip_spans(const PixelRegion& part);
  void add_span(int row, int first, int end);
  void merge_spans(std::size_t begin);
  template <typename Visit>
  void for_each_open_leaf(Visit visit) const;

  const render::EdgeTable& table_;
  render::RowRange rows_;
  int width_;
  std::size_t max_nodes_;
  base::Arena& arena_;
  SurfaceOutline outline_;
  std::uint32_t draw_ = 0;  // of the surface that is being added
  base::ArenaVector<Node> nodes_;
  base::ArenaVector<PixelRegion> leaves_;
  RegionPool pool_;
  base::ArenaVector<Part> stack_;
  base::ArenaVector<RowGroup> scratch_;
  OpenPixels open_pixels_;
  base::ArenaVector<render::DrawSpan> spans_;
  Counts counts_;
};

}  // namespace temblor::lab
