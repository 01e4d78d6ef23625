// Checks the generated level in every variant: that it is valid, has the shape of its layout, and has what
// each option promises.
#include "artgen/small_level.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "support/levels/bsp_faces.h"
#include "support/levels/level_script_contents.h"
#include "support/levels/small_bsp.h"

namespace temblor::artgen {
namespace {

struct NamedOptions {
  std::string name;
  SmallLevelOptions options;
};

std::vector<NamedOptions> list_options() {
  return {{"Plain", {}},
          {"NoPvs", {.pvs = false}},
          {"NoLight", {.light = false}},
          {"FourStyles", {.four_styles = true}},
          {"WideFaces", {.wide_faces = true}},
          {"EdgeUsedThreeTimes", {.edge_used_three_times = true}},
          {"MissingTexture", {.missing_texture = true}},
          {"ColoredLight", {.colored_light = true}},
          {"Tiny", {.tiny = true}},
          {"OtherSeed", {.tiny = true, .seed = 99}},
          {"TinyWithEverything",
           {.four_styles = true,
            .wide_faces = true,
            .edge_used_three_times = true,
            .missing_texture = true,
            .colored_light = true,
            .tiny = true}}};
}

class EverySmallLevel : public testing::TestWithParam<NamedOptions> {};

TEST_P(EverySmallLevel, IsWrittenAndReadInEveryVersion) {
  const formats::Bsp bsp = test::small_bsp(GetParam().options);
  for (const auto version :
       {formats::BspVersion::k29, formats::BspVersion::k2Psb, formats::BspVersion::kBsp2}) {
    const auto bytes = formats::write_bsp(bsp, version);
    ASSERT_TRUE(bytes.ok()) << bytes.error().message();
    const auto read = formats::read_bsp(*bytes);
    ASSERT_TRUE(read.ok()) << read.error().message();
    formats::Bsp expected = bsp;
    expected.version = version;
    EXPECT_TRUE(*read == expected);
  }
}

// The sides of the layout's boxes cut space into cells of uniform contents.
TEST_P(EverySmallLevel, HasTheContentsOfItsLayoutInEveryCell) {
  const formats::Bsp bsp = test::small_bsp(GetParam().options);
  const std::vector<SmallLevelBox> boxes = small_level_boxes(GetParam().options);
  std::array<std::set<float>, 3> cuts;
  for (int axis = 0; axis < 3; ++axis)
    for (const SmallLevelBox& box : boxes)
      for (const float side : {box.bounds.mins[axis], box.bounds.maxs[axis]}) {
        // Includes a cell outside of everything.
        for (const float cut : {side - 4, side, side + 4}) cuts[static_cast<std::size_t>(axis)].insert(cut);
      }
  const auto contents_at = [&](const math::Vec3& point) {
    std::int32_t node = bsp.models[0].head_nodes[0];
    while (node >= 0) {
      const formats::BspNode& bsp_node = bsp.nodes[static_cast<std::size_t>(node)];
      const formats::BspPlane& plane = bsp.planes[bsp_node.plane];
      node = bsp_node.children[glm::dot(plane.normal, point) >= plane.distance ? 0 : 1];
    }
    return bsp.leaves[static_cast<std::size_t>(-(node + 1))].contents;
  };
  std::map<std::int32_t, int> seen;
  for (auto x = cuts[0].begin(); std::next(x) != cuts[0].end(); ++x) {
    for (auto y = cuts[1].begin(); std::next(y) != cuts[1].end(); ++y) {
      for (auto z = cuts[2].begin(); std::next(z) != cuts[2].end(); ++z) {
        const math::Vec3 center((*x + *std::next(x)) / 2, (*y + *std::next(y)) / 2, (*z + *std::next(z)) / 2);
        const std::int32_t expected = test::find_contents(boxes, center);
        ASSERT_EQ(contents_at(center), expected) << center.x << " " << center.y << " " << center.z;
        ++seen[expected];
      }
    }
  }
  for (const std::int32_t contents : {-1, -2, -3, -6}) EXPECT_GT(seen[contents], 0) << contents;
}

using test::list_vertices;

double measure_area(const std::vector<math::Vec3>& vertices) {
  math::Vec3d doubled(0.0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    doubled += glm::cross(math::Vec3d(vertices[i] - vertices[0]),
                          math::Vec3d(vertices[(i + 1) % vertices.size()] - vertices[0]));
  return glm::length(doubled) / 2;
}

// The area in square units of the surfaces that are visible from open space, by direction (+x, -x, +y, and so
// on), from the definition of the layout.
std::array<double, 6> measure_visible_areas(const std::vector<SmallLevelBox>& boxes) {
  std::array<std::set<float>, 3> cut_sets;
  for (int axis = 0; axis < 3; ++axis)
    for (const SmallLevelBox& box : boxes) {
      cut_sets[static_cast<std::size_t>(axis)].insert(box.bounds.mins[axis]);
      cut_sets[static_cast<std::size_t>(axis)].insert(box.bounds.maxs[axis]);
    }
  std::array<std::vector<float>, 3> cuts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cuts[axis].push_back(*cut_sets[axis].begin() - 8);
    cuts[axis].insert(cuts[axis].end(), cut_sets[axis].begin(), cut_sets[axis].end());
    cuts[axis].push_back(*cut_sets[axis].rbegin() + 8);
  }
  const auto is_open = [](std::int32_t contents) { return contents == -1 || contents == -3; };
  std::array<double, 6> areas{};
  for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i) {
    for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j) {
      for (std::size_t k = 0; k + 1 < cuts[2].size(); ++k) {
        const math::Vec3 low(cuts[0][i], cuts[1][j], cuts[2][k]);
        const math::Vec3 high(cuts[0][i + 1], cuts[1][j + 1], cuts[2][k + 1]);
        const std::int32_t here = test::find_contents(boxes, (low + high) / 2.0f);
        if (!is_open(here)) continue;
        const math::Vec3d size(high - low);
        for (int axis = 0; axis < 3; ++axis) {
          math::Vec3 beyond = (low + high) / 2.0f;
          const double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
          beyond[axis] = low[axis] - 1;
          if (test::find_contents(boxes, beyond) != here) areas[static_cast<std::size_t>(axis * 2)] += area;
          beyond[axis] = high[axis] + 1;
          if (test::find_contents(boxes, beyond) != here)
            areas[static_cast<std::size_t>(axis * 2 + 1)] += area;
        }
      }
    }
  }
  return areas;
}

