// The figures of a compiled level that help a mapper: how bright it is, where most is visible, and where
// textures and light maps are used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "math/vec.h"
#include "world/level.h"

namespace temblor::app {

// The brightness of the samples of all light maps and light styles.
struct LightFigures {
  static constexpr int kBins = 32, kLevelsPerBin = 256 / kBins;
  std::array<std::size_t, kBins> histogram{};    // bin i: samples from 8 i to 8 i + 7
  std::size_t samples = 0, black = 0, full = 0;  // `black`: 0; `full`: 255, perhaps cut off
  double mean = 0;                               // 0 to 255
};
LightFigures measure_light(const world::Level& level);

// Faces whose light maps have similar sizes.
struct LightMapGroup {
  std::int32_t min_side = 0, max_side = 0;  // samples along the longer side; 0: faces without a light map
  std::size_t faces = 0, samples = 0;       // of all light styles
};
// Returns the groups that have faces, the smallest light maps first. Together they have all faces.
std::vector<LightMapGroup> group_light_maps(const world::Level& level);

// The faces with one texture.
struct TextureUse {
  world::TextureIndex texture{};
  std::size_t faces = 0;
  double area = 0;  // in square units
};
// Returns all textures that are in the level, the largest area first. Animation frames that no face starts
// with have no faces.
std::vector<TextureUse> measure_textures(const world::Level& level);

// Returns the number of leaves that each leaf sees, itself included; 0 for leaves that have no PVS row of
// their own (solid), and for sky. Empty if the level has no visibility.
std::vector<std::uint32_t> count_visible_leaves(const world::Level& level);

// A leaf that sees much.
struct BusyPlace {
  math::Vec3 center_world{0.0f};  // of the leaf's box
  std::uint32_t leaves = 0;       // visible from it
  std::size_t faces = 0;          // in these leaves
};
// Returns at most `max_places` leaves that see the most leaves, at least 256 units apart. `visible_leaves` is
// the result of count_visible_leaves().
std::vector<BusyPlace> find_busy_places(const world::Level& level,
                                        const std::vector<std::uint32_t>& visible_leaves,
                                        std::size_t max_places);

}  // namespace temblor::app
