// Levels that no engine can play are rejected with an exact error, in every version.
#include <gtest/gtest.h>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"
#include "formats/levels/cube_room.h"

namespace temblor::formats {
namespace {

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

// Other damage is repaired (bsp_repair_test.cpp).
const Case kFaults[] = {
    {"ClipnodePlane", DAMAGE(b.clipnodes[3].plane = 6),
     "lump clipnodes: clipnode 3: plane 6 is past the end (6)"},
    {"WorldHead", DAMAGE(b.models[0].head_nodes[0] = 7),
     "lump models: model 0: head 7 of hull 0 is neither one of 7 nodes nor of 2 leaves"},
    {"WorldClipHead", DAMAGE(b.models[0].head_nodes[1] = 99999),
     "lump models: model 0: head 99999 of hull 1 is neither one of 6 clipnodes nor contents"},
    {"NoModels", DAMAGE(b.models.clear()), "lump models: model 0 (the world) is missing"},
    {"NoLeaves", DAMAGE(b.leaves.clear()), "lump leaves: leaf 0 (solid) is missing"},
    {"ClipnodeCycle", DAMAGE(b.clipnodes[5].children[0] = 2),
     "lump clipnodes: clipnode 2: a path from it comes back to it"},
    {"ClipnodeItsOwnChild", DAMAGE(b.clipnodes[5].children[1] = 5),
     "lump clipnodes: clipnode 5: a path from it comes back to it"},
};

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Faults, RejectedBsp, testing::ValuesIn(kFaults), case_name);

TEST(RejectedBspOffset, NamesTheRecordsOffsetInTheFile) {
  Bsp bsp = test::make_cube_room();
  bsp.clipnodes[2].plane = 9;
  for (const auto& [version, clipnode_bytes] : {std::pair(BspVersion::k29, 8u), {BspVersion::kBsp2, 12u}}) {
    const auto file = write_bsp(bsp, version).value();
    base::ByteReader header(file);
    header.seek(4 + 8 * 9);
    const std::uint32_t offset = header.u32() + 2 * clipnode_bytes;
    EXPECT_EQ(read_bsp(file).error().what,
              fmt::format("lump clipnodes: clipnode 2 at offset {:#x}: plane 9 is past the end (6)", offset));
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
