// Level files that are truncated, damaged, or hostile give an error, and never take more time or memory than
// their size justifies.
#include <gtest/gtest.h>

#include "formats/levels/bsp.h"
#include "formats/levels/cube_room.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

constexpr std::array kBadVersions{BspVersion::k29, BspVersion::k2Psb, BspVersion::kBsp2, BspVersion::k30};

template <typename T>
void poke(base::ByteVector& io_file, std::size_t offset, T value) {
  ASSERT_LE(offset + sizeof(T), io_file.size());
  std::memcpy(io_file.data() + offset, &value, sizeof(T));
}

std::size_t lump_entry(BspLump lump) {
  return 4 + 8 * static_cast<std::size_t>(lump);
}
std::uint32_t read_lump_offset(base::Bytes file, BspLump lump) {
  base::ByteReader reader(file);
  reader.seek(lump_entry(lump));
  return reader.u32();
}

std::string error_of_bsp(base::Bytes file) {
  const auto bsp = read_bsp(file);
  return bsp.ok() ? "no error" : bsp.error().what;
}

TEST(BspBadBytes, RejectsEveryTruncation) {
  for (const BspVersion version : kBadVersions) {
    const auto file = test::make_cube_room_file(version);
    for (std::size_t size = 0; size < file.size(); ++size) {
      // A block of exactly this size, so that the address sanitizer detects a read past the end.
      const base::ByteVector cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_FALSE(read_bsp(cut).ok()) << version_name(version) << " cut to " << size;
    }
  }
}

TEST(BspBadBytes, TruncatedBspxKeepsWholeLumps) {
  Bsp room = test::make_cube_room();
  const std::size_t lumps_end = write_bsp(room, BspVersion::k29).value().size();
  room.bspx = {{"A", base::ByteVector(6)}, {"B", base::ByteVector(4)}};
  const auto file = write_bsp(room, BspVersion::k29).value();
  for (std::size_t size = lumps_end; size < file.size(); ++size) {
    const base::ByteVector cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    const auto back = read_bsp(cut);
    ASSERT_TRUE(back.ok()) << size << " bytes: " << back.error().message();
    const std::size_t directory_end = lumps_end + 8 + 2 * 32;
    EXPECT_EQ(back->bspx.size(), size < directory_end + 6 ? 0u : size < directory_end + 12 ? 1u : 2u) << size;
  }
}

TEST(BspBadBytes, FlippedBitsFailOrLeaveValidLevel) {
  Bsp room = test::make_cube_room();
  room.bspx = {{"RGBLIGHTING", base::ByteVector(30)}};
  constexpr int kRuns = test::effort(20000, 3000);
  int sound = 0;
  for (int run = 0; run < kRuns; ++run) {
    const BspVersion version = kBadVersions[static_cast<std::size_t>(run) % kBadVersions.size()];
    auto file = write_bsp(room, version).value();
    test::Random random(static_cast<std::uint64_t>(run));
    const std::size_t flips = 1 + random.below(8);
    for (std::size_t i = 0; i < flips; ++i)
      file[random.below(file.size())] ^= static_cast<std::byte>(1u << random.below(8));
    auto bsp = read_bsp(file);
    if (!bsp.ok()) continue;
    bsp->repairs.clear();
    ++sound;
    const auto again = write_bsp(*bsp, bsp->version);
    ASSERT_TRUE(again.ok()) << "seed " << run << ": " << again.error().message();
    const auto back = read_bsp(*again);
    ASSERT_TRUE(back.ok()) << "seed " << run << ": " << back.error().message();
    ASSERT_TRUE(*back == *bsp) << "seed " << run;
  }
  // Texels, light, and text may have any value, so some files must still be valid.
  EXPECT_GT(sound, kRuns / 10);
  EXPECT_LT(sound, kRuns);
}

