// Hot loop.
#include "lab/beam_tree/pixel_region.h"

namespace temblor::lab {

namespace {

// Eight rows in one vector, for all processors that g++ and clang know.
using Lanes = std::int16_t __attribute__((vector_size(sizeof(GroupPixels))));

Lanes load_lanes(const GroupPixels& pixels) {
  return std::bit_cast<Lanes>(pixels);
}

bool any_lane(Lanes lanes) {
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(lanes);
  return (halves[0] | halves[1]) != 0;
}

// Lanes of `yes` where `mask` is set, and of `no` elsewhere.
Lanes select(Lanes mask, Lanes yes, Lanes no) {
  return (mask & yes) | (~mask & no);
}

void store_span(Lanes first, Lanes end, RowGroup& out_group) {
  const Lanes has_pixels = first < end;
  out_group.first = std::bit_cast<GroupPixels>(select(has_pixels, first, Lanes{} + kNoFirst));
  out_group.end = std::bit_cast<GroupPixels>(has_pixels & end);
}

}  // namespace

LineSides find_sides(const PixelRegion& region, Line line) {
  line += region.begin;
  Lanes left{}, right{};
  for (int i = 0; i < region.size(); ++i) {
    const Lanes border = load_lanes(line[i]);
    left |= load_lanes(region.groups[i].first) < border;
    right |= load_lanes(region.groups[i].end) > border;
  }
  return {any_lane(left), any_lane(right)};
}

PixelRegion cut_left(const PixelRegion& region, Line line, RowGroup* out_groups) {
  line += region.begin;
  for (int i = 0; i < region.size(); ++i) {
    const Lanes end = load_lanes(region.groups[i].end), border = load_lanes(line[i]);
    store_span(load_lanes(region.groups[i].first), select(end < border, end, border), out_groups[i]);
  }
  PixelRegion part{region.begin, region.end, out_groups};
  part.trim();
  return part;
}

PixelRegion cut_right(const PixelRegion& region, Line line, RowGroup* out_groups) {
  line += region.begin;
  for (int i = 0; i < region.size(); ++i) {
    const Lanes first = load_lanes(region.groups[i].first), border = load_lanes(line[i]);
    store_span(select(first > border, first, border), load_lanes(region.groups[i].end), out_groups[i]);
  }
  PixelRegion part{region.begin, region.end, out_groups};
  part.trim();
  return part;
}

}  // namespace temblor::lab
