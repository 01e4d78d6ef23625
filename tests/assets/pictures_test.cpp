#include "assets/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "assets/stock/stock_pictures.h"
#include "formats/archives/wad.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"
#include "support/random.h"

namespace temblor::assets {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct LoadedPictures {
  Pictures pictures;
  std::vector<std::string> notes;
};
LoadedPictures load(const std::filesystem::path& base_folder) {
  LoadedPictures loaded;
  loaded.pictures = Pictures::load(vfs::FileSystem::open(base_folder).value(), loaded.notes);
  return loaded;
}

formats::Picture filled_picture(std::uint32_t width, std::uint32_t height, std::uint8_t index) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{width} * height, index)};
}

bool is_checker(const formats::Picture& picture) {
  return std::set<std::uint8_t>(picture.pixels.begin(), picture.pixels.end()).size() == 2;
}

// All pictures of a stock game, each in a single color.
class StockFolder {
 public:
  StockFolder() {
    for (const StockPicture& stock : stock_picture_files())
      folder_.write(std::string("id1/") + stock.name,
                    formats::write_picture(filled_picture(stock.width, stock.height, 3)));
    for (const StockPicture& stock : stock_wad_pictures())
      lump_bytes_.push_back(formats::write_picture(filled_picture(stock.width, stock.height, 4)));
    lump_bytes_.push_back(base::ByteVector(128 * 128, std::byte{0}));
    lump_bytes_.back()[5] = std::byte{9};
  }
  // In upper case, like those of LibreQuake.
  std::vector<formats::WadLump> lumps() const {
    std::vector<formats::WadLump> lumps;
    for (const StockPicture& stock : stock_wad_pictures()) {
      std::string name = stock.name;
      std::transform(name.begin(), name.end(), name.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
      lumps.push_back({name, formats::kWadPicture, lump_bytes_[lumps.size()]});
    }
    lumps.push_back({"CONCHARS", formats::kWadTexture, lump_bytes_.back()});
    return lumps;
  }
  base::ByteVector wad() const { return formats::write_wad(lumps()).value(); }
  void write_wad(base::Bytes bytes) const { folder_.write("id1/gfx.wad", bytes); }
  const test::TemporaryFolder& folder() const { return folder_; }

 private:
  test::TemporaryFolder folder_;
  std::vector<base::ByteVector> lump_bytes_;
};

TEST(Pictures, AreFoundIgnoringCase) {
  const StockFolder stock;
  stock.write_wad(stock.wad());
  const LoadedPictures loaded = load(stock.folder().path());
  EXPECT_THAT(loaded.notes, IsEmpty());
  for (const char* name : {"sbar", "SBar"}) {
    ASSERT_NE(loaded.pictures.find(name), nullptr);
    EXPECT_EQ(*loaded.pictures.find(name), filled_picture(320, 24, 4));
  }
  ASSERT_NE(loaded.pictures.find("gfx/complete.lmp"), nullptr);
  EXPECT_EQ(loaded.pictures.find("gfx/complete.lmp")->pixels[0], 3);
  EXPECT_EQ(loaded.pictures.find("gfx/none.lmp"), nullptr);
  EXPECT_EQ(loaded.pictures.find("conchars"), nullptr) << "not a picture of its own";
}

TEST(Pictures, HaveTransparentCharacters) {
  const StockFolder stock;
  stock.write_wad(stock.wad());
  const LoadedPictures loaded = load(stock.folder().path());
  const formats::Picture& characters = loaded.pictures.characters();
  ASSERT_EQ(characters.pixels.size(), 128u * 128u);
  EXPECT_EQ(characters.pixels[5], 9);
  EXPECT_EQ(std::count(characters.pixels.begin(), characters.pixels.end(), 255), 128 * 128 - 1);
}

TEST(Pictures, FindsModAndStockPictures) {
  const StockFolder stock;
  const base::ByteVector own = formats::write_picture(filled_picture(2, 3, 77));
  std::vector<formats::WadLump> lumps = stock.lumps();
  lumps.push_back({"hammer", formats::kWadPicture, own});
  lumps.push_back({"sbar", formats::kWadPicture, own});
  stock.write_wad(formats::write_wad(lumps).value());
  stock.folder().write("id1/gfx/title.lmp", own);
  const LoadedPictures loaded = load(stock.folder().path());
  EXPECT_THAT(loaded.notes, IsEmpty());
  EXPECT_EQ(*loaded.pictures.find("hammer"), filled_picture(2, 3, 77));
  EXPECT_EQ(*loaded.pictures.find("gfx/title.lmp"), filled_picture(2, 3, 77));
  EXPECT_EQ(*loaded.pictures.find("sbar"), filled_picture(320, 24, 4)) << "the first of a name counts";
}

TEST(Pictures, MissingOnesAreCheckerboards) {
  const test::TemporaryFolder empty;
  empty.write("id1/readme.txt", "nothing here");
  const LoadedPictures loaded = load(empty.path());
  EXPECT_THAT(loaded.notes, ElementsAre(AllOf(HasSubstr("gfx.wad"), HasSubstr("conchars"), HasSubstr("more"),
                                              Not(HasSubstr("damaged")))));
  for (const std::span<const StockPicture> pictures : {stock_wad_pictures(), stock_picture_files()})
    for (const StockPicture& stock : pictures) {
      const formats::Picture* const picture = loaded.pictures.find(stock.name);
      ASSERT_NE(picture, nullptr) << stock.name;
      EXPECT_EQ(picture->width, stock.width) << stock.name;
      EXPECT_EQ(picture->height, stock.height) << stock.name;
      EXPECT_TRUE(is_checker(*picture)) << stock.name;
      EXPECT_EQ(loaded.pictures.find_real(stock.name), nullptr) << stock.name;
    }
  EXPECT_EQ(loaded.pictures.characters().pixels.size(), 128u * 128u);
}

TEST(Pictures, PlaceholdersAreNotReal) {
  const StockFolder stock;
  stock.write_wad(stock.wad());
  const LoadedPictures whole = load(stock.folder().path());
  EXPECT_EQ(whole.pictures.find_real("GFX/Pause.lmp"), whole.pictures.find("gfx/pause.lmp"));
  EXPECT_EQ(whole.pictures.find_real("gfx/nowhere.lmp"), nullptr);
  std::filesystem::remove(stock.folder().path() / "id1/gfx/pause.lmp");
  stock.folder().write("id1/gfx/inter.lmp", "damaged");
  const LoadedPictures loaded = load(stock.folder().path());
  for (const char* name : {"gfx/pause.lmp", "GFX/INTER.lmp"}) {
    EXPECT_NE(loaded.pictures.find(name), nullptr) << name;
    EXPECT_EQ(loaded.pictures.find_real(name), nullptr) << name;
  }
  EXPECT_NE(loaded.pictures.find_real("sbar"), nullptr);
}

TEST(Pictures, MayHaveAnyType) {
  const StockFolder stock;
  std::vector<formats::WadLump> lumps = stock.lumps();
  const base::ByteVector colors(768, std::byte{255});
  for (std::size_t i = 0; i < lumps.size(); ++i) lumps[i].type = static_cast<std::uint8_t>(i);
  lumps.push_back({"PALETTE", formats::kWadPalette, colors});
  stock.write_wad(formats::write_wad(lumps).value());
  const LoadedPictures loaded = load(stock.folder().path());
  EXPECT_THAT(loaded.notes, IsEmpty());
  EXPECT_EQ(*loaded.pictures.find_real("sbar"), filled_picture(320, 24, 4));
  EXPECT_EQ(loaded.pictures.characters().pixels[5], 9);
  EXPECT_EQ(loaded.pictures.find("palette"), nullptr);
}

TEST(Pictures, DamagedOnesAreNamedCheckerboards) {
  const StockFolder stock;
  std::vector<formats::WadLump> lumps = stock.lumps();
  for (formats::WadLump& lump : lumps)
    if (lump.name == "DISC" || lump.name == "CONCHARS") lump.data = lump.data.first(lump.data.size() - 1);
  stock.write_wad(formats::write_wad(lumps).value());
  stock.folder().write("id1/gfx/pause.lmp", "cut");
  stock.folder().write("id1/gfx/sbar.png", "cut");
  const LoadedPictures loaded = load(stock.folder().path());
  EXPECT_THAT(loaded.notes, ElementsAre(AllOf(HasSubstr("damaged: disc"), HasSubstr("conchars"),
                                              HasSubstr("gfx/pause.lmp"), Not(HasSubstr("sbar"))),
                                        AllOf(HasSubstr("sbar.png"), Not(HasSubstr("gfx.wad")))));
  EXPECT_TRUE(is_checker(*loaded.pictures.find("disc")));
  EXPECT_TRUE(is_checker(*loaded.pictures.find("gfx/pause.lmp")));
  EXPECT_FALSE(is_checker(*loaded.pictures.find("sbar")));
  EXPECT_EQ(loaded.pictures.find_real("DISC"), nullptr);
  EXPECT_EQ(loaded.pictures.find_real("SBar"), loaded.pictures.find("sbar"));
}

TEST(Pictures, DamagedArchiveGivesPlaceholders) {
  const StockFolder stock;
  const base::ByteVector wad = stock.wad();
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::effort(40, 5)); ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    base::ByteVector bytes = wad;
    if (seed % 2 == 0)
      bytes.resize(random.below(bytes.size()));
    else  // the header of the archive, or the table at its end
      for (int i = 0; i < 4; ++i) {
        const std::size_t place =
            random.chance(0.2) ? random.below(12) : bytes.size() - 1 - random.below(3000);
        bytes[place] = static_cast<std::byte>(random.bits());
      }
    stock.write_wad(bytes);
    const LoadedPictures loaded = load(stock.folder().path());
    for (const StockPicture& picture : stock_wad_pictures())
      ASSERT_NE(loaded.pictures.find(picture.name), nullptr) << picture.name;
    EXPECT_LE(loaded.notes.size(), 1u);
  }
}

TEST(Pictures, FindsAllStockPictures) {
  DATA_FOLDER_OR_SKIP(data);
  const LoadedPictures loaded = load(data);
  EXPECT_THAT(loaded.notes, IsEmpty());
  EXPECT_EQ(loaded.pictures.find("sbar")->width, 320u);
  EXPECT_EQ(loaded.pictures.find("num_0")->width, 24u);
}

}  // namespace
}  // namespace temblor::assets