TEST(BspBadBytes, UnknownVersions) {
  auto file = test::make_cube_room_file(BspVersion::k29);
  const auto message = [&](std::int32_t version) {
    poke(file, 0, version);
    EXPECT_EQ(read_bsp(file).error().code, base::ErrorCode::kUnsupported);
    return error_of_bsp(file);
  };
  EXPECT_EQ(message(28), "not a Quake level: unknown version 28 (known: 29, 30, 2PSB, BSP2)");
  EXPECT_EQ(message(0x20343651), "version \"Q64 \": Quake 64 levels are not supported");
}

bool may_be_cut(BspLump lump) {
  return lump == BspLump::kEntities || lump == BspLump::kTextures || lump == BspLump::kVisibility ||
         lump == BspLump::kLighting;
}

TEST(BspBadBytes, RecordsOutsideTheFile) {
  for (std::size_t i = 0; i < kBspLumpCount; ++i) {
    const auto lump = static_cast<BspLump>(i);
    if (may_be_cut(lump)) continue;
    for (const std::uint32_t number : {0x7fffffffu, 0x80000000u, 0xffffffffu}) {
      auto file = test::make_cube_room_file(BspVersion::k29);
      poke(file, lump_entry(lump), number);
      EXPECT_NE(error_of_bsp(file).find("past the end of the file"), std::string::npos) << error_of_bsp(file);
      file = test::make_cube_room_file(BspVersion::k29);
      poke(file, lump_entry(lump) + 4, number);
      EXPECT_NE(error_of_bsp(file).find("past the end of the file"), std::string::npos) << error_of_bsp(file);
    }
  }
}

// The walls and the tree stay. Other engines enter such a level, too.
TEST(BspBadBytes, OtherLumpsAreCutAtTheEndOfTheFile) {
  const auto room = read_bsp(test::make_cube_room_file(BspVersion::k29)).value();
  for (const BspLump lump :
       {BspLump::kEntities, BspLump::kTextures, BspLump::kVisibility, BspLump::kLighting}) {
    for (const std::size_t field : {0u, 4u}) {
      for (const std::uint32_t number : {0x7fffffffu, 0x80000000u, 0xffffffffu}) {
        auto file = test::make_cube_room_file(BspVersion::k29);
        if (lump == BspLump::kVisibility) poke(file, lump_entry(lump) + 4, 1u);  // the room's is empty
        poke(file, lump_entry(lump) + field, number);
        const auto back = read_bsp(file);
        ASSERT_TRUE(back.ok()) << back.error().message();
        EXPECT_EQ(back->repairs.find(fmt::format("lump {}: ", lump_name(lump))), 0u) << back->repairs;
        EXPECT_NE(back->repairs.find("past the end of the file"), std::string::npos) << back->repairs;
        EXPECT_EQ(back->vertices, room.vertices);
        EXPECT_EQ(back->nodes, room.nodes);
        EXPECT_EQ(back->clipnodes, room.clipnodes);
        EXPECT_EQ(back->models.size(), room.models.size());
      }
    }
  }
}

// Stock compilers write the textures last, so an incomplete download lacks some of them.
TEST(BspBadBytes, TexturesThatEndEarlyAreMissing) {
  const auto room = read_bsp(test::make_cube_room_file(BspVersion::k29)).value();
  auto file = test::make_cube_room_file(BspVersion::k29);
  base::ByteReader entry(file);
  entry.seek(lump_entry(BspLump::kTextures));
  const std::uint32_t offset = entry.u32(), size = entry.u32();
  poke(file, lump_entry(BspLump::kTextures), static_cast<std::uint32_t>(file.size()));
  const base::ByteVector lump(file.begin() + offset, file.begin() + offset + size);
  file.insert(file.end(), lump.begin(), lump.end());
  EXPECT_EQ(read_bsp(file).value(), room);
  for (std::size_t missing = 1; missing <= size; ++missing) {
    const base::ByteVector cut(file.begin(), file.end() - static_cast<std::ptrdiff_t>(missing));
    const auto back = read_bsp(cut);
    ASSERT_TRUE(back.ok()) << missing << ": " << back.error().message();
    EXPECT_EQ(back->repairs.find("lump textures: "), 0u) << back->repairs;
    EXPECT_EQ(back->faces, room.faces);
  }
}

