#include "client/effects/mark_pictures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/images/png.h"
#include "support/programs/temporary_folder.h"

namespace temblor::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

base::ByteVector png(std::uint32_t width, std::uint32_t height) {
  return formats::write_png(
             formats::Image{width, height, std::vector<std::uint32_t>(width * height, 0x80ff0000u)})
      .value();
}

struct Loaded {
  explicit Loaded(const test::TemporaryFolder& folder)
      : library(vfs::FileSystem::open(folder.path()).value()), pictures(MarkPictures::load(library, notes)) {}
  std::vector<std::string> notes;
  assets::Library library;
  MarkPictures pictures;
};

TEST(MarkPictures, AreThoseOfTheFolder) {
  test::TemporaryFolder folder;
  folder.write("id1/gfx/marks/smile.png", png(40, 30));
  folder.write("id1/gfx/marks/Large.png", png(256, 256));
  folder.write("id1/gfx/other.png", png(8, 8));
  const Loaded loaded(folder);
  EXPECT_THAT(loaded.notes, IsEmpty());
  ASSERT_NE(loaded.pictures.find("smile"), nullptr);
  EXPECT_EQ(loaded.pictures.find("smile")->longer_side(), 40);
  EXPECT_NE(loaded.pictures.find("large"), nullptr);
  for (const char* name : {"other", "../other", "", "smile.png"})
    EXPECT_EQ(loaded.pictures.find(name), nullptr) << name;
}

TEST(MarkPictures, BadOnesAreNamedAndLeftOut) {
  test::TemporaryFolder folder;
  base::ByteVector cut = png(16, 16);
  cut.resize(cut.size() / 2);
  folder.write("id1/gfx/marks/cut.png", cut);
  folder.write("id1/gfx/marks/empty.png", base::ByteVector{});
  folder.write("id1/gfx/marks/good.png", png(1, 1));
  folder.write("id1/gfx/marks/wide.png", png(257, 4));
  const Loaded loaded(folder);
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("gfx/marks/cut.png"), HasSubstr("gfx/marks/empty.png"),
                                        HasSubstr("wide.png: 257 x 4 pixels; a mark has at most 256 x 256")));
  EXPECT_NE(loaded.pictures.find("good"), nullptr);
  EXPECT_EQ(loaded.pictures.find("wide"), nullptr);
}

TEST(MarkPictures, AreLimited) {
  test::TemporaryFolder folder;
  const base::ByteVector bytes = png(1, 1);
  for (std::size_t i = 0; i < MarkPictures::kMaxPictures + 2; ++i)
    folder.write(fmt::format("id1/gfx/marks/m{:04}.png", i), bytes);
  const Loaded loaded(folder);
  EXPECT_THAT(loaded.notes, ElementsAre(HasSubstr("m0128.png and later files: only 128")));
  EXPECT_NE(loaded.pictures.find("m0127"), nullptr);
  EXPECT_EQ(loaded.pictures.find("m0128"), nullptr);
}

}  // namespace
}  // namespace temblor::client
