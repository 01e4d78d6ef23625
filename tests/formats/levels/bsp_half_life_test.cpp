// Version 30, compared with its published description: colored light, palettes, and swapped lumps.
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/levels/bsp.h"
#include "formats/levels/cube_room.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

std::size_t find_header_entry(BspLump lump) {
  return 4 + 8 * static_cast<std::size_t>(lump);
}
// The place of a lump, from the description of the header.
struct Place {
  std::uint32_t offset, size;
};
Place find_lump_place(base::Bytes file, BspLump lump) {
  base::ByteReader reader(file);
  reader.seek(find_header_entry(lump));
  const std::uint32_t offset = reader.u32();
  return {offset, reader.u32()};
}
void poke_u32(base::ByteVector& io_file, std::size_t offset, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) io_file[offset + i] = std::byte(value >> (8 * i) & 255);
}

// The cube room with colored light and a palette of three colors, in the form that read_bsp() returns: gray
// samples that have the brightness of the colors.
Bsp make_colored_room(test::Random& io_random) {
  Bsp bsp = test::make_cube_room();
  bsp.version = BspVersion::k30;
  base::ByteVector colors;
  for (std::uint8_t& gray : bsp.lighting) {
    std::array<unsigned, 3> color{};
    for (unsigned& part : color)
      colors.push_back(std::byte(part = static_cast<unsigned>(io_random.below(256))));
    gray = static_cast<std::uint8_t>((77 * color[0] + 150 * color[1] + 29 * color[2]) >> 8);
  }
  bsp.bspx = {{"RGBLIGHTING", colors}};
  const std::size_t count = io_random.below(257);
  for (std::size_t i = 0; i < count; ++i)
    bsp.miptexes[0].palette.push_back({static_cast<std::uint8_t>(i), 7, static_cast<std::uint8_t>(255 - i)});
  return bsp;
}

TEST(BspHalfLife, WhatIsWrittenReadsBackEqual) {
  for (int seed = 0; seed < test::effort(200, 20); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const Bsp bsp = make_colored_room(random);
    const auto back = read_bsp(write_bsp(bsp, BspVersion::k30).value());
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_TRUE(*back == bsp) << "seed " << seed;
  }
}

TEST(BspHalfLife, LightHasThreeBytesForEachSample) {
  test::Random random(1);
  const Bsp bsp = make_colored_room(random);
  const base::ByteVector file = write_bsp(bsp, BspVersion::k30).value();
  const Place light = find_lump_place(file, BspLump::kLighting),
              faces = find_lump_place(file, BspLump::kFaces);
  EXPECT_TRUE(std::ranges::equal(base::Bytes(file).subspan(light.offset, light.size), bsp.bspx[0].data));
  base::ByteReader reader(file);
  for (std::size_t i = 0; i < bsp.faces.size(); ++i) {
    reader.seek(faces.offset + 20 * i + 16);
    EXPECT_EQ(reader.i32(), 3 * bsp.faces[i].light_offset);
  }
}

TEST(BspHalfLife, GrayLightBecomesThreeEqualBytes) {
  const Bsp gray = test::make_cube_room();
  const auto back = read_bsp(write_bsp(gray, BspVersion::k30).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->lighting, gray.lighting);
  ASSERT_NE(back->find_bspx("RGBLIGHTING"), nullptr);
  for (std::size_t i = 0; i < gray.lighting.size() * 3; ++i)
    EXPECT_EQ(back->bspx[0].data[i], std::byte{gray.lighting[i / 3]});
}

TEST(BspHalfLife, FaceWithAnOffsetBetweenTwoColorsIsDark) {
  base::ByteVector file = test::make_cube_room_file(BspVersion::k30);
  const Place faces = find_lump_place(file, BspLump::kFaces);
  poke_u32(file, faces.offset + 20 + 16, 4);
  const auto back = read_bsp(file);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->faces[1].light_offset, -1);
  EXPECT_EQ(back->faces[2].light_offset, test::make_cube_room().faces[2].light_offset);
}

