// A level written in any of the three versions reads back as the same level.
#include <gtest/gtest.h>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"
#include "formats/levels/cube_room.h"
#include "support/game_data.h"

namespace temblor::formats {
namespace {

constexpr std::array kVersions{BspVersion::k29, BspVersion::k2Psb, BspVersion::kBsp2};

void expect_round_trip(Bsp bsp, BspVersion version) {
  bsp.version = version;
  const auto file = write_bsp(bsp, version);
  ASSERT_TRUE(file.ok()) << file.error().message();
  const auto back = read_bsp(*file);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_TRUE(*back == bsp) << version_name(version);
}

void expect_too_large(const Bsp& bsp, BspVersion version, std::string_view what) {
  const auto file = write_bsp(bsp, version);
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.error().code, base::ErrorCode::kTooLarge);
  EXPECT_EQ(file.error().what, what);
}

TEST(BspRoundTrip, CubeRoom) {
  for (const BspVersion version : kVersions) expect_round_trip(test::make_cube_room(), version);
}

TEST(BspRoundTrip, Bspx) {
  Bsp bsp = test::make_cube_room();
  bsp.bspx = {{"RGBLIGHTING", base::ByteVector(3 * bsp.lighting.size(), std::byte{200})},
              {"EMPTY", {}},
              {"A_NAME_OF_24_CHARACTERS.", base::ByteVector(1)}};
  for (const BspVersion version : kVersions) expect_round_trip(bsp, version);
  ASSERT_NE(bsp.find_bspx("EMPTY"), nullptr);
  EXPECT_EQ(bsp.find_bspx("RGBLIGHTING"), &bsp.bspx[0]);
  EXPECT_EQ(bsp.find_bspx("LMSHIFT"), nullptr);

  bsp.bspx[1].name = "A_NAME_OF_25_CHARACTERS..";
  expect_too_large(bsp, BspVersion::k29,
                   "BSPX: the name \"A_NAME_OF_25_CHARACTERS..\" is longer than 24 characters");
}

TEST(BspRoundTrip, BytesAfterTheLumpsAreNotBspxUnlessMarked) {
  auto file = test::make_cube_room_file(BspVersion::k29);
  for (const char c : std::string_view("made by a compiler")) file.push_back(static_cast<std::byte>(c));
  const auto bsp = read_bsp(file);
  ASSERT_TRUE(bsp.ok()) << bsp.error().message();
  EXPECT_TRUE(*bsp == test::make_cube_room());
}

TEST(BspRoundTrip, StockLevelsThroughAllVersions) {
  DATA_FOLDER_OR_SKIP(data);
  int levels = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "maps")) {
    if (entry.path().extension() != ".bsp") continue;
    SCOPED_TRACE(entry.path().filename());
    const auto stock = read_bsp(test::read_file(entry.path()));
    ASSERT_TRUE(stock.ok()) << stock.error().message();
    Bsp bsp = *stock;
    for (const BspVersion version : {BspVersion::kBsp2, BspVersion::k2Psb, BspVersion::k29}) {
      auto next = read_bsp(write_bsp(bsp, version).value());
      ASSERT_TRUE(next.ok()) << next.error().message();
      EXPECT_EQ(next->version, version);
      bsp = std::move(next).value();
    }
    EXPECT_TRUE(bsp == *stock);
    ++levels;
  }
  EXPECT_GT(levels, 0);
}

TEST(BspRoundTrip, RoundsIntegerBoundsOutward) {
  Bsp bsp = test::make_cube_room();
  bsp.leaves[1].mins = {-1.5f, 1.5f, -3};
  bsp.leaves[1].maxs = {-1.5f, 1.5f, 3};
  for (const BspVersion version : {BspVersion::k29, BspVersion::k2Psb}) {
    const auto back = read_bsp(write_bsp(bsp, version).value());
    EXPECT_EQ(back->leaves[1].mins, math::Vec3(-2, 1, -3));
    EXPECT_EQ(back->leaves[1].maxs, math::Vec3(-1, 2, 3));
  }
  const auto exact = read_bsp(write_bsp(bsp, BspVersion::kBsp2).value());
  EXPECT_EQ(exact->leaves[1].mins, bsp.leaves[1].mins);
  EXPECT_EQ(exact->leaves[1].maxs, bsp.leaves[1].maxs);
}

