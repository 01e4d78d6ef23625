// Damage that other engines ignore is repaired, and named. The expected level is the room with the repair
// made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"
#include "formats/levels/cube_room.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using ::testing::StartsWith;

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kEndless = std::numeric_limits<float>::infinity();
constexpr std::int32_t kLowestInt = std::numeric_limits<std::int32_t>::min();
constexpr std::uint32_t kFarAway = 0x7fffffff;

// Leaves faces out as the reader does: each has three edges from vertex 0 to itself.
void leave_out_faces(Bsp& io_bsp, std::initializer_list<std::size_t> faces) {
  const auto edge = static_cast<std::int32_t>(io_bsp.edges.size());
  const auto texinfo = static_cast<std::uint32_t>(io_bsp.texinfos.size());
  io_bsp.edges.emplace_back();
  io_bsp.texinfos.push_back({{1, 0, 0}, 0, {0, 1, 0}, 0, 0, 1});
  for (const std::size_t face : faces) {
    const auto first = static_cast<std::uint32_t>(io_bsp.surfedges.size());
    io_bsp.faces[face] = {0, 0, first, 3, texinfo, {255, 255, 255, 255}, -1};
    io_bsp.surfedges.insert(io_bsp.surfedges.end(), {edge, edge, edge});
  }
}

// Gives a face edges of its own.
void give_edges(Bsp& io_bsp, std::size_t face, std::initializer_list<std::uint32_t> corners) {
  io_bsp.faces[face].first_surfedge = static_cast<std::uint32_t>(io_bsp.surfedges.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    io_bsp.surfedges.push_back(static_cast<std::int32_t>(io_bsp.edges.size()));
    io_bsp.edges.push_back({{corners.begin()[i], corners.begin()[(i + 1) % corners.size()]}});
  }
}

// No face uses these surfedges any more.
void forget_surfedges(Bsp& io_bsp, std::size_t first, std::size_t count) {
  std::fill_n(io_bsp.surfedges.begin() + static_cast<std::ptrdiff_t>(first), count, 0);
}

// Appends nodes, of which each is the back child of the one before; the first belongs to model 1.
void make_chain(std::uint32_t length, Bsp& io_bsp) {
  const auto first = static_cast<std::int32_t>(io_bsp.nodes.size());
  io_bsp.models[1].head_nodes[0] = first;
  for (std::uint32_t i = 1; i <= length; ++i)
    io_bsp.nodes.push_back({0, {-1, i < length ? first + static_cast<std::int32_t>(i) : -1}, {}, {}, 0, 0});
}

std::string remove_offset(std::string text) {
  const std::size_t begin = text.find(" at offset ");
  if (begin != std::string::npos) text.erase(begin, text.find(':', begin) - begin);
  return text;
}

struct RepairCase {
  const char* name;
  void (*damage)(Bsp& io_bsp);
  const char* repairs;  // the beginning, without " at offset 0x..."; null: it is not worth a note
  void (*repair)(Bsp& io_bsp);
};

class RepairedBsp : public testing::TestWithParam<RepairCase> {};

