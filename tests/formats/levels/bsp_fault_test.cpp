// Levels that contradict themselves are rejected with an exact error, in every version.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"
#include "formats/levels/cube_room.h"

namespace temblor::formats {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();

struct Case {
  const char* name;
  void (*damage)(Bsp& io_bsp);
  const char* error;  // without " at offset 0x..."
};

std::string without_offset(std::string text) {
  const std::size_t begin = text.find(" at offset ");
  if (begin != std::string::npos) text.erase(begin, text.find(':', begin) - begin);
  return text;
}

class RejectedBsp : public testing::TestWithParam<Case> {};

TEST_P(RejectedBsp, NamesTheFault) {
  Bsp bsp = test::make_cube_room();
  GetParam().damage(bsp);
  const auto file = write_bsp(bsp, BspVersion::kBsp2);
  ASSERT_TRUE(file.ok()) << file.error().message();
  const auto back = read_bsp(*file);
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.error().code, base::ErrorCode::kMalformed);
  EXPECT_EQ(without_offset(back.error().what), GetParam().error);
}

#define DAMAGE(...) [](Bsp& b) { __VA_ARGS__; }

const Case kNumbers[] = {
    {"PlaneNan", DAMAGE(b.planes[2].normal.y = kNan),
     "lump planes: plane 2: a number is not finite or too large"},
    {"PlaneFar", DAMAGE(b.planes[2].distance = 1e9f),
     "lump planes: plane 2: a number is not finite or too large"},
    {"PlaneLength", DAMAGE(b.planes[2] = (BspPlane{{0, 0, 2}, 0, 5})),
     "lump planes: plane 2: the length of the normal is 2, not 1"},
    {"PlaneNull", DAMAGE(b.planes[0] = BspPlane{}),
     "lump planes: plane 0: the length of the normal is 0, not 1"},
    {"PlaneType", DAMAGE(b.planes[1].type = 6), "lump planes: plane 1: type 6 is not 0 to 5"},
    {"PlaneTypeLow", DAMAGE(b.planes[1].type = -1), "lump planes: plane 1: type -1 is not 0 to 5"},
    {"Vertex", DAMAGE(b.vertices[7].z = kInfinity),
     "lump vertices: vertex 7: a coordinate is not finite or too large"},
    {"TexinfoAxis", DAMAGE(b.texinfos[1].s_axis.x = -kInfinity),
     "lump texinfo: texinfo 1: a number is not finite or too large"},
    {"TexinfoOffset", DAMAGE(b.texinfos[1].t_offset = kNan),
     "lump texinfo: texinfo 1: a number is not finite or too large"},
    {"LeafBound", DAMAGE(b.leaves[1].mins.x = kNan), "lump leaves: leaf 1: a bound is not finite"},
    {"NodeBound", DAMAGE(b.nodes[1].maxs.z = kNan), "lump nodes: node 1: a bound is not finite"},
    {"ModelBound", DAMAGE(b.models[1].maxs.z = kNan),
     "lump models: model 1: a coordinate is not finite or too large"},
    {"ModelOrigin", DAMAGE(b.models[1].origin.z = kInfinity),
     "lump models: model 1: a coordinate is not finite or too large"},
};