TEST(BspBadBytes, RejectsPartialRecords) {
  auto file = test::make_cube_room_file(BspVersion::k29);
  poke(file, lump_entry(BspLump::kFaces) + 4, std::uint32_t{119});
  EXPECT_EQ(error_of_bsp(file),
            fmt::format("lump faces: 119 bytes at offset {:#x} are not a whole number of 20-byte records",
                        read_lump_offset(file, BspLump::kFaces)));
}

TEST(BspBadBytes, LumpsMadeOfTheSameBytes) {
  auto file = test::make_cube_room_file(BspVersion::k29);
  const auto room = read_bsp(file).value();
  const auto size = static_cast<std::uint32_t>(file.size());
  for (const BspLump lump :
       {BspLump::kLighting, BspLump::kVisibility, BspLump::kTextures, BspLump::kEntities}) {
    poke(file, lump_entry(lump), std::uint32_t{0});
    poke(file, lump_entry(lump) + 4, size);
  }
  const auto back = read_bsp(file);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->lighting.size(), size);
  EXPECT_EQ(back->visibility.size(), size);
  EXPECT_EQ(back->nodes, room.nodes);
}

// The textures that the table still lists are kept; the numbers after it are no headers.
TEST(BspBadBytes, TextureCounts) {
  const Bsp room = read_bsp(test::make_cube_room_file(BspVersion::k29)).value();
  for (const std::uint32_t count : {0x80000000u, 0xffffffffu, 0x1000u}) {
    auto file = test::make_cube_room_file(BspVersion::k29);
    poke(file, read_lump_offset(file, BspLump::kTextures), count);
    const auto back = read_bsp(file);
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_GT(back->miptexes.size(), room.miptexes.size());
    EXPECT_EQ(back->miptexes[0], room.miptexes[0]);
  }
}

// Faces with such a texture are drawn as a checkerboard.
TEST(BspBadBytes, DamagedTexturesHaveNoTexels) {
  const auto clean = test::make_cube_room_file(BspVersion::k29);
  const std::uint32_t lump = read_lump_offset(clean, BspLump::kTextures);
  const std::uint32_t texture = 16;  // the first, after the count and three offsets
  const auto texture_with = [&](std::size_t offset_in_lump, std::uint32_t value) {
    auto file = clean;
    poke(file, lump + offset_in_lump, value);
    const auto back = read_bsp(file);
    EXPECT_TRUE(back.ok()) << back.error().message();
    return back.ok() ? back->miptexes[0] : BspMiptex{};
  };
  const auto without_texels = [](std::uint32_t width, std::uint32_t height) {
    return BspMiptex{true, "wall", width, height, {}};
  };
  for (const std::size_t side : {texture + 16, texture + 20})
    for (const std::uint32_t size : {0u, 1u << 20, 0x80000000u})
      EXPECT_EQ(texture_with(side, size), without_texels(16, 16)) << size;
  EXPECT_EQ(texture_with(texture + 16, 16384), without_texels(16384, 16));
  EXPECT_EQ(texture_with(texture + 24, 0xffffffffu), without_texels(16, 16));
  EXPECT_EQ(texture_with(texture + 24, 39), without_texels(16, 16));
  // Without a header, there is not even a name.
  EXPECT_EQ(texture_with(4, 0x7fffffff), BspMiptex{});
  EXPECT_EQ(texture_with(4, 0xfffffffe), BspMiptex{});
}

