#include "formats/images/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/game_data.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

base::ByteVector hand_made_picture() {
  base::ByteWriter writer;
  writer.u32(3);
  writer.u32(2);
  for (const int pixel : {1, 2, 3, 4, 5, 255}) writer.u8(static_cast<std::uint8_t>(pixel));
  return std::move(writer).take();
}

TEST(Picture, ReadsHandMadeFile) {
  const auto picture = read_picture(hand_made_picture());
  ASSERT_TRUE(picture.ok()) << picture.error().message();
  EXPECT_EQ(picture->width, 3u);
  EXPECT_EQ(picture->height, 2u);
  EXPECT_THAT(picture->pixels, ElementsAre(1, 2, 3, 4, 5, 255));
  EXPECT_EQ(write_picture(*picture), hand_made_picture());
}

TEST(Picture, IgnoresTrailingBytes) {
  base::ByteVector bytes = hand_made_picture();
  bytes.push_back(std::byte{9});
  const auto picture = read_picture(bytes);
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->pixels.size(), 6u);
}

TEST(Picture, RejectsEveryTruncation) {
  test::for_each_truncation(hand_made_picture(), [](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_picture(bytes).ok()) << bytes.size() << " bytes";
  });
}

TEST(Picture, RejectsHostileSizes) {
  const base::ByteVector valid = hand_made_picture();
  for (const std::uint32_t side : {0u, kMaxPictureSide + 1, 1u << 20, 0x80000000u, 0xffffffffu}) {
    for (const std::size_t field : {0, 4}) {
      const auto picture = read_picture(test::with_number(valid, field, side));
      ASSERT_FALSE(picture.ok()) << side;
      EXPECT_THAT(picture.error().what, HasSubstr(std::to_string(side)));
    }
  }
  EXPECT_FALSE(read_picture(test::with_number(valid, 0, kMaxPictureSide)).ok());  // more pixels than bytes
}

TEST(Conchars, ZeroIsTransparent) {
  base::ByteVector lump(128 * 128, std::byte{7});
  lump[0] = std::byte{0};
  lump[128 * 128 - 1] = std::byte{0};
  const auto picture = read_conchars(lump);
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->width, 128u);
  EXPECT_EQ(picture->height, 128u);
  ASSERT_EQ(picture->pixels.size(), 128u * 128u);
  EXPECT_EQ(picture->pixels.front(), 255);
  EXPECT_EQ(picture->pixels[1], 7);
  EXPECT_EQ(picture->pixels.back(), 255);
}

TEST(Conchars, NeedsAllPixels) {
  EXPECT_FALSE(read_conchars(base::ByteVector(128 * 128 - 1)).ok());
  const auto picture = read_conchars(base::ByteVector(128 * 128 + 1));
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->pixels.size(), 128u * 128u);
}

TEST(Picture, StockPicturesRoundTrip) {
  DATA_FOLDER_OR_SKIP(data);
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "gfx")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".lmp" || name == "palette.lmp" || name == "colormap.lmp") continue;
    const base::ByteVector bytes = test::read_file(entry.path());
    const auto picture = read_picture(bytes);
    ASSERT_TRUE(picture.ok()) << name << ": " << picture.error().message();
    EXPECT_EQ(write_picture(*picture), bytes) << name;
    ++pictures;
  }
  EXPECT_GT(pictures, 10);
}

}  // namespace
}  // namespace temblor::formats
