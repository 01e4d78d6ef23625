#include "world/visibility.h"

#include <algorithm>

#include "world/trace.h"

namespace temblor::world {

LeafIndex find_leaf(const Level& level, const math::Vec3& point) {
  Child child = level.world().head;
  while (!child.is_leaf()) {
    const Node& node = level.node(child.node());
    const bool front = distance_to(level.planes[node.plane], math::Vec3d(point)) >= 0;
    child = node.children[front ? 0 : 1];
  }
  return child.leaf();
}

namespace {

// The liquid of the brush entities at a point. The space of such a model is solid or liquid, as its texture
// says.
Contents find_liquid(const Level& level, const math::Vec3& point, std::span<const PlacedLiquid> placed) {
  for (std::size_t i = 0; i < level.brush_entities.size(); ++i) {
    const BrushEntity& entity = level.brush_entities[i];
    if (entity.liquid == Contents::kEmpty) continue;
    const auto model = base::to_index<ModelIndex>(i);
    const auto moved = std::ranges::find(placed, model, &PlacedLiquid::model);
    const math::Vec3 place = point - (moved == placed.end() ? entity.origin : moved->origin);
    if (hull_contents(level, model, Hull::kPoint, place) != Contents::kEmpty) return entity.liquid;
  }
  return Contents::kEmpty;
}

}  // namespace

Contents point_contents(const Level& level, const math::Vec3& point, std::span<const PlacedLiquid> placed) {
  const Contents contents = level.leaf(find_leaf(level, point)).contents;
  return contents == Contents::kEmpty ? find_liquid(level, point, placed) : contents;
}

namespace {

// Bits past the last leaf stay 0, so that rows can be compared and counted.
void fill_row(std::uint32_t leaf_count, std::vector<std::uint8_t>& out_row) {
  std::fill(out_row.begin(), out_row.end(), std::uint8_t{0xff});
  if (leaf_count % 8 != 0) out_row.back() = static_cast<std::uint8_t>((1u << (leaf_count % 8)) - 1);
}

// A nonzero byte is literal; a zero byte is followed by the number of zero bytes. Damaged data may end early
// or run past the row; both loops stop at the ends.
void expand_row(std::span<const std::uint8_t> coded, std::vector<std::uint8_t>& out_row) {
  std::fill(out_row.begin(), out_row.end(), std::uint8_t{0});
  std::size_t to = 0;
  for (std::size_t from = 0; from < coded.size() && to < out_row.size(); ++from) {
    if (coded[from] != 0) {
      out_row[to++] = coded[from];
    } else if (++from < coded.size()) {
      to += coded[from];
    }
  }
}

}  // namespace

void decompress_pvs(const Level& level, LeafIndex from, std::vector<std::uint8_t>& out_row) {
  const std::uint32_t leaf_count = level.visible_leaf_count;
  out_row.resize((std::size_t{leaf_count} + 7) / 8);
  if (out_row.empty()) return;
  const std::int32_t offset = level.leaf(from).visibility_offset;
  if (from == LeafIndex{0} || offset < 0 || level.visibility.empty()) {
    fill_row(leaf_count, out_row);
    return;
  }
  const std::span<const std::uint8_t> coded(level.visibility);
  expand_row(coded.subspan(std::min(static_cast<std::size_t>(offset), coded.size())), out_row);
  if (leaf_count % 8 != 0) out_row.back() &= static_cast<std::uint8_t>((1u << (leaf_count % 8)) - 1);
}

}  // namespace temblor::world
