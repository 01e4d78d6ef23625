// Method: each light has the PVS row of its leaf, and the sky has the union of the rows of all leaves that
// show sky. A face can be reached only if one of its leaves is in the row. Lights in the same leaf share a
// row.
#include "compiler/light/rays/leaf_sight.h"

#include <algorithm>
#include <map>

#include "world/visibility.h"

namespace temblor::compiler {
namespace {

bool is_liquid(world::Contents contents) {
  return contents == world::Contents::kWater || contents == world::Contents::kSlime ||
         contents == world::Contents::kLava;
}

// Whether the PVS sees anything dry from a leaf of liquid, or there is no liquid.
bool sees_through_liquids(const world::Level& level) {
  bool any_liquid = false;
  std::vector<std::uint8_t> row;
  const std::size_t count =
      std::min<std::size_t>(level.visible_leaf_count + std::size_t{1}, level.leaves.size());
  for (std::size_t from = 1; from < count; ++from) {
    if (!is_liquid(level.leaves[from].contents)) continue;
    any_liquid = true;
    world::decompress_pvs(level, base::to_index<world::LeafIndex>(from), row);
    for (std::size_t to = 1; to < count; ++to)
      if (level.leaves[to].contents == world::Contents::kEmpty &&
          world::is_in_pvs(row, base::to_index<world::LeafIndex>(to)))
        return true;
  }
  return !any_liquid;
}

bool any_in(std::span<const std::uint8_t> row, std::span<const world::LeafIndex> leaves) {
  return std::any_of(leaves.begin(), leaves.end(),
                     [&](world::LeafIndex leaf) { return world::is_in_pvs(row, leaf); });
}

}  // namespace

// Lists the leaves that show each face, then decompresses one row for each leaf that has a light.
LeafSight::LeafSight(const LitLevel& lit, std::span<const LightSource> lights) {
  const world::Level& level = *lit.level;
  known_ = !level.visibility.empty() && sees_through_liquids(level) &&
           std::ranges::none_of(lit.keys.keys, &SurfaceKeys::shadow_hides_leaves);
  if (!known_) return;
  leaves_showing_.resize(level.faces.size());
  Row row;
  for (std::size_t number = 1; number < level.leaves.size(); ++number) {
    const world::Leaf& leaf = level.leaves[number];
    const auto index = base::to_index<world::LeafIndex>(number);
    bool has_sky = leaf.contents == world::Contents::kSky;
    for (std::uint32_t i = 0; i < leaf.marked_face_count; ++i) {
      const std::size_t face = base::to_size(level.marked_faces[std::size_t{leaf.first_marked_face} + i]);
      leaves_showing_[face].push_back(index);
      has_sky = has_sky || level.faces[face].kind == world::FaceKind::kSky;
    }
    if (!has_sky) continue;
    world::decompress_pvs(level, index, row);
    from_sky_.resize(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) from_sky_[i] |= row[i];
  }
  std::map<world::LeafIndex, std::uint32_t> row_of_leaf;
  row_of_light_.reserve(lights.size());
  for (const LightSource& light : lights) {
    const world::LeafIndex leaf = world::find_leaf(level, light.origin_world);
    const auto [found, is_new] = row_of_leaf.try_emplace(leaf, static_cast<std::uint32_t>(rows_.size()));
    if (is_new) world::decompress_pvs(level, leaf, rows_.emplace_back());
    row_of_light_.push_back(found->second);
  }
}

std::vector<world::LeafIndex> LeafSight::find_leaves(std::size_t face, const SamplePoints& places) const {
  if (!known_) return {};
  std::vector<world::LeafIndex> leaves = leaves_showing_[face];
  for (std::size_t i = 0; i < places.leaves.size(); ++i)
    if (!places.is_hidden(i)) leaves.push_back(places.leaves[i]);
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

bool LeafSight::light_may_reach(std::size_t light, std::span<const world::LeafIndex> leaves) const {
  return !known_ || leaves.empty() || any_in(rows_[row_of_light_[light]], leaves);
}

bool LeafSight::sky_may_reach(std::span<const world::LeafIndex> leaves) const {
  return !known_ || leaves.empty() || any_in(from_sky_, leaves);
}

}  // namespace temblor::compiler