const Case kIndices[] = {
    {"TexinfoTexture", DAMAGE(b.texinfos[0].miptex = 3),
     "lump texinfo: texinfo 0: texture 3 is past the end (3)"},
    {"TexinfoTextureNegative", DAMAGE(b.texinfos[0].miptex = -1),
     "lump texinfo: texinfo 0: texture -1 is past the end (3)"},
    {"EdgeVertex", DAMAGE(b.edges[12].vertices[1] = 8), "lump edges: edge 12: vertex 8 is past the end (8)"},
    {"Surfedge", DAMAGE(b.surfedges[3] = 13), "lump surfedges: surfedge 3: edge 13 is past the end (13)"},
    {"SurfedgeNegative", DAMAGE(b.surfedges[3] = -13),
     "lump surfedges: surfedge 3: edge -13 is past the end (13)"},
    {"SurfedgeLowest", DAMAGE(b.surfedges[3] = kLowest),
     "lump surfedges: surfedge 3: edge -2147483648 is past the end (13)"},
    {"FacePlane", DAMAGE(b.faces[5].plane = 6), "lump faces: face 5: plane 6 is past the end (6)"},
    {"FaceTexinfo", DAMAGE(b.faces[5].texinfo = 700), "lump faces: face 5: texinfo 700 is past the end (3)"},
    {"FaceSide", DAMAGE(b.faces[5].side = 2), "lump faces: face 5: side 2 is not 0 or 1"},
    {"FaceLight", DAMAGE(b.faces[5].light_offset = -2), "lump faces: face 5: light offset -2 is below -1"},
    {"FaceRange", DAMAGE(b.faces[5].first_surfedge = 21),
     "lump faces: face 5: surfedge 21 and the 4 after it are past the end (24)"},
    {"FaceRangeFar", DAMAGE(b.faces[5].first_surfedge = 0x7fffffff),
     "lump faces: face 5: surfedge 2147483647 and the 4 after it are past the end (24)"},
    {"LeafMarks", DAMAGE(b.leaves[1].first_marksurface = 1),
     "lump leaves: leaf 1: marksurface 1 and the 6 after it are past the end (6)"},
    {"LeafMarksWrap", DAMAGE(b.leaves[1].first_marksurface = 0xffffffff),
     "lump leaves: leaf 1: marksurface 4294967295 and the 6 after it are past the end (6)"},
    {"LeafVisibility", DAMAGE(b.leaves[1].visibility_offset = 1),
     "lump leaves: leaf 1: visibility offset 1 is past the end (1)"},
    {"LeafVisibilityNegative", DAMAGE(b.leaves[1].visibility_offset = -2),
     "lump leaves: leaf 1: visibility offset -2 is past the end (1)"},
    {"LeafContents", DAMAGE(b.leaves[1].contents = 0),
     "lump leaves: leaf 1: contents 0 are not within -16 to -1"},
    {"LeafContentsLow", DAMAGE(b.leaves[1].contents = -17),
     "lump leaves: leaf 1: contents -17 are not within -16 to -1"},
    {"LeafZeroOpen", DAMAGE(b.leaves[0].contents = -1),
     "lump leaves: leaf 0: contents -1 are not solid (-2)"},
    {"Marksurface", DAMAGE(b.marksurfaces[4] = 6),
     "lump marksurfaces: marksurface 4: face 6 is past the end (6)"},
    {"NodePlane", DAMAGE(b.nodes[3].plane = 6), "lump nodes: node 3: plane 6 is past the end (6)"},
    {"NodeChild", DAMAGE(b.nodes[3].children[0] = 7),
     "lump nodes: node 3: child 7 is neither one of 7 nodes nor of 2 leaves"},
    {"NodeLeaf", DAMAGE(b.nodes[3].children[0] = -3),
     "lump nodes: node 3: child -3 is neither one of 7 nodes nor of 2 leaves"},
    {"NodeLeafLowest", DAMAGE(b.nodes[3].children[0] = kLowest),
     "lump nodes: node 3: child -2147483648 is neither one of 7 nodes nor of 2 leaves"},
    {"NodeFaces", DAMAGE(b.nodes[3].first_face = 6),
     "lump nodes: node 3: face 6 and the 1 after it are past the end (6)"},
    {"ClipnodePlane", DAMAGE(b.clipnodes[3].plane = 6),
     "lump clipnodes: clipnode 3: plane 6 is past the end (6)"},
    {"ClipnodeChild", DAMAGE(b.clipnodes[3].children[1] = 6),
     "lump clipnodes: clipnode 3: child 6 is neither one of 6 clipnodes nor contents"},
    {"ClipnodeContents", DAMAGE(b.clipnodes[3].children[1] = -17),
     "lump clipnodes: clipnode 3: child -17 is neither one of 6 clipnodes nor contents"},
    {"ModelHead", DAMAGE(b.models[1].head_nodes[0] = 7),
     "lump models: model 1: head 7 of hull 0 is neither one of 7 nodes nor of 2 leaves"},
    {"ModelClipHead", DAMAGE(b.models[1].head_nodes[3] = 6),
     "lump models: model 1: head 6 of hull 3 is neither one of 6 clipnodes nor contents"},
    {"ModelFaces", DAMAGE(b.models[1].face_count = 1),
     "lump models: model 1: face 6 and the 1 after it are past the end (6)"},
    {"ModelLeaves", DAMAGE(b.models[0].visible_leaves = 2),
     "lump models: model 0: 2 visible leaves are not fewer than all 2"},
    {"ModelLeavesNegative", DAMAGE(b.models[0].visible_leaves = -1),
     "lump models: model 0: -1 visible leaves are not fewer than all 2"},
};