// Other engines compute smaller mip levels from the largest.
TEST(BspBadBytes, DamagedMipLevelsAreSampled) {
  const auto clean = test::make_cube_room_file(BspVersion::k29);
  const Bsp room = read_bsp(clean).value();
  const std::uint32_t texture = read_lump_offset(clean, BspLump::kTextures) + 16;
  for (const std::uint32_t offset : {0u, 39u, 0x7fffffffu, 0xffffffffu}) {
    auto file = clean;
    poke(file, texture + 28, offset);
    const auto back = read_bsp(file);
    ASSERT_TRUE(back.ok()) << back.error().message();
    Bsp expected = room;
    auto& mips = expected.miptexes[0].mips;
    for (std::size_t y = 0; y < 8; ++y)
      for (std::size_t x = 0; x < 8; ++x) mips[1][8 * y + x] = mips[0][16 * 2 * y + 2 * x];
    EXPECT_EQ(*back, expected) << offset;
  }
}

// A table of 100,000 entries that all refer to one texture of 1 MB would need 130 GB.
TEST(BspBadBytes, ManyTexturesOfTheSameBytes) {
  constexpr std::uint32_t kTextures = 100000;
  constexpr std::uint32_t kTexture = 4 + 4 * kTextures;
  base::ByteWriter lump;
  lump.u32(kTextures);
  for (std::uint32_t i = 0; i < kTextures; ++i) lump.u32(kTexture);
  lump.fixed_text("big", 16);
  for (const std::uint32_t number : {1024u, 1024u, 40u, 40u, 40u, 40u}) lump.u32(number);
  lump.fixed_text("", 1024 * 1024);

  auto file = test::make_cube_room_file(BspVersion::k29);
  poke(file, lump_entry(BspLump::kTextures), static_cast<std::uint32_t>(file.size()));
  poke(file, lump_entry(BspLump::kTextures) + 4, static_cast<std::uint32_t>(lump.size()));
  file.insert(file.end(), lump.view().begin(), lump.view().end());
  const auto back = read_bsp(file);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(back->miptexes[0].mips[0].size(), 1024u * 1024);
  for (std::size_t i = 1; i < back->miptexes.size(); ++i)
    ASSERT_TRUE(back->miptexes[i].mips[0].empty()) << "texture " << i;
}

// Only other programs use most of these lumps.
TEST(BspBadBytes, DamagedBspxLumpsAreLeftOut) {
  const auto room = test::make_cube_room_file(BspVersion::k29);
  const auto sizes_with = [&](std::uint32_t count, std::uint32_t offset, std::uint32_t size) {
    base::ByteWriter file;
    file.bytes(room);
    file.align(4);
    file.bytes(base::as_bytes("BSPX"));
    file.u32(count);
    for (const auto& [lump_offset, lump_size] : {std::pair(offset, size), {0u, 10u}}) {
      file.fixed_text("LUMP", 24);
      file.u32(lump_offset);
      file.u32(lump_size);
    }
    const auto back = read_bsp(file.view());
    EXPECT_TRUE(back.ok()) << back.error().message();
    std::vector<std::size_t> sizes;
    if (back.ok())
      for (const BspxLump& lump : back->bspx) sizes.push_back(lump.data.size());
    return sizes;
  };
  using Sizes = std::vector<std::size_t>;
  const auto all = static_cast<std::uint32_t>(room.size());
  EXPECT_EQ(sizes_with(2, 0, 20), (Sizes{20, 10}));
  EXPECT_EQ(sizes_with(3, 0, 20), Sizes{});
  EXPECT_EQ(sizes_with(0x80000000u, 0, 20), Sizes{});
  EXPECT_EQ(sizes_with(2, 0xffffffffu, 20), Sizes{10});
  EXPECT_EQ(sizes_with(2, 20, 0xffffffffu), Sizes{10});
  // The second one would exceed the size of the file.
  EXPECT_EQ(sizes_with(2, 0, all + 70), Sizes{all + 70});
}

}  // namespace
}  // namespace temblor::formats
