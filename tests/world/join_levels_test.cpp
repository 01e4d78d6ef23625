// Compares a joined level with the levels that it was made from, by the same queries.
#include "world/join_levels.h"

#include <gtest/gtest.h>

#include "formats/levels/scaled_light.h"
#include "support/random.h"
#include "world/test_levels.h"
#include "world/trace.h"
#include "world/visibility.h"

namespace temblor::world {
namespace {

// Two levels that differ in every list. The second one has colored light on request.
struct Joined {
  TestLevel base, other;
  JoinedLevel joined;
  explicit Joined(bool base_colored, bool other_colored)
      : base(small_test_level({.colored_light = base_colored})),
        other(small_test_level({.colored_light = other_colored})) {
    const std::shared_ptr<const Level> others[] = {other.level, base.level, other.level};
    joined = join_levels(base.level, others);
  }
};

std::vector<math::Vec3> face_corners(const Level& level, const Face& face) {
  std::vector<math::Vec3> corners;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i)
    corners.push_back(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
  return corners;
}

std::vector<int> sum_face_light(const Level& level, const Face& face) {
  std::vector<int> light;
  if (face.light == kNoLight) return light;
  const auto samples = static_cast<std::size_t>(face.light_width() * face.light_height()) * face.style_count;
  for (std::size_t i = face.light; i < face.light + samples; ++i) {
    light.push_back(level.light[i]);
    if (!level.light_rgb.empty())
      for (std::size_t channel = 0; channel < 3; ++channel) light.push_back(level.light_rgb[i * 3 + channel]);
  }
  return light;
}

void expect_same_face(const Level& from, const Face& a, const Level& to, const Face& b) {
  EXPECT_EQ(face_corners(from, a), face_corners(to, b));
  EXPECT_EQ(from.planes[a.plane].normal, to.planes[b.plane].normal);
  EXPECT_EQ(from.planes[a.plane].distance, to.planes[b.plane].distance);
  EXPECT_EQ(from.texture_axes[a.axes].s_axis, to.texture_axes[b.axes].s_axis);
  EXPECT_EQ(from.texture_axes[a.axes].t_offset, to.texture_axes[b.axes].t_offset);
  EXPECT_EQ(from.texture(a.texture).name, to.texture(b.texture).name);
  EXPECT_EQ(from.texture(a.texture).mips, to.texture(b.texture).mips);
  ASSERT_EQ(from.texture(a.texture).frames.size(), to.texture(b.texture).frames.size());
  for (std::size_t i = 0; i < from.texture(a.texture).frames.size(); ++i)
    EXPECT_EQ(from.texture(from.texture(a.texture).frames[i]).name,
              to.texture(to.texture(b.texture).frames[i]).name);
}

void expect_same_model(const Level& from, ModelIndex a, const Level& to, ModelIndex b) {
  const Model& model_a = from.models[base::to_size(a)];
  const Model& model_b = to.models[base::to_size(b)];
  ASSERT_EQ(model_a.face_count, model_b.face_count);
  for (std::uint32_t i = 0; i < model_a.face_count; ++i)
    expect_same_face(from, from.faces[model_a.first_face + i], to, to.faces[model_b.first_face + i]);

  test::Random random(7);
  for (int i = 0; i < 300; ++i) {
    const math::Vec3 start = random.in_cube(300), end = random.in_cube(300);
    for (const Hull hull : {Hull::kPoint, Hull::kPlayer}) {
      const Trace in_a = trace_line(from, a, hull, start, end), in_b = trace_line(to, b, hull, start, end);
      ASSERT_EQ(in_a.fraction, in_b.fraction);
      ASSERT_EQ(in_a.plane_normal, in_b.plane_normal);
      ASSERT_EQ(hull_contents(from, a, hull, start), hull_contents(to, b, hull, start));
    }
  }
}

TEST(JoinLevels, EveryModelIsAsItWas) {
  for (const auto& [base_colored, other_colored] : {std::pair(false, false), std::pair(true, true)}) {
    const Joined levels(base_colored, other_colored);
    const Level& joined = *levels.joined.level;
    const Level* sources[] = {levels.other.level.get(), levels.base.level.get(), levels.other.level.get()};
    for (std::uint32_t i = 0; i < levels.base.level->models.size(); ++i)
      expect_same_model(*levels.base.level, ModelIndex{i}, joined, ModelIndex{i});
    ASSERT_EQ(levels.joined.models.size(), std::size(sources));
    for (std::size_t other = 0; other < std::size(sources); ++other)
      for (std::uint32_t i = 0; i < sources[other]->models.size(); ++i)
        expect_same_model(*sources[other], ModelIndex{i}, joined,
                          base::to_index<ModelIndex>(base::to_size(levels.joined.models[other]) + i));
  }
}

TEST(JoinLevels, LightIsKeptAndGrayLightIsColoredGrayWhereOthersHaveColor) {
  for (const bool base_colored : {false, true}) {
    const Joined levels(base_colored, !base_colored);
    const Level& joined = *levels.joined.level;
    ASSERT_EQ(joined.light_rgb.size(), joined.light.size() * 3);
    const Level& gray = base_colored ? *levels.other.level : *levels.base.level;
    const Level& colored = base_colored ? *levels.base.level : *levels.other.level;
    const std::size_t gray_faces =
        base_colored ? joined.models[base::to_size(levels.joined.models[0])].first_face : 0;
    const std::size_t colored_faces =
        base_colored ? 0 : joined.models[base::to_size(levels.joined.models[0])].first_face;
    for (std::size_t i = 0; i < colored.faces.size(); ++i)
      EXPECT_EQ(sum_face_light(colored, colored.faces[i]),
                sum_face_light(joined, joined.faces[colored_faces + i]));
    for (std::size_t i = 0; i < gray.faces.size(); ++i) {
      const std::vector<int> as_gray = sum_face_light(gray, gray.faces[i]);
      const std::vector<int> as_rgb = sum_face_light(joined, joined.faces[gray_faces + i]);
      ASSERT_EQ(as_rgb.size(), as_gray.size() * 4);
      for (std::size_t k = 0; k < as_rgb.size(); ++k) EXPECT_EQ(as_rgb[k], as_gray[k / 4]);
    }
  }
}

// Joins a level twice whose faces have a sample for every 32 texels.
TEST(JoinLevels, LightMapsOfOtherResolutionsAreKept) {
  formats::Bsp bsp = artgen::make_small_level();
  std::vector<formats::ScaledLightMap> maps;
  for (const formats::BspFace& face : bsp.faces) maps.push_back({5, face.light_offset, face.styles});
  formats::set_scaled_light(maps, bsp);
  const std::shared_ptr<const Level> level = test_level("coarse", bsp).level;
  ASSERT_FALSE(level->light_map_grids.empty());
  const std::shared_ptr<const Level> joined = join_levels(level, {{level}}).level;
  ASSERT_EQ(joined->light_map_grids.size(), 2 * level->light_map_grids.size());
  for (std::size_t i = 0; i < joined->faces.size(); ++i) {
    const Face &face = joined->faces[i], &own = level->faces[i % level->faces.size()];
    EXPECT_EQ(joined->light_size(face), level->light_size(own)) << i;
    if (own.light_map_grid == kStockGrid) continue;
    EXPECT_EQ(joined->light_map_grids[face.light_map_grid].first,
              level->light_map_grids[own.light_map_grid].first)
        << i;
  }
}

TEST(JoinLevels, ThePlayersLevelStaysTheBase) {
  const Joined levels(true, false);
  const Level& joined = *levels.joined.level;
  const Level& base = *levels.base.level;
  EXPECT_NE(joined.identity, base.identity);
  EXPECT_EQ(joined.entities, base.entities);
  EXPECT_EQ(joined.visible_leaf_count, base.visible_leaf_count);
  test::Random random(3);
  std::vector<std::uint8_t> row_of_base, row_of_joined;
  for (int i = 0; i < 300; ++i) {
    const math::Vec3 point = random.in_cube(300);
    ASSERT_EQ(find_leaf(joined, point), find_leaf(base, point));
    decompress_pvs(base, find_leaf(base, point), row_of_base);
    decompress_pvs(joined, find_leaf(base, point), row_of_joined);
    ASSERT_EQ(row_of_base, row_of_joined);
  }
}

TEST(JoinLevels, WithoutOthersTheLevelIsTheSame) {
  const TestLevel level = small_test_level();
  EXPECT_EQ(join_levels(level.level, {}).level, level.level);
}

}  // namespace
}  // namespace temblor::world
