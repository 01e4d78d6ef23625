#include "app/compile/report/level_figures.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "world/visibility.h"

namespace temblor::app {
namespace {

// The stock limit of a light map's side is 18 samples; larger ones come from DECOUPLED_LM and LMSHIFT.
constexpr std::array<std::int32_t, 8> kLargestSides = {0, 4, 8, 12, 18, 64, 256, 1 << 30};

bool has_light_map(const world::Face& face) {
  return face.kind != world::FaceKind::kSky && face.light != world::kNoLight && face.style_count > 0;
}

std::size_t count_light_samples(const world::Level& level, const world::Face& face) {
  const auto [width, height] = level.light_size(face);
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * face.style_count;
}

double measure_face_area(const world::Level& level, const world::Face& face) {
  const auto corner = [&](std::uint32_t i) {
    return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
  };
  math::Vec3d twice_area(0.0);
  for (std::uint32_t i = 2; i < face.surfedge_count; ++i)
    twice_area += glm::cross(corner(i - 1) - corner(0), corner(i) - corner(0));
  return glm::length(twice_area) / 2;
}

std::size_t count_visible_faces(const world::Level& level, world::LeafIndex from) {
  std::vector<std::uint8_t> row;
  world::decompress_pvs(level, from, row);
  std::vector<bool> is_visible(level.faces.size());
  for (std::uint32_t i = 1; i <= level.visible_leaf_count; ++i) {
    if (!world::is_in_pvs(row, world::LeafIndex{i})) continue;
    const world::Leaf& leaf = level.leaves[i];
    for (std::uint32_t k = 0; k < leaf.marked_face_count; ++k)
      is_visible[base::to_size(level.marked_faces[leaf.first_marked_face + k])] = true;
  }
  return static_cast<std::size_t>(std::ranges::count(is_visible, true));
}

}  // namespace

LightFigures measure_light(const world::Level& level) {
  LightFigures figures;
  double sum = 0;
  for (const world::Face& face : level.faces) {
    if (!has_light_map(face)) continue;
    const std::size_t count = count_light_samples(level, face);
    for (const std::uint8_t sample : std::span(level.light).subspan(face.light, count)) {
      ++figures.histogram[sample / LightFigures::kLevelsPerBin];
      figures.black += sample == 0 ? 1 : 0;
      figures.full += sample == 255 ? 1 : 0;
      sum += sample;
    }
    figures.samples += count;
  }
  if (figures.samples > 0) figures.mean = sum / static_cast<double>(figures.samples);
  return figures;
}

std::vector<LightMapGroup> group_light_maps(const world::Level& level) {
  std::vector<LightMapGroup> groups(kLargestSides.size());
  for (std::size_t i = 1; i < groups.size(); ++i) {
    groups[i].min_side = kLargestSides[i - 1] + 1;
    groups[i].max_side = kLargestSides[i];
  }
  for (const world::Face& face : level.faces) {
    const bool is_lit = has_light_map(face);
    const auto [width, height] = level.light_size(face);
    const std::int32_t side = is_lit ? std::max(width, height) : 0;
    LightMapGroup& group = *std::ranges::lower_bound(groups, side, {}, &LightMapGroup::max_side);
    ++group.faces;
    if (is_lit) group.samples += count_light_samples(level, face);
  }
  std::erase_if(groups, [](const LightMapGroup& group) { return group.faces == 0; });
  return groups;
}

// The last texture of a Level is the placeholder for missing ones, which is not in the file.
std::vector<TextureUse> measure_textures(const world::Level& level) {
  std::vector<TextureUse> uses(level.textures.size());
  for (std::size_t i = 0; i < uses.size(); ++i) uses[i].texture = static_cast<world::TextureIndex>(i);
  for (const world::Face& face : level.faces) {
    TextureUse& use = uses[base::to_size(face.texture)];
    ++use.faces;
    use.area += measure_face_area(level, face);
  }
  if (uses.back().faces == 0) uses.pop_back();
  std::ranges::stable_sort(uses, std::ranges::greater{}, &TextureUse::area);
  return uses;
}

std::vector<std::uint32_t> count_visible_leaves(const world::Level& level) {
  if (level.visibility.empty()) return {};
  std::vector<std::uint32_t> counts(level.leaves.size());
  std::vector<std::uint8_t> row;
  for (std::uint32_t i = 1; i <= level.visible_leaf_count; ++i) {
    const world::Leaf& leaf = level.leaves[i];
    if (leaf.contents == world::Contents::kSolid || leaf.contents == world::Contents::kSky) continue;
    world::decompress_pvs(level, world::LeafIndex{i}, row);
    for (const std::uint8_t bits : row) counts[i] += static_cast<std::uint32_t>(std::popcount(bits));
  }
  return counts;
}

std::vector<BusyPlace> find_busy_places(const world::Level& level,
                                        const std::vector<std::uint32_t>& visible_leaves,
                                        std::size_t max_places) {
  constexpr double kMinApart = 256;
  std::vector<std::uint32_t> order(visible_leaves.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::uint32_t i) { return visible_leaves[i]; });
  std::vector<BusyPlace> places;
  for (const std::uint32_t leaf : order) {
    if (places.size() == max_places || visible_leaves[leaf] == 0) break;
    const math::Vec3 center = (level.leaves[leaf].bounds.mins + level.leaves[leaf].bounds.maxs) / 2.0f;
    const bool is_near = std::ranges::any_of(places, [&](const BusyPlace& other) {
      return glm::distance(other.center_world, center) < kMinApart;
    });
    if (!is_near)
      places.push_back({center, visible_leaves[leaf], count_visible_faces(level, world::LeafIndex{leaf})});
  }
  return places;
}

}  // namespace temblor::app
