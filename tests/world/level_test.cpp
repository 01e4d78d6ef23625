// Tests the data that make_level() copies from the file, and the source of the light.
#include "world/level.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "formats/levels/lit.h"
#include "support/game_data.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void expect_same_structure(const TestLevel& test) {
  const formats::Bsp& bsp = test.bsp;
  const Level& level = *test.level;
  ASSERT_EQ(level.nodes.size(), bsp.nodes.size());
  ASSERT_EQ(level.leaves.size(), bsp.leaves.size());
  ASSERT_EQ(level.models.size(), bsp.models.size());
  ASSERT_EQ(level.planes.size(), bsp.planes.size());
  EXPECT_EQ(level.visible_leaf_count, static_cast<std::uint32_t>(bsp.models[0].visible_leaves));
  for (std::size_t i = 0; i < bsp.nodes.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::int32_t child = bsp.nodes[i].children[side];
      const Child converted = level.nodes[i].children[side];
      ASSERT_EQ(converted.is_leaf(), child < 0);
      if (child < 0) {
        EXPECT_EQ(base::to_size(converted.leaf()), static_cast<std::size_t>(-(child + 1)));
      } else {
        EXPECT_EQ(base::to_size(converted.node()), static_cast<std::size_t>(child));
      }
    }
  }
  for (const Plane& plane : level.planes) {
    math::Vec3 unit(0.0f);
    if (plane.axis < 3) unit[plane.axis] = 1;
    EXPECT_EQ(plane.axis < 3, plane.normal == unit);
  }
  for (std::size_t i = 0; i < bsp.models.size(); ++i) {
    EXPECT_EQ(level.models[i].bounds.mins, bsp.models[i].mins - math::Vec3(1, 1, 1));
    EXPECT_EQ(level.models[i].bounds.maxs, bsp.models[i].maxs + math::Vec3(1, 1, 1));
  }
}

TEST(MakeLevel, KeepsTheStructureOfStockLevels) {
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) {
    SCOPED_TRACE(test.name);
    expect_same_structure(test);
    EXPECT_EQ(test.level->entities.at(0).classname(), "worldspawn");
  }
}

TEST(MakeLevel, KeepsTheStructureOfTheSmallLevel) {
  expect_same_structure(small_test_level());
}

TEST(MakeLevel, SurfedgesStartWhereTheFileSays) {
  const TestLevel test = small_test_level({.tiny = true});
  bool forward = false, backward = false;
  for (std::size_t i = 0; i < test.bsp.surfedges.size(); ++i) {
    const std::int32_t edge = test.bsp.surfedges[i];
    (edge < 0 ? backward : forward) = true;
    const std::uint32_t expected = edge < 0 ? test.bsp.edges[static_cast<std::size_t>(-edge)].vertices[1]
                                            : test.bsp.edges[static_cast<std::size_t>(edge)].vertices[0];
    EXPECT_EQ(test.level->surfedge_start(i), expected);
  }
  EXPECT_TRUE(forward && backward);
}

TEST(MakeLevel, TakesColoredLightFromTheLitFileThenFromBspx) {
  const formats::Bsp gray = artgen::make_small_level({.tiny = true});
  formats::Lit lit;
  for (std::size_t i = 0; i < gray.lighting.size() * 3; ++i)
    lit.samples.push_back(static_cast<std::uint8_t>(i % 251));
  EXPECT_TRUE((*make_level(gray, "gray"))->light_rgb.empty());
  EXPECT_EQ((*make_level(gray, "lit", &lit))->light_rgb, lit.samples);

  const formats::Bsp colored = artgen::make_small_level({.colored_light = true, .tiny = true});
  const auto from_lump = base::as_u8(colored.find_bspx("RGBLIGHTING")->data);
  const auto level = make_level(colored, "bspx");
  ASSERT_TRUE(level.ok());
  EXPECT_TRUE(
      std::equal(from_lump.begin(), from_lump.end(), (*level)->light_rgb.begin(), (*level)->light_rgb.end()));
  EXPECT_EQ((*make_level(colored, "both", &lit))->light_rgb, lit.samples);
}

TEST(MakeLevel, ColoredLightOfTheWrongSizeIsAnErrorOrIgnored) {
  formats::Bsp bsp = artgen::make_small_level({.colored_light = true, .tiny = true});
  formats::Lit lit;
  lit.samples.resize(bsp.lighting.size() * 3 + 3);
  EXPECT_FALSE(make_level(bsp, "lit too long", &lit).ok());
  bsp.bspx[0].data.pop_back();
  const auto level = make_level(bsp, "lump too short");
  ASSERT_TRUE(level.ok()) << level.error().message();
  EXPECT_TRUE((*level)->light_rgb.empty());
  EXPECT_THAT((*level)->notes, ElementsAre(HasSubstr("lump RGBLIGHTING: ")));
}

TEST(MakeLevel, FaultsOfEntityTextAreNoted) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  EXPECT_THAT(make_level(bsp, "whole").value()->notes, IsEmpty());
  bsp.entities = "{ \"classname\" \"worldspawn\"";
  const auto level = make_level(bsp, "open brace");
  ASSERT_TRUE(level.ok()) << level.error().message();
  ASSERT_EQ((*level)->entities.size(), 1u);
  EXPECT_EQ((*level)->entities[0].classname(), "worldspawn");
  EXPECT_THAT((*level)->notes,
              ElementsAre("lump entities: line 1: this entity is never closed; it is passed over"));
}

}  // namespace
}  // namespace temblor::world