TEST(BspHalfLife, LightOffsetThatDoesNotFitIsAnError) {
  Bsp bsp = test::make_cube_room();
  bsp.faces[4].light_offset = 1 << 30;
  const auto written = write_bsp(bsp, BspVersion::k30);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().message(), "lump faces: face 4: light offset 1073741824 does not fit version 30");
}

// An expansion stores planes in the first lump and entities in the second.
TEST(BspHalfLife, PlanesMayComeBeforeEntities) {
  const base::ByteVector file = test::make_cube_room_file(BspVersion::k30);
  base::ByteVector swapped = file;
  const Place entities = find_lump_place(file, BspLump::kEntities),
              planes = find_lump_place(file, BspLump::kPlanes);
  poke_u32(swapped, find_header_entry(BspLump::kEntities), planes.offset);
  poke_u32(swapped, find_header_entry(BspLump::kEntities) + 4, planes.size);
  poke_u32(swapped, find_header_entry(BspLump::kPlanes), entities.offset);
  poke_u32(swapped, find_header_entry(BspLump::kPlanes) + 4, entities.size);
  const auto back = read_bsp(swapped);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_TRUE(*back == *read_bsp(file));
}

// The palette follows mip 3, where the published description has it.
TEST(BspHalfLife, PaletteFollowsTheSmallestMipLevel) {
  test::Random random(3);
  Bsp bsp = make_colored_room(random);
  bsp.miptexes[0].palette = {{1, 2, 3}, {4, 5, 6}};
  const base::ByteVector file = write_bsp(bsp, BspVersion::k30).value();
  base::ByteReader reader(file);
  const std::size_t lump = find_lump_place(file, BspLump::kTextures).offset;
  reader.seek(lump + 4);
  const std::size_t texture = lump + reader.u32();
  reader.seek(texture + 40 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2);
  EXPECT_EQ(reader.u16(), 2);
  for (int i = 1; i <= 6; ++i) EXPECT_EQ(reader.u8(), i);
}

TEST(BspHalfLife, PaletteThatIsNotInTheLumpIsLeftOut) {
  Bsp bsp = test::make_cube_room();
  bsp.miptexes.resize(1);
  bsp.miptexes[0].palette.assign(256, {9, 9, 9});
  const base::ByteVector file = write_bsp(bsp, BspVersion::k30).value();
  const Place textures = find_lump_place(file, BspLump::kTextures);
  const std::size_t count = textures.offset + textures.size - 3 * 256 - 2;
  for (const std::uint32_t wrong : {257u, 0xffffu}) {
    base::ByteVector damaged = file;
    damaged[count] = std::byte(wrong & 255);
    damaged[count + 1] = std::byte(wrong >> 8);
    const auto back = read_bsp(damaged);
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_TRUE(back->miptexes[0].palette.empty());
    EXPECT_EQ(back->miptexes[0].mips, bsp.miptexes[0].mips);
  }
  base::ByteVector cut = file;
  for (const std::uint32_t missing : {1u, 700u, 769u, 770u}) {
    poke_u32(cut, find_header_entry(BspLump::kTextures) + 4, textures.size - missing);
    const auto back = read_bsp(cut);
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_TRUE(back->miptexes[0].palette.empty()) << missing;
    EXPECT_EQ(back->miptexes[0].mips, bsp.miptexes[0].mips);
  }
}

TEST(BspHalfLife, OtherVersionsHaveNoPalettes) {
  test::Random random(4);
  Bsp bsp = make_colored_room(random);
  const auto back = read_bsp(write_bsp(bsp, BspVersion::kBsp2).value());
  ASSERT_TRUE(back.ok()) << back.error().message();
  bsp.version = BspVersion::kBsp2;
  bsp.miptexes[0].palette.clear();
  EXPECT_TRUE(*back == bsp);
}

}  // namespace
}  // namespace temblor::formats