TEST_P(EverySmallLevel, FacesCoverEveryVisibleAreaOnce) {
  const formats::Bsp bsp = test::small_bsp(GetParam().options);
  std::array<double, 6> areas{};
  for (std::uint32_t i = 0; i < bsp.models[0].face_count; ++i) {
    const formats::BspFace& face = bsp.faces[bsp.models[0].first_face + i];
    const auto axis = static_cast<std::size_t>(bsp.planes[face.plane].type);
    areas[axis * 2 + static_cast<std::size_t>(face.side)] += measure_area(list_vertices(bsp, face));
  }
  const std::array<double, 6> expected = measure_visible_areas(small_level_boxes(GetParam().options));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(areas[i], expected[i], 1e-3) << i;
}

TEST_P(EverySmallLevel, NoVertexLiesInsideAnEdge) {
  const formats::Bsp bsp = test::small_bsp(GetParam().options);
  // Only the world: the door is a separate model, whose vertices may lie on the world's edges.
  const std::uint32_t world_faces = bsp.models[0].face_count;
  std::set<std::uint32_t> world_vertices;
  std::set<std::size_t> world_edges;
  for (std::uint32_t face = 0; face < world_faces; ++face) {
    for (std::uint32_t i = 0; i < bsp.faces[face].surfedge_count; ++i) {
      const auto edge = static_cast<std::size_t>(std::abs(bsp.surfedges[bsp.faces[face].first_surfedge + i]));
      world_edges.insert(edge);
      for (const std::uint32_t vertex : bsp.edges[edge].vertices) world_vertices.insert(vertex);
    }
  }
  for (const std::size_t edge : world_edges) {
    const math::Vec3 a = bsp.vertices[bsp.edges[edge].vertices[0]];
    const math::Vec3 b = bsp.vertices[bsp.edges[edge].vertices[1]];
    for (const std::uint32_t vertex : world_vertices) {
      const math::Vec3 p = bsp.vertices[vertex];
      const bool between =
          p != a && p != b && glm::distance(a, p) + glm::distance(p, b) == glm::distance(a, b);
      ASSERT_FALSE(between) << "vertex " << vertex << " on edge " << edge;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Options, EverySmallLevel, testing::ValuesIn(list_options()),
                         [](const auto& test) { return test.param.name; });

int count_max_edge_uses(const formats::Bsp& bsp) {
  std::map<std::int32_t, int> uses;
  int most = 0;
  for (const std::int32_t surfedge : bsp.surfedges) most = std::max(most, ++uses[std::abs(surfedge)]);
  return most;
}

TEST(SmallLevel, IsTheSameEveryTime) {
  const SmallLevelOptions options{.four_styles = true, .colored_light = true};
  EXPECT_TRUE(make_small_level(options) == make_small_level(options));
}

TEST(SmallLevel, SharesEdgesBetweenTwoFacesOrMore) {
  EXPECT_EQ(count_max_edge_uses(test::small_bsp()), 2);
  EXPECT_GE(count_max_edge_uses(test::small_bsp({.edge_used_three_times = true})), 3);
  EXPECT_GE(count_max_edge_uses(test::small_bsp({.edge_used_three_times = true, .tiny = true})), 3);
}

double measure_longest_lit_side(const formats::Bsp& bsp) {
  double longest = 0;
  for (const formats::BspFace& face : bsp.faces) {
    const formats::BspTexinfo& info = bsp.texinfos[face.texinfo];
    if (face.light_offset < 0) continue;
    for (const math::Vec3& a : list_vertices(bsp, face))
      for (const math::Vec3& b : list_vertices(bsp, face))
        longest =
            std::max(longest, double{std::max(glm::dot(info.s_axis, a - b), glm::dot(info.t_axis, a - b))});
  }
  return longest;
}

TEST(SmallLevel, HasFacesWiderThanStockOnlyOnRequest) {
  EXPECT_EQ(measure_longest_lit_side(test::small_bsp()), 256);
  EXPECT_EQ(measure_longest_lit_side(test::small_bsp({.wide_faces = true})), 1024);
}

std::size_t count_max_styles(const formats::Bsp& bsp) {
  std::size_t most = 0;
  for (const formats::BspFace& face : bsp.faces)
    most = std::max(most, static_cast<std::size_t>(std::count_if(face.styles.begin(), face.styles.end(),
                                                                 [](auto style) { return style != 255; })));
  return most;
}

TEST(SmallLevel, HasTheRequestedLight) {
  EXPECT_EQ(count_max_styles(test::small_bsp()), 2u);
  EXPECT_EQ(count_max_styles(test::small_bsp({.four_styles = true})), 4u);
  const formats::Bsp dark = test::small_bsp({.light = false, .colored_light = true});
  EXPECT_TRUE(dark.lighting.empty());
  EXPECT_TRUE(dark.bspx.empty());
  EXPECT_EQ(count_max_styles(dark), 0u);
  EXPECT_TRUE(test::small_bsp().bspx.empty());
  const formats::Bsp colored = test::small_bsp({.colored_light = true});
  const formats::BspxLump* lump = colored.find_bspx("RGBLIGHTING");
  ASSERT_NE(lump, nullptr);
  EXPECT_EQ(lump->data.size(), colored.lighting.size() * 3);
  EXPECT_EQ(colored.lighting, test::small_bsp().lighting);
}

TEST(SmallLevel, HidesLeavesFromOneAnotherOnlyWithAPvs) {
  const formats::Bsp bsp = test::small_bsp();
  EXPECT_FALSE(bsp.visibility.empty());
  for (std::int32_t leaf = 1; leaf <= bsp.models[0].visible_leaves; ++leaf)
    EXPECT_GE(bsp.leaves[static_cast<std::size_t>(leaf)].visibility_offset, 0);
  const formats::Bsp open = test::small_bsp({.pvs = false});
  EXPECT_TRUE(open.visibility.empty());
  for (const formats::BspLeaf& leaf : open.leaves) EXPECT_EQ(leaf.visibility_offset, -1);
}

TEST(SmallLevel, CanOmitATexture) {
  const auto empty = [](const formats::BspMiptex& miptex) { return miptex.mips[0].empty(); };
  const formats::Bsp whole = test::small_bsp();
  EXPECT_EQ(std::count_if(whole.miptexes.begin(), whole.miptexes.end(), empty), 0);
  const formats::Bsp lacking = test::small_bsp({.missing_texture = true});
  EXPECT_EQ(std::count_if(lacking.miptexes.begin(), lacking.miptexes.end(), empty), 1);
}

TEST(SmallLevel, MakesOnlyTheNamedTextures) {
  const auto make_named = [](std::vector<std::string_view> names) {
    std::vector<std::string> made;
    for (const formats::BspMiptex& texture : make_small_level_textures(names)) made.push_back(texture.name);
    return made;
  };
  EXPECT_THAT(make_named({}), testing::IsEmpty());
  EXPECT_THAT(make_named({"Slabs", "unknown", "BRICK", "slabs", "+", "panel"}),
              testing::ElementsAre("brick", "slabs"));
  EXPECT_THAT(make_named({"+1PANEL"}), testing::ElementsAre("+0panel", "+1panel", "+apanel"));

  const formats::Bsp level = test::small_bsp();
  std::vector<std::string_view> all;
  for (const formats::BspMiptex& texture : level.miptexes) all.push_back(texture.name);
  EXPECT_TRUE(make_small_level_textures(all) == level.miptexes);
}

TEST(SmallLevel, SeedChangesTheTexturesOnly) {
  formats::Bsp other = test::small_bsp({.seed = 2});
  formats::Bsp first = test::small_bsp();
  EXPECT_FALSE(other == first);
  other.miptexes = first.miptexes;
  EXPECT_TRUE(other == first);
}

TEST(SmallLevel, TheTinyOneIsASmallFile) {
  const auto bytes = formats::write_bsp(test::small_bsp({.tiny = true}), formats::BspVersion::k29);
  EXPECT_LT(bytes->size(), 20'000u);
}

TEST(SmallLevel, StartsThePlayerInTheOpen) {
  for (const bool tiny : {false, true}) {
    const SmallLevelOptions options{.tiny = tiny};
    const auto entities = formats::read_entities(test::small_bsp(options).entities);
    ASSERT_TRUE(entities.ok());
    int starts = 0;
    for (const formats::Entity& entity : *entities) {
      const auto origin = entity.find_vec3("origin");
      if (!entity.classname().starts_with("info_") || !origin) continue;
      ++starts;
      const math::Bounds player{*origin + math::Vec3(-16, -16, -24), *origin + math::Vec3(16, 16, 32)};
      EXPECT_FALSE(test::stops_box(small_level_boxes(options), player)) << entity.classname();
    }
    EXPECT_GE(starts, 1);
  }
}

}  // namespace
}  // namespace temblor::artgen