TEST_P(RepairedBsp, EqualsTheRepairByHand) {
  Bsp bsp = test::make_cube_room();
  bsp.version = BspVersion::kBsp2;
  GetParam().damage(bsp);
  Bsp expected = bsp;
  GetParam().repair(expected);
  auto back = read_bsp(write_bsp(bsp, BspVersion::kBsp2).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_FALSE(find_fault(*back).has_value());
  if (GetParam().repairs == nullptr) {
    EXPECT_EQ(back->repairs, "");
  } else {
    EXPECT_THAT(remove_offset(back->repairs), StartsWith(GetParam().repairs));
  }
  back->repairs.clear();
  EXPECT_EQ(*back, expected);
}

#define CHANGE(...) [](Bsp& b) { __VA_ARGS__; }

const RepairCase kPlaneRepairs[] = {
    {"TypeIsComputed", CHANGE(b.planes[1].type = 99), nullptr, CHANGE(b.planes[1].type = 0)},
    {"NegativeTypeIsComputed", CHANGE(b.planes[1] = (BspPlane{{0, -1, 0}, 64, -1})), nullptr,
     CHANGE(b.planes[1].type = 4)},
    {"NormalIsScaled", CHANGE(b.planes[2] = (BspPlane{{0, 2, 0}, 128, 4})),
     "lump planes: plane 2: the length of the normal is 2, not 1; it is repaired",
     CHANGE(b.planes[2] = (BspPlane{{0, 1, 0}, 64, 1}))},
    {"NoNormalLeavesAllSpaceBehind", CHANGE(b.planes[0] = (BspPlane{{0, 0, 0}, 5, 3})),
     "lump planes: plane 0: the length of the normal is 0, not 1; it is repaired",
     CHANGE(b.planes[0] = (BspPlane{{1, 0, 0}, kBspMaxCoordinate, 0}))},
    {"NoNormalLeavesAllSpaceInFront", CHANGE(b.planes[0] = (BspPlane{{0, 0, 0}, -5, 3})),
     "lump planes: plane 0: the length", CHANGE(b.planes[0] = (BspPlane{{1, 0, 0}, -kBspMaxCoordinate, 0}))},
    {"NotANumberLeavesAllSpaceBehind", CHANGE(b.planes[2].normal.y = kNoNumber),
     "lump planes: plane 2: a number is not finite or too large; it is repaired",
     CHANGE(b.planes[2] = (BspPlane{{1, 0, 0}, kBspMaxCoordinate, 0}))},
    {"FarPlane", CHANGE(b.planes[2].distance = 1e9f),
     "lump planes: plane 2: a number is not finite or too large",
     CHANGE(b.planes[2].distance = kBspMaxCoordinate)},
};

const RepairCase kFaceRepairs[] = {
    {"VertexOfThreeWalls", CHANGE(b.vertices[7].z = kEndless),
     "lump vertices: vertex 7: a coordinate is not finite or too large; this and 2 other damaged records are",
     CHANGE(b.vertices[7] = {}; for (BspEdge & e
                                     : b.edges) if (e.vertices[0] == 7 || e.vertices[1] == 7) e = {};
            const std::vector<BspEdge> old = test::make_cube_room().edges; for (std::int32_t & s
                                                                                : b.surfedges) {
              const BspEdge& e = old[static_cast<std::size_t>(std::abs(s))];
              if (e.vertices[0] == 7 || e.vertices[1] == 7) s = 0;
            } leave_out_faces(b, {0, 2, 4}))},
    {"TexinfoAxis", CHANGE(b.texinfos[1].s_axis.x = -kEndless),
     "lump texinfo: texinfo 1: a number is not finite or too large; this and 1 other damaged record",
     CHANGE(b.texinfos[1] = (BspTexinfo{{1, 0, 0}, 0, {0, 1, 0}, 0, 0, 1}); leave_out_faces(b, {2, 3}))},
    {"Texture", CHANGE(b.texinfos[0].miptex = 5000),
     "lump texinfo: texinfo 0: texture 5000 is past the end (3); it is repaired",
     CHANGE(b.texinfos[0].miptex = 3; b.miptexes.emplace_back())},
    {"TextureNegative", CHANGE(b.texinfos[0].miptex = -1),
     "lump texinfo: texinfo 0: texture -1 is past the end (3)",
     CHANGE(b.texinfos[0].miptex = 3; b.miptexes.emplace_back())},
    {"NoTextures", CHANGE(b.miptexes.clear(); b.texinfos[0].miptex = 2),
     "lump texinfo: texinfo 0: texture 2 is past the end (1); it is repaired",
     CHANGE(b.miptexes.resize(2); b.texinfos[0].miptex = 1)},
    {"Side", CHANGE(b.faces[0].side = 7), "lump faces: face 0: side 7 is not 0 or 1; it is repaired",
     CHANGE(b.faces[0].side = 1)},
    {"Light", CHANGE(b.faces[5].light_offset = -2), "lump faces: face 5: light offset -2 is below -1",
     CHANGE(b.faces[5].light_offset = -1)},
    {"Plane", CHANGE(b.faces[5].plane = 6), "lump faces: face 5: plane 6 is past the end (6)",
     CHANGE(leave_out_faces(b, {5}))},
    {"FaceTexinfo", CHANGE(b.faces[5].texinfo = 700), "lump faces: face 5: texinfo 700 is past the end (3)",
     CHANGE(leave_out_faces(b, {5}))},
    {"NoEdges", CHANGE(b.faces[2].surfedge_count = 0),
     "lump faces: face 2: 0 edges are not within 3 to 512; it is",
     CHANGE(forget_surfedges(b, 8, 4); leave_out_faces(b, {2}))},
    {"ManyEdges", CHANGE(b.surfedges.resize(100000, 1); b.faces[2].surfedge_count = 100000),
     "lump faces: face 2: 100000 edges are not within 3 to 512", CHANGE(leave_out_faces(b, {2}))},
    {"EdgesFarAway", CHANGE(b.faces[5].first_surfedge = kFarAway),
     "lump faces: face 5: surfedge 2147483647 and the 4 after it are past the end (24)",
     CHANGE(forget_surfedges(b, 20, 4); leave_out_faces(b, {5}))},
    {"Surfedge", CHANGE(b.surfedges[3] = kLowestInt),
     "lump surfedges: surfedge 3: edge -2147483648 is past the end (13)",
     CHANGE(b.surfedges[3] = 0; leave_out_faces(b, {0}))},
    {"OpenOutline", CHANGE(b.surfedges[1] = -b.surfedges[1]),
     "lump faces: face 0: the edges do not form a loop: edge 1 starts at vertex 7, the previous one ends at "
     "3; it is repaired",
     CHANGE(give_edges(b, 0, {1, 7, 7, 5}))},
    {"SharedEdges", CHANGE(b.faces[1].first_surfedge = 2), "lump faces: face 1: the edges do not form a loop",
     CHANGE(forget_surfedges(b, 6, 2); give_edges(b, 1, {7, 5, 0, 4}))},
};

const RepairCase kTreeRepairs[] = {
    {"Visibility", CHANGE(b.leaves[1].visibility_offset = 1),
     "lump leaves: leaf 1: visibility offset 1 is past the end (1); it is repaired",
     CHANGE(b.leaves[1].visibility_offset = -1)},
    {"VisibilityNegative", CHANGE(b.leaves[1].visibility_offset = -2),
     "lump leaves: leaf 1: visibility offset -2 is past the end (1)",
     CHANGE(b.leaves[1].visibility_offset = -1)},
    {"Contents", CHANGE(b.leaves[1].contents = -20),
     "lump leaves: leaf 1: contents -20 are not within -16 to -1; it is repaired",
     CHANGE(b.leaves[1].contents = -1)},
    {"ContentsOfLeafZero", CHANGE(b.leaves[0].contents = -1),
     "lump leaves: leaf 0: contents -1 are not solid (-2)", CHANGE(b.leaves[0].contents = -2)},
    {"LeafBound", CHANGE(b.leaves[1].mins.x = kNoNumber), "lump leaves: leaf 1: a bound is not finite",
     CHANGE(b.leaves[1].mins = math::Vec3(-kBspMaxCoordinate);
            b.leaves[1].maxs = math::Vec3(kBspMaxCoordinate))},
    {"LeafMarks", CHANGE(b.leaves[1].first_marksurface = 1),
     "lump leaves: leaf 1: marksurface 1 and the 6 after it are past the end (6)",
     CHANGE(b.leaves[1].marksurface_count = 5)},
    {"LeafMarksFarAway", CHANGE(b.leaves[1].first_marksurface = ~0u),
     "lump leaves: leaf 1: marksurface 4294967295",
     CHANGE(b.marksurfaces.assign(6, 0); b.leaves[1].first_marksurface = 6;
            b.leaves[1].marksurface_count = 0)},
    {"LeavesShareMarks", CHANGE(b.leaves.push_back(b.leaves[1]); b.nodes[6].children[1] = -3),
     "lump leaves: leaf 2: marksurfaces are referenced 12 times up to here, but there are only 6",
     CHANGE(b.leaves[1].marksurface_count = 0)},
    {"Marksurface", CHANGE(b.marksurfaces[4] = 6),
     "lump marksurfaces: marksurface 4: face 6 is past the end (6)", CHANGE(b.marksurfaces[4] = 3)},
    {"NodeBound", CHANGE(b.nodes[1].maxs.z = kNoNumber), "lump nodes: node 1: a bound is not finite",
     CHANGE(b.nodes[1].mins = math::Vec3(-kBspMaxCoordinate);
            b.nodes[1].maxs = math::Vec3(kBspMaxCoordinate))},
    {"NodeChild", CHANGE(b.nodes[3].children[1] = 7),
     "lump nodes: node 3: child 7 is neither one of 7 nodes nor of 2 leaves",
     CHANGE(b.nodes[3].children[1] = -1)},
    {"NodePlane", CHANGE(b.nodes[3].plane = 6; b.nodes[4].plane = 99999),
     "lump nodes: node 3: plane 6 is past the end (6); this and 1 other damaged record",
     CHANGE(b.nodes[3].plane = b.nodes[4].plane = 6; b.planes.push_back({{1, 0, 0}, kBspMaxCoordinate, 0}))},
    {"NodeCycle", CHANGE(b.nodes[4].children[0] = 0),
     "lump nodes: node 0: it is reached twice; it is repaired", CHANGE(b.nodes[4].children[0] = -1)},
    {"NodeItsOwnChild", CHANGE(b.nodes[6].children[1] = 6), "lump nodes: node 6: it is reached twice",
     CHANGE(b.nodes[6].children[1] = -1)},
    {"NodeShared", CHANGE(b.nodes[2].children[0] = 4), "lump nodes: node 4: it is reached twice",
     CHANGE(std::ranges::replace(b.nodes[3].children, 4, -1))},
    {"NodesTooDeep", CHANGE(make_chain(kBspMaxTreeDepth + 2, b)),
     "lump nodes: node 2055: the tree is deeper than 2048 nodes; it is repaired",
     CHANGE(b.nodes[kBspMaxTreeDepth + 6].children[1] = -1; b.nodes[6] = {0, {-1, -1}, {}, {}, 0, 0})},
    {"NodeFaces", CHANGE(b.nodes[3].face_count = 200),
     "lump nodes: node 3: face 3 and the 200 after it are past the end (6); this and 1 other damaged record",
     CHANGE(b.nodes[3].face_count = 1)},
    {"ClipnodeContents", CHANGE(b.clipnodes[3].children[1] = -17),
     "lump clipnodes: clipnode 3: child -17 is neither one of 6 clipnodes nor contents",
     CHANGE(b.clipnodes[3].children[1] = -1)},
    {"ClipnodeChild", CHANGE(b.clipnodes[3].children[1] = 6),
     "lump clipnodes: clipnode 3: child 6 is neither one of 6 clipnodes nor contents",
     CHANGE(b.clipnodes[3].children[1] = -2)},
};

const RepairCase kModelRepairs[] = {
    {"Bound", CHANGE(b.models[1].maxs.z = kNoNumber),
     "lump models: model 1: a coordinate is not finite or too large; it is repaired",
     CHANGE(b.models[1].mins = b.models[1].maxs = {})},
    {"BoundOfTheWorld", CHANGE(b.models[0].mins.x = kNoNumber),
     "lump models: model 0: a coordinate is not finite or too large; it is repaired",
     CHANGE(b.models[0].mins = math::Vec3(-64))},
    {"Origin", CHANGE(b.models[1].origin.z = kEndless),
     "lump models: model 1: a coordinate is not finite or too large", CHANGE(b.models[1].origin = {})},
    {"Head", CHANGE(b.models[1].head_nodes[0] = 7),
     "lump models: model 1: head 7 of hull 0 is neither one of 7 nodes nor of 2 leaves",
     CHANGE(b.models[1].head_nodes[0] = -2; b.nodes[6] = {0, {-1, -1}, {}, {}, 0, 0})},
    {"ClipHead", CHANGE(b.models[1].head_nodes[2] = 99999),
     "lump models: model 1: head 99999 of hull 2 is neither one of 6 clipnodes nor contents",
     CHANGE(b.models[1].head_nodes[2] = -1)},
    {"HeadInAnotherTree", CHANGE(b.models[1].head_nodes[0] = 3),
     "lump nodes: node 3: it is reached twice; it is repaired",
     CHANGE(b.models[1].head_nodes[0] = -2; b.nodes[6] = {0, {-1, -1}, {}, {}, 0, 0})},
    {"LargeHullOfTheWorld", CHANGE(b.models[0].head_nodes[2] = 99999),
     "lump models: model 0: head 99999 of hull 2 is neither one of 6 clipnodes nor contents",
     CHANGE(b.models[0].head_nodes[2] = b.models[0].head_nodes[1])},
    {"UnusedHullOfTheWorld", CHANGE(b.models[0].head_nodes[3] = 99999),
     "lump models: model 0: head 99999 of hull 3 is neither one of 6 clipnodes nor contents",
     CHANGE(b.models[0].head_nodes[3] = -1)},
    {"Leaves", CHANGE(b.models[0].visible_leaves = 99999),
     "lump models: model 0: 99999 visible leaves are not fewer than all 2",
     CHANGE(b.models[0].visible_leaves = 1)},
    {"LeavesNegative", CHANGE(b.models[0].visible_leaves = -1),
     "lump models: model 0: -1 visible leaves are not fewer than all 2",
     CHANGE(b.models[0].visible_leaves = 1)},
    {"Faces", CHANGE(b.models[1].face_count = 1),
     "lump models: model 1: face 6 and the 1 after it are past the end (6)",
     CHANGE(b.models[1].face_count = 0)},
    {"SharedFaces", CHANGE(b.models[1].first_face = 2; b.models[1].face_count = 2),
     "lump models: model 1: faces are referenced 8 times up to here, but there are only 6",
     CHANGE(b.models[0].face_count = 2)},
};

std::string repair_case_name(const testing::TestParamInfo<RepairCase>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Planes, RepairedBsp, testing::ValuesIn(kPlaneRepairs), repair_case_name);
INSTANTIATE_TEST_SUITE_P(Faces, RepairedBsp, testing::ValuesIn(kFaceRepairs), repair_case_name);
INSTANTIATE_TEST_SUITE_P(Trees, RepairedBsp, testing::ValuesIn(kTreeRepairs), repair_case_name);
INSTANTIATE_TEST_SUITE_P(Models, RepairedBsp, testing::ValuesIn(kModelRepairs), repair_case_name);

// Overwrites numbers of the records, not of the header, so that most files can be played.
TEST(RepairedBspBytes, DamagedNumbersLeaveAValidLevelOrAnError) {
  constexpr std::array kVersions{BspVersion::k29, BspVersion::k2Psb, BspVersion::kBsp2, BspVersion::k30};
  constexpr std::array<std::uint32_t, 6> kNumbers{0, 0xffffffff, 0x7fffffff, 0x7fc00000, 99999, 0xffec};
  constexpr std::size_t kHeaderSize = 124;
  constexpr int kRuns = test::effort(10000, 1000);
  int played = 0;
  for (int run = 0; run < kRuns; ++run) {
    test::Random random(static_cast<std::uint64_t>(run));
    const BspVersion version = kVersions[static_cast<std::size_t>(run) % kVersions.size()];
    auto file = test::make_cube_room_file(version);
    for (std::size_t i = 1 + random.below(4); i > 0; --i) {
      const std::uint32_t number = kNumbers[random.below(kNumbers.size())];
      const std::size_t place =
          kHeaderSize + random.below(file.size() - kHeaderSize - sizeof(number)) / 2 * 2;
      std::memcpy(file.data() + place, &number, sizeof(number));
    }
    auto bsp = read_bsp(file);
    if (!bsp.ok()) continue;
    ++played;
    ASSERT_FALSE(find_fault(*bsp).has_value()) << "seed " << run;
    const auto back = read_bsp(write_bsp(*bsp, version).value());
    ASSERT_TRUE(back.ok()) << "seed " << run << ": " << back.error().message();
    bsp->repairs.clear();
    ASSERT_TRUE(*back == *bsp) << "seed " << run;
  }
  EXPECT_GT(played, kRuns / 2);
}

}  // namespace
}  // namespace temblor::formats
