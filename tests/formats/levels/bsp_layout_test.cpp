// Compares the layout of level files with the published table of offsets and widths, and with stock files.
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/levels/bsp.h"
#include "formats/levels/cube_room.h"
#include "support/game_data.h"

namespace temblor::formats {
namespace {

constexpr std::array kAllVersions{BspVersion::k29, BspVersion::k2Psb, BspVersion::kBsp2, BspVersion::k30};

// A lump of a file, found from the description of the header, without our reader.
base::Bytes slice_lump(base::Bytes file, BspLump lump) {
  base::ByteReader header(file);
  header.seek(4 + 8 * static_cast<std::size_t>(lump));
  const std::uint32_t offset = header.u32(), size = header.u32();
  return file.subspan(offset, size);
}

struct LumpSize {
  BspLump lump;
  std::size_t records;
  std::array<std::size_t, 4> record_bytes;  // in 29, 2PSB, BSP2, 30
};

TEST(BspLayout, RecordsHaveThePublishedSizes) {
  const Bsp room = test::make_cube_room();
  const LumpSize sizes[] = {
      {BspLump::kPlanes, room.planes.size(), {20, 20, 20, 20}},
      {BspLump::kVertices, room.vertices.size(), {12, 12, 12, 12}},
      {BspLump::kNodes, room.nodes.size(), {24, 32, 44, 24}},
      {BspLump::kTexinfo, room.texinfos.size(), {40, 40, 40, 40}},
      {BspLump::kFaces, room.faces.size(), {20, 28, 28, 20}},
      {BspLump::kClipnodes, room.clipnodes.size(), {8, 12, 12, 8}},
      {BspLump::kLeaves, room.leaves.size(), {28, 32, 44, 28}},
      {BspLump::kMarksurfaces, room.marksurfaces.size(), {2, 4, 4, 2}},
      {BspLump::kEdges, room.edges.size(), {4, 8, 8, 4}},
      {BspLump::kSurfedges, room.surfedges.size(), {4, 4, 4, 4}},
      {BspLump::kModels, room.models.size(), {64, 64, 64, 64}},
      {BspLump::kLighting, room.lighting.size(), {1, 1, 1, 3}},
      {BspLump::kVisibility, room.visibility.size(), {1, 1, 1, 1}},
  };
  for (std::size_t version = 0; version < kAllVersions.size(); ++version) {
    const auto file = test::make_cube_room_file(kAllVersions[version]);
    for (const LumpSize& size : sizes)
      EXPECT_EQ(slice_lump(file, size.lump).size(), size.records * size.record_bytes[version])
          << lump_name(size.lump) << " in " << version_name(kAllVersions[version]);
  }
}

TEST(BspLayout, VersionWords) {
  const auto word = [](BspVersion version) {
    const auto file = test::make_cube_room_file(version);
    return std::string(base::as_text(base::Bytes(file).first(4)));
  };
  EXPECT_EQ(word(BspVersion::k29), std::string("\x1d\0\0\0", 4));
  EXPECT_EQ(word(BspVersion::k2Psb), "2PSB");
  EXPECT_EQ(word(BspVersion::kBsp2), "BSP2");
  EXPECT_EQ(word(BspVersion::k30), std::string("\x1e\0\0\0", 4));
}

// Each field of a record gets a unique value, and must be at its published offset.
TEST(BspLayout, NodeFieldsInEachVersion) {
  Bsp bsp = test::make_cube_room();
  bsp.nodes[5] = {3, {-2, 4}, {-10.5f, 2, 3}, {4, 5, 6.25f}, 1, 2};

  const auto file_29 = write_bsp(bsp, BspVersion::k29).value();
  base::ByteReader small(slice_lump(file_29, BspLump::kNodes).subspan(5 * 24));
  EXPECT_EQ(small.i32(), 3);
  EXPECT_EQ(small.i16(), -2);
  EXPECT_EQ(small.i16(), 4);
  for (const int bound : {-11, 2, 3, 4, 5, 7}) EXPECT_EQ(small.i16(), bound);
  EXPECT_EQ(small.u16(), 1);
  EXPECT_EQ(small.u16(), 2);

  const auto file_2psb = write_bsp(bsp, BspVersion::k2Psb).value();
  base::ByteReader middle(slice_lump(file_2psb, BspLump::kNodes).subspan(5 * 32));
  for (const int number : {3, -2, 4}) EXPECT_EQ(middle.i32(), number);
  for (const int bound : {-11, 2, 3, 4, 5, 7}) EXPECT_EQ(middle.i16(), bound);
  for (const std::uint32_t number : {1u, 2u}) EXPECT_EQ(middle.u32(), number);

  const auto file_bsp2 = write_bsp(bsp, BspVersion::kBsp2).value();
  base::ByteReader large(slice_lump(file_bsp2, BspLump::kNodes).subspan(5 * 44));
  for (const int number : {3, -2, 4}) EXPECT_EQ(large.i32(), number);
  for (const float bound : {-10.5f, 2.0f, 3.0f, 4.0f, 5.0f, 6.25f}) EXPECT_EQ(large.f32(), bound);
  for (const std::uint32_t number : {1u, 2u}) EXPECT_EQ(large.u32(), number);
}

TEST(BspLayout, FaceFieldsInEachVersion) {
  Bsp bsp = test::make_cube_room();
  bsp.faces[1] = {4, 1, 70000, 5, 2, {6, 7, 8, 9}, 80000};

  const auto file_29 = write_bsp(bsp, BspVersion::k29).value();
  base::ByteReader small(slice_lump(file_29, BspLump::kFaces).subspan(20));
  EXPECT_EQ(small.i16(), 4);
  EXPECT_EQ(small.i16(), 1);
  EXPECT_EQ(small.i32(), 70000);
  EXPECT_EQ(small.i16(), 5);
  EXPECT_EQ(small.i16(), 2);
  for (const int style : {6, 7, 8, 9}) EXPECT_EQ(small.u8(), style);
  EXPECT_EQ(small.i32(), 80000);

  for (const BspVersion version : {BspVersion::k2Psb, BspVersion::kBsp2}) {
    const auto file = write_bsp(bsp, version).value();
    base::ByteReader large(slice_lump(file, BspLump::kFaces).subspan(28));
    for (const int number : {4, 1, 70000, 5, 2}) EXPECT_EQ(large.i32(), number);
    for (const int style : {6, 7, 8, 9}) EXPECT_EQ(large.u8(), style);
    EXPECT_EQ(large.i32(), 80000);
  }
}

TEST(BspLayout, LeafAndModelFields) {
  Bsp bsp = test::make_cube_room();
  bsp.leaves[1] = {-3, 17, {1, 2, 3}, {4, 5, 6}, 7, 8, {9, 10, 11, 12}};
  const auto file = write_bsp(bsp, BspVersion::k29).value();
  base::ByteReader leaf(slice_lump(file, BspLump::kLeaves).subspan(28));
  EXPECT_EQ(leaf.i32(), -3);
  EXPECT_EQ(leaf.i32(), 17);
  for (const int number : {1, 2, 3, 4, 5, 6, 7, 8}) EXPECT_EQ(leaf.i16(), number);
  for (const int level : {9, 10, 11, 12}) EXPECT_EQ(leaf.u8(), level);

  base::ByteReader model(slice_lump(file, BspLump::kModels).subspan(64));
  for (const float number : {-64.f, -64.f, -64.f, 64.f, 64.f, 64.f, 8.f, 8.f, 8.f})
    EXPECT_EQ(model.f32(), number);
  for (const int number : {6, -2, -1, 0, 1, 6, 0}) EXPECT_EQ(model.i32(), number);
}

TEST(BspLayout, BspxFollowsTheLumpsAlignedToFourBytes) {
  Bsp bsp = test::make_cube_room();
  const std::size_t lumps_end = write_bsp(bsp, BspVersion::k29).value().size();
  bsp.bspx = {{"RGBLIGHTING", base::ByteVector(7, std::byte{5})}, {"EMPTY", {}}};
  const auto file = write_bsp(bsp, BspVersion::k29).value();

  base::ByteReader reader(file);
  reader.seek((lumps_end + 3) / 4 * 4);
  EXPECT_EQ(base::as_text(reader.take(4)), "BSPX");
  EXPECT_EQ(reader.i32(), 2);
  EXPECT_EQ(reader.fixed_text(24), "RGBLIGHTING");
  const std::uint32_t offset = reader.u32();
  EXPECT_EQ(reader.u32(), 7u);
  EXPECT_EQ(offset % 4, 0u);
  EXPECT_EQ(file[offset], std::byte{5});
  EXPECT_EQ(file[offset + 6], std::byte{5});
}

// Stock files, lump by lump: what we read and write again equals what the level compiler wrote.
TEST(BspLayout, StockLumpsAreWrittenByteForByte) {
  DATA_FOLDER_OR_SKIP(data);
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "maps")) {
    if (entry.path().extension() != ".bsp") continue;
    SCOPED_TRACE(entry.path().filename());
    const base::ByteVector stock = test::read_file(entry.path());
    const auto bsp = read_bsp(stock);
    ASSERT_TRUE(bsp.ok()) << bsp.error().message();
    const auto written = write_bsp(*bsp, BspVersion::k29);
    ASSERT_TRUE(written.ok()) << written.error().message();
    for (std::size_t i = 0; i < kBspLumpCount; ++i) {
      const auto lump = static_cast<BspLump>(i);
      // Without visibility, the stock offset (0) is as meaningless as the -1 that we write.
      if (lump == BspLump::kLeaves && bsp->visibility.empty()) continue;
      EXPECT_TRUE(std::ranges::equal(slice_lump(stock, lump), slice_lump(*written, lump))) << lump_name(lump);
    }
  }
}

}  // namespace
}  // namespace temblor::formats