TEST(BspRoundTrip, ClampsHugeBounds) {
  Bsp bsp = test::make_cube_room();
  bsp.leaves[0].mins = math::Vec3(std::numeric_limits<float>::max());
  bsp.leaves[0].maxs = math::Vec3(-std::numeric_limits<float>::infinity());
  const auto back = read_bsp(write_bsp(bsp, BspVersion::kBsp2).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->leaves[0].mins, math::Vec3(kBspMaxCoordinate));
  EXPECT_EQ(back->leaves[0].maxs, math::Vec3(-kBspMaxCoordinate));
}

TEST(BspRoundTrip, PlanesThatAreNotAxialLoseTheirAxialType) {
  Bsp bsp = test::make_cube_room();
  bsp.planes[0].normal = {-1, 0, 0};
  bsp.planes[1] = {{0.6f, 0, -0.8f}, 3, 1};
  const auto back = read_bsp(write_bsp(bsp, BspVersion::k29).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->planes[0].type, 3);
  EXPECT_EQ(back->planes[1].type, 5);
  EXPECT_EQ(back->planes[2].type, 1);
}

TEST(BspRoundTrip, WithoutVisibilityOffsetsMeanNothing) {
  Bsp bsp = test::make_cube_room();
  bsp.visibility.clear();
  bsp.leaves[1].visibility_offset = 0;
  const auto back = read_bsp(write_bsp(bsp, BspVersion::k29).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->leaves[1].visibility_offset, -1);
}

TEST(BspRoundTrip, WithoutClipnodesNothingBlocks) {
  Bsp bsp = test::make_cube_room();
  bsp.clipnodes.clear();
  const auto back = read_bsp(write_bsp(bsp, BspVersion::k29).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->models[0].head_nodes, (std::array<std::int32_t, 4>{0, -1, -1, -1}));
}

TEST(BspRoundTrip, EntityTextEndsAtItsFirstZero) {
  Bsp bsp = test::make_cube_room();
  bsp.entities = std::string("{}\0junk", 7);
  EXPECT_EQ(read_bsp(write_bsp(bsp, BspVersion::k29).value())->entities, "{}");
}

TEST(BspRoundTrip, TextureNamesFillTheirField) {
  Bsp bsp = test::make_cube_room();
  bsp.miptexes[0].name = "fifteen_letters";
  expect_round_trip(bsp, BspVersion::k29);
  bsp.miptexes[0].name = "sixteen__letters";
  expect_too_large(bsp, BspVersion::k29,
                   "lump textures: texture 0: its name \"sixteen__letters\" is longer than 15 characters");
}

TEST(BspRoundTrip, TexturesOfAnySize) {
  Bsp bsp = test::make_cube_room();
  for (const auto& [width, height] : {std::pair(1u, 1u), {3u, 40u}, {100u, 7u}}) {
    BspMiptex texture{true, "odd", width, height, {}};
    for (std::size_t mip = 0; mip < 4; ++mip)
      texture.mips[mip].assign(std::size_t{width >> mip} * (height >> mip), 77);
    bsp.miptexes.push_back(texture);
  }
  expect_round_trip(bsp, BspVersion::k29);
}

// 16-bit children allow as many nodes as there are numbers, minus those that leaves need.
TEST(BspRoundTrip, Version29HoldsMoreThan32767Clipnodes) {
  Bsp bsp = test::make_cube_room();
  bsp.clipnodes.resize(65000, {0, {-2, -1}});
  bsp.clipnodes[0].children = {64999, -2};
  expect_round_trip(bsp, BspVersion::k29);

  bsp.clipnodes.resize(65535, {0, {-2, -1}});  // -2 would read as 65534, a clipnode
  expect_too_large(bsp, BspVersion::k29, "lump clipnodes: clipnode 0: child -2 does not fit version 29");
  expect_round_trip(bsp, BspVersion::kBsp2);
}

TEST(BspRoundTrip, NamesFieldThatDoesNotFitVersion29) {
  Bsp bsp = test::make_cube_room();
  bsp.vertices.resize(70000);
  bsp.edges[3].vertices[1] = 65536;
  expect_too_large(bsp, BspVersion::k29, "lump edges: edge 3: vertex 65536 does not fit version 29");

  bsp = test::make_cube_room();
  bsp.nodes[2].maxs.y = 32767.5f;
  expect_too_large(bsp, BspVersion::k2Psb, "lump nodes: node 2: maxs 32768 does not fit version 2PSB");
  expect_round_trip(bsp, BspVersion::kBsp2);
}

}  // namespace
}  // namespace temblor::formats
