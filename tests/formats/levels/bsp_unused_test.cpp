// Damaged records that no game reaches do not prevent a level from being played.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"
#include "formats/levels/cube_room.h"

namespace temblor::formats {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr std::int32_t kMinIndex = std::numeric_limits<std::int32_t>::min();
constexpr std::uint32_t kFar = 1u << 20;

base::Result<Bsp> write_and_read(const Bsp& bsp) {
  auto back = read_bsp(write_bsp(bsp, BspVersion::kBsp2).value());
  EXPECT_FALSE(back.ok() && find_fault(*back).has_value());
  return back;
}

struct UnusedCase {
  const char* name;
  void (*damage)(Bsp& io_bsp);
};

std::string unused_case_name(const testing::TestParamInfo<UnusedCase>& info) {
  return info.param.name;
}

// Each case appends records to the room to which none of its own refers.
class UnusedBsp : public testing::TestWithParam<UnusedCase> {};

TEST_P(UnusedBsp, KeepsTheRoom) {
  Bsp bsp = test::make_cube_room();
  bsp.version = BspVersion::kBsp2;
  const Bsp room = bsp;
  GetParam().damage(bsp);
  ASSERT_TRUE(find_fault(bsp).has_value());
  auto back = write_and_read(bsp);
  ASSERT_TRUE(back.ok()) << back.error().message();
  back->planes.resize(room.planes.size());
  back->vertices.resize(room.vertices.size());
  back->texinfos.resize(room.texinfos.size());
  back->edges.resize(room.edges.size());
  back->surfedges.resize(room.surfedges.size());
  back->faces.resize(room.faces.size());
  back->marksurfaces.resize(room.marksurfaces.size());
  back->leaves.resize(room.leaves.size());
  back->nodes.resize(room.nodes.size());
  back->clipnodes.resize(room.clipnodes.size());
  EXPECT_EQ(*back, room);
}

#define APPEND(...) [](Bsp& b) { __VA_ARGS__; }

const UnusedCase kUnusedCases[] = {
    {"Planes", APPEND(b.planes.resize(1000, BspPlane{{kNotANumber, 0, 0}, 0, 9}))},
    {"Vertex", APPEND(b.vertices.emplace_back(kNotANumber))},
    {"Texinfo", APPEND(b.texinfos.emplace_back(); b.texinfos.back().miptex = 700)},
    {"Edge", APPEND(b.edges.push_back({{0, 12345}}))},
    {"Surfedge", APPEND(b.surfedges.push_back(kMinIndex))},
    {"Marksurface", APPEND(b.marksurfaces.push_back(6))},
    {"FaceIndices", APPEND(b.faces.push_back({kFar, 7, 0, 4, kFar, {}, -9}))},
    {"FaceEdges", APPEND(b.faces.resize(1000, BspFace{0, 0, kFar, kFar, 0, {}, -1}))},
    {"FacesShareEdges", APPEND(b.faces.push_back(b.faces[0]))},
    {"LeafNumbers", APPEND(b.leaves.push_back({-99, 12345, math::Vec3(kNotANumber), {}, 0, 0, {}}))},
    {"LeafMarks", APPEND(b.leaves.push_back({-1, -1, {}, {}, kFar, kFar, {}}))},
    {"LeavesShareMarks", APPEND(b.leaves.push_back(b.leaves[1]))},
    {"Node", APPEND(b.nodes.push_back({kFar, {kMinIndex, 12345}, math::Vec3(kNotANumber), {}, kFar, kFar}))},
    {"NodesThatLeadToEachOther", APPEND(b.nodes.push_back({kFar, {8, 0}, {}, {}, 0, 6});
                                        b.nodes.push_back({kFar, {7, 0}, {}, {}, 0, 6}))},
    {"Clipnode", APPEND(b.clipnodes.push_back({kFar, {kMinIndex, 12345}}))},
    {"NodeWithAPlaneOfItsOwn",
     APPEND(b.planes.push_back({}); b.nodes.push_back({6, {-1, -1}, {}, {}, 0, 0}))},
    {"FaceWithRecordsOfItsOwn",
     APPEND(b.vertices.emplace_back(kNotANumber); b.edges.push_back({{8, 9}}); b.surfedges.resize(28, 13);
            b.texinfos.emplace_back(); b.texinfos.back().miptex = -7;
            b.faces.push_back({0, 0, 24, 4, 3, {}, -1}))},
};
INSTANTIATE_TEST_SUITE_P(Records, UnusedBsp, testing::ValuesIn(kUnusedCases), unused_case_name);

TEST(BspUnused, ReplacementsAreHarmless) {
  Bsp bsp = test::make_cube_room();
  bsp.leaves.push_back({-99, 0, {}, {}, 0, 6, {}});
  bsp.nodes.push_back({kFar, {kFar, kFar}, {}, {}, 0, 6});
  bsp.clipnodes.push_back({kFar, {0, 0}});
  bsp.faces.push_back({kFar, 0, 0, 4, 0, {}, 0});
  const auto back = write_and_read(bsp);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->leaves.back().contents, -2);
  EXPECT_EQ(back->leaves.back().marksurface_count, 0u);
  EXPECT_EQ(back->nodes.back().face_count, 0u);
  EXPECT_EQ(back->nodes.back().children, (std::array<std::int32_t, 2>{-1, -1}));
  EXPECT_EQ(back->clipnodes.back().children, (std::array<std::int32_t, 2>{-1, -1}));
  EXPECT_EQ(back->faces.back().light_offset, -1);
  for (std::uint32_t i = 0; i < back->faces.back().surfedge_count; ++i)
    EXPECT_EQ(back->edges[static_cast<std::size_t>(back->surfedges[back->faces.back().first_surfedge + i])],
              BspEdge{});
}

// A valid record that no game reaches stays as it is.
TEST(BspUnused, ValidLevelsAreNotChanged) {
  Bsp bsp = test::make_cube_room();
  bsp.version = BspVersion::kBsp2;
  bsp.planes.push_back({{0, 1, 0}, 7, 1});
  bsp.leaves.push_back({-3, 0, {}, {}, 0, 0, {9, 9, 9, 9}});
  const auto back = write_and_read(bsp);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(*back, bsp);
}

// Ranges of a million leaves that all cover a million marksurfaces must not take a million times a million
// steps.
TEST(BspUnused, ManyRangesTakeLinearTime) {
  constexpr std::uint32_t kMany = 200000;
  Bsp bsp = test::make_cube_room();
  bsp.marksurfaces.resize(kMany, 0);
  bsp.nodes.resize(7 + kMany, BspNode{0, {-2, -2}, {}, {}, 0, kMany});
  bsp.faces.resize(kMany, bsp.faces[0]);
  for (std::uint32_t i = 6; i < 6 + kMany; ++i)
    bsp.nodes[i].children = {static_cast<std::int32_t>(i + 1), -2};
  const auto back = write_and_read(bsp);  // the first of these nodes are in use
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_NE(back->repairs.find("are repaired"), std::string::npos);
}

}  // namespace
}  // namespace temblor::formats