const Case kShapes[] = {
    {"NoModels", DAMAGE(b.models.clear()), "lump models: model 0 (the world) is missing"},
    {"NoLeaves", DAMAGE(b.leaves.clear()), "lump leaves: leaf 0 (solid) is missing"},
    {"NoEdges", DAMAGE(b.faces[2].surfedge_count = 0), "lump faces: face 2: 0 edges are not within 3 to 512"},
    {"TwoEdges", DAMAGE(b.faces[2].surfedge_count = 2),
     "lump faces: face 2: 2 edges are not within 3 to 512"},
    {"ManyEdges", DAMAGE(b.surfedges.resize(100000, 1); b.faces[2].surfedge_count = 100000),
     "lump faces: face 2: 100000 edges are not within 3 to 512"},
    {"OpenLoop", DAMAGE(b.surfedges[1] = -b.surfedges[1]),
     "lump faces: face 0: the edges do not form a loop: edge 1 starts at vertex 7, the previous one ends at "
     "3"},
    {"UnclosedLoop", DAMAGE(b.faces[0].surfedge_count = 3),
     "lump faces: face 0: the edges do not form a loop: edge 0 starts at vertex 1, the previous one ends at "
     "5"},
    {"FacesShareEdges", DAMAGE(b.faces.push_back(b.faces[0]); b.models[1].face_count = 1),
     "lump faces: face 6: surfedges are referenced 28 times up to here, but there are only 24"},
    {"LeavesShareMarks", DAMAGE(b.leaves.push_back(b.leaves[1]); b.nodes[6].children[1] = -3),
     "lump leaves: leaf 2: marksurfaces are referenced 12 times up to here, but there are only 6"},
    {"NodesShareFaces", DAMAGE(b.nodes[6].face_count = 1),
     "lump nodes: node 6: faces are referenced 7 times up to here, but there are only 6"},
    {"ModelsShareFaces", DAMAGE(b.models[1].first_face = 2; b.models[1].face_count = 2),
     "lump models: model 1: faces are referenced 8 times up to here, but there are only 6"},
    {"NodeCycle", DAMAGE(b.nodes[4].children[0] = 0), "lump nodes: node 0: it is reached twice"},
    {"NodeItsOwnChild", DAMAGE(b.nodes[6].children[1] = 6), "lump nodes: node 6: it is reached twice"},
    {"NodeShared", DAMAGE(b.nodes[2].children[0] = 4), "lump nodes: node 4: it is reached twice"},
    {"NodeOfTwoModels", DAMAGE(b.models[1].head_nodes[0] = 3), "lump nodes: node 3: it is reached twice"},
    {"ClipnodeCycle", DAMAGE(b.clipnodes[5].children[0] = 2),
     "lump clipnodes: clipnode 2: a path from it comes back to it"},
    {"ClipnodeItsOwnChild", DAMAGE(b.clipnodes[5].children[1] = 5),
     "lump clipnodes: clipnode 5: a path from it comes back to it"},
};

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Numbers, RejectedBsp, testing::ValuesIn(kNumbers), case_name);
INSTANTIATE_TEST_SUITE_P(Indices, RejectedBsp, testing::ValuesIn(kIndices), case_name);
INSTANTIATE_TEST_SUITE_P(Shapes, RejectedBsp, testing::ValuesIn(kShapes), case_name);

TEST(RejectedBspOffset, NamesTheRecordsOffsetInTheFile) {
  Bsp bsp = test::make_cube_room();
  bsp.faces[2].texinfo = 9;
  for (const auto& [version, face_bytes] : {std::pair(BspVersion::k29, 20u), {BspVersion::kBsp2, 28u}}) {
    const auto file = write_bsp(bsp, version).value();
    base::ByteReader header(file);
    header.seek(4 + 8 * 7);
    const std::uint32_t offset = header.u32() + 2 * face_bytes;
    EXPECT_EQ(read_bsp(file).error().what,
              fmt::format("lump faces: face 2 at offset {:#x}: texinfo 9 is past the end (3)", offset));
  }
}

