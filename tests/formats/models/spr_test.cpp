#include "formats/models/spr.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "support/game_data.h"
#include "support/models/small_models.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kSpriteVersionAt = 4, kSpriteOrientationAt = 8, kSpriteRadiusAt = 12,
                      kSpriteFramesAt = 24, kSpriteBeamAt = 28, kSprHeaderBytes = 36, kFrameAt = 36,
                      kPictureAt = 40;

// A sprite, byte by byte: one frame of 2 x 1 texels.
base::ByteVector smallest_sprite() {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("IDSP"));
  writer.i32(1);
  writer.i32(3);
  writer.f32(4.5f);
  for (const int number : {2, 1, 1}) writer.i32(number);
  writer.f32(5.5f);
  writer.i32(1);
  for (const int number : {0, -1, 7, 2, 1}) writer.i32(number);
  writer.u8(9);
  writer.u8(255);
  return std::move(writer).take();
}

std::string error_of_spr(base::Bytes bytes) {
  const auto spr = read_spr(bytes);
  return spr.ok() ? "no error" : spr.error().what;
}

TEST(Spr, ReadsHandMadeFile) {
  const auto spr = read_spr(smallest_sprite());
  ASSERT_TRUE(spr.ok()) << spr.error().message();
  const Spr expected{SprOrientation::kOriented, 4.5f, 2, 1, 5.5f, true, {{{{-1, 7, 2, 1, {9, 255}}}, {}}}};
  EXPECT_EQ(*spr, expected);
  EXPECT_EQ(write_spr(*spr), smallest_sprite());
}

TEST(Spr, RoundTrips) {
  for (std::uint32_t orientation = 0; orientation < 5; ++orientation) {
    Spr spr = test::small_spr();
    spr.orientation = static_cast<SprOrientation>(orientation);
    const auto back = read_spr(write_spr(spr));
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(*back, spr);
  }
}

TEST(Spr, RejectsEveryTruncationWithOffset) {
  for (const base::ByteVector& sprite : {smallest_sprite(), write_spr(test::small_spr())}) {
    test::for_each_truncation(sprite, [](const base::ByteVector& bytes) {
      const std::string what = error_of_spr(bytes);
      EXPECT_THAT(what, HasSubstr(bytes.size() < kSprHeaderBytes ? "header needs 36 bytes" : "at offset 0x"));
    });
  }
}

TEST(Spr, FaultsOfTheHeader) {
  const base::ByteVector valid = smallest_sprite();
  EXPECT_THAT(error_of_spr(test::with_number(valid, 0, 0)), HasSubstr("not a sprite"));
  EXPECT_THAT(error_of_spr(test::with_number(valid, kSpriteVersionAt, 2)),
              HasSubstr("version 2"));  // Half-Life's
  for (const std::int32_t orientation : {5, 7, -1})
    EXPECT_EQ(read_spr(test::with_number(valid, kSpriteOrientationAt, orientation)).value().orientation,
              SprOrientation::kParallel);
  EXPECT_EQ(error_of_spr(test::with_number(valid, kSpriteFramesAt, 0)), "header at offset 0x18: no frames");
  EXPECT_THAT(error_of_spr(test::with_number(valid, kSpriteFramesAt, 1u << 31)),
              HasSubstr("2147483648 frames"));
  EXPECT_THAT(error_of_spr(test::with_number(valid, kSpriteFramesAt, 2)),
              HasSubstr("frame 1 at offset 0x3a"));
  for (const std::size_t at : {kSpriteRadiusAt, kSpriteBeamAt})
    EXPECT_EQ(error_of_spr(test::with_number(valid, at, std::numeric_limits<float>::quiet_NaN())),
              "no error");
}

TEST(Spr, FaultsOfAPicture) {
  const base::ByteVector valid = smallest_sprite();
  EXPECT_THAT(error_of_spr(test::with_number(valid, kFrameAt, 2)),
              HasSubstr("frame 0 at offset 0x24: unknown type 2"));
  for (const std::size_t at : {kPictureAt + 8, kPictureAt + 12}) {
    for (const std::uint32_t side : {0u, kMaxSprSide + 1, 1u << 31})
      EXPECT_THAT(error_of_spr(test::with_number(valid, at, side)), HasSubstr(std::to_string(side)));
    EXPECT_THAT(error_of_spr(test::with_number(valid, at, kMaxSprSide)), HasSubstr("2 are left"));
  }
  for (const std::size_t at : {kPictureAt, kPictureAt + 4})
    for (const std::int32_t place : {kMaxSprOffset + 1, std::numeric_limits<std::int32_t>::min()})
      EXPECT_THAT(error_of_spr(test::with_number(valid, at, place)), HasSubstr(std::to_string(place)));
}

// The second frame of small_spr() is a group of two.
TEST(Spr, FaultsOfAGroup) {
  const base::ByteVector valid = write_spr(test::small_spr());
  constexpr std::size_t kGroupAt = kPictureAt + 16 + 3 * 2;
  EXPECT_THAT(error_of_spr(test::with_number(valid, kGroupAt + 4, 0)),
              HasSubstr("frame 1 at offset 0x3e: empty group"));
  EXPECT_THAT(error_of_spr(test::with_number(valid, kGroupAt + 4, ~0u)), HasSubstr("are left"));
  const auto with_end = [&](float end_s) {
    return read_spr(test::with_number(valid, kGroupAt + 12, end_s)).value().frames[1].end_times_s;
  };
  for (const float end_s : {0.5f, 0.0f, -3.0f, std::numeric_limits<float>::infinity()})
    EXPECT_EQ(with_end(end_s), (std::vector<float>{0.5f, 0.5f + 0.1f})) << end_s;
  EXPECT_THAT(error_of_spr(test::with_number(valid, kGroupAt + 16 + 8, 0)),
              HasSubstr("frame 1, picture 0 at offset 0x4e: 0 x 4"));
}

TEST(Spr, SurvivesDamagedFiles) {
  const base::ByteVector valid = write_spr(test::small_spr());
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    test::Random random(seed);
    const auto spr = read_spr(test::with_flipped_bits(valid, random));
    if (!spr.ok()) continue;
    const auto back = read_spr(write_spr(*spr));
    ASSERT_TRUE(back.ok()) << "seed " << seed << ": " << back.error().message();
    EXPECT_EQ(*back, *spr) << "seed " << seed;
  }
}

TEST(Spr, StockSpritesRoundTrip) {
  DATA_FOLDER_OR_SKIP(data);
  int sprites = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "progs")) {
    if (entry.path().extension() != ".spr") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const base::ByteVector bytes = test::read_file(entry.path());
    const auto spr = read_spr(bytes);
    ASSERT_TRUE(spr.ok()) << spr.error().message();
    EXPECT_EQ(write_spr(*spr), bytes);
    ++sprites;
  }
  EXPECT_GE(sprites, 4);
}

}  // namespace
}  // namespace temblor::formats
