// Convex sets of pixels for the beam tree, and the lines that split them. A region has one span on each row;
// a line has one pixel on each row, the first at its right:
//
//   row 0     ..|#####|####.....      #: the region, first to end - 1
//   row 1     ...|#####|##......      |: its first and end, and the line between them, which splits it
//   row 2     ....|#####|.......      into two regions
//
// All comparisons are of whole pixels, so a split neither loses nor repeats one, and an empty part is always
// found. Polygons with corners in floating point would leave slivers without pixels, or cracks.
//
// Rows come in groups of eight, because a processor's vector holds eight of these numbers.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace temblor::lab {

constexpr int kGroupRows = 8;
using GroupPixels = std::array<std::int16_t, kGroupRows>;

// The spans of eight rows. Rows without pixels have first kNoFirst and end 0, which lie on neither side of
// any line.
constexpr std::int16_t kNoFirst = 32767;
struct RowGroup {
  GroupPixels first, end;
};
constexpr RowGroup kNoPixels = [] {
  RowGroup group{};
  group.first.fill(kNoFirst);
  return group;
}();

// Not only pixels, but also rows can be split by a line: a line whose pixels are kNoFirst has everything at
// its left, and a line whose pixels are 0 has everything at its right.
using Line = const GroupPixels*;  // by row group of the tree

// The groups `begin` to `end` - 1 of a tree; groups[0] is group number `begin`.
struct PixelRegion {
  int begin = 0, end = 0;
  RowGroup* groups = nullptr;

  int size() const { return end - begin; }
  bool is_empty() const { return begin >= end; }
  // Removes groups without pixels from the beginning and the end.
  void trim() {
    const auto has_pixels = [](const RowGroup& group) {
      using Halves = std::array<std::uint64_t, 2>;
      const auto halves = std::bit_cast<Halves>(group.end);
      return (halves[0] | halves[1]) != 0;
    };
    while (begin < end && !has_pixels(groups[0])) ++begin, ++groups;
    while (begin < end && !has_pixels(groups[end - begin - 1])) --end;
  }
};

// The sides of a line on which a region has pixels.
struct LineSides {
  bool left, right;
};
LineSides find_sides(const PixelRegion& region, Line line);

// Copies the pixels of `region` at one side of `line` to `out_groups`, which may be its own groups. Returns
// the trimmed part.
PixelRegion cut_left(const PixelRegion& region, Line line, RowGroup* out_groups);
PixelRegion cut_right(const PixelRegion& region, Line line, RowGroup* out_groups);

// Calls `visit(row, first, end)` for each row with pixels. Rows count from the tree's first one.
template <typename Visit>
void for_each_row(const PixelRegion& region, Visit visit) {
  for (int i = 0; i < region.size(); ++i) {
    for (std::size_t j = 0; j < kGroupRows; ++j) {
      const RowGroup& group = region.groups[i];
      if (group.end[j] != 0)
        visit((region.begin + i) * kGroupRows + static_cast<int>(j), int{group.first[j]}, int{group.end[j]});
    }
  }
}

}  // namespace temblor::lab