// Makes a chain: node i leads to node i + 1.
template <typename Node>
void make_chain(std::vector<Node>& out_nodes, std::uint32_t length) {
  out_nodes.assign(length, Node{});
  for (std::uint32_t i = 0; i < length; ++i)
    out_nodes[i].children = {-1, i + 1 < length ? static_cast<std::int32_t>(i + 1) : -1};
}

TEST(BspTrees, AsDeepAsAllowedAndNoDeeper) {
  Bsp bsp = test::make_cube_room();
  bsp.models.resize(1);
  make_chain(bsp.nodes, kBspMaxTreeDepth);
  make_chain(bsp.clipnodes, kBspMaxTreeDepth);
  EXPECT_FALSE(find_fault(bsp).has_value());

  make_chain(bsp.nodes, kBspMaxTreeDepth + 1);
  auto fault = find_fault(bsp);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->lump, BspLump::kNodes);

  make_chain(bsp.nodes, kBspMaxTreeDepth);
  make_chain(bsp.clipnodes, kBspMaxTreeDepth + 1);
  fault = find_fault(bsp);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->lump, BspLump::kClipnodes);
}

// The long path is reached only after its parts were walked from other heads, the deepest first.
TEST(BspTrees, DepthOfSharedClipnodesAddsUp) {
  Bsp bsp = test::make_cube_room();
  make_chain(bsp.clipnodes, kBspMaxTreeDepth + 1);
  bsp.models.resize(1);
  bsp.models[0].head_nodes = {0, 1500, 700, 0};
  ASSERT_TRUE(find_fault(bsp).has_value());
  bsp.models[0].head_nodes[3] = 1;
  EXPECT_FALSE(find_fault(bsp).has_value());
}

TEST(BspTrees, ClipnodesMayBeShared) {
  Bsp bsp = test::make_cube_room();
  // Both children of every clipnode are the next one: 2^60 paths, which the check must not walk one by one.
  bsp.clipnodes.assign(60, {});
  for (std::size_t i = 0; i < 60; ++i) {
    const std::int32_t next = i + 1 < 60 ? static_cast<std::int32_t>(i + 1) : -1;
    bsp.clipnodes[i].children = {next, next};
  }
  EXPECT_FALSE(find_fault(bsp).has_value());
}

TEST(BspTrees, ModelsMayShareAWholeTree) {
  Bsp bsp = test::make_cube_room();
  bsp.models[1].head_nodes[0] = bsp.models[0].head_nodes[0];
  EXPECT_FALSE(find_fault(bsp).has_value());
}

TEST(BspTrees, ALevelMayBeOneLeaf) {
  Bsp bsp = test::make_cube_room();
  bsp.nodes.clear();
  for (BspModel& model : bsp.models) model.head_nodes = {-2, -1, -1, -1};
  EXPECT_FALSE(find_fault(bsp).has_value());
}

TEST(BspPlanes, TypesMustFitNormals) {
  Bsp bsp = test::make_cube_room();
  bsp.planes[1].type = 2;
  EXPECT_EQ(find_fault(bsp)->reason, "type 2 does not fit the normal 1 0 0");
  bsp.planes[1] = {{-1, 0, 0}, 0, 0};
  EXPECT_EQ(find_fault(bsp)->reason, "type 0 does not fit the normal -1 0 0");
  bsp.planes[1].type = 3;
  EXPECT_FALSE(find_fault(bsp).has_value());
}

TEST(BspTextures, BuiltInCodeAreCheckedToo) {
  Bsp bsp = test::make_cube_room();
  bsp.miptexes[0].mips[2].pop_back();
  EXPECT_EQ(find_fault(bsp)->reason, "mip level 2 has 15 texels");
  bsp = test::make_cube_room();
  bsp.miptexes[1].width = 16;
  EXPECT_EQ(find_fault(bsp)->reason, "the texture is marked absent but not empty");
}

}  // namespace
}  // namespace temblor::formats
