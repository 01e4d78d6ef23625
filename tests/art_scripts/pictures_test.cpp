// Compares pictures with the meaning of their scripts, and checks the pictures of the shipped game.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "artgen/art.h"
#include "artgen/palette.h"
#include "artgen/pictures/canvas.h"
#include "artgen/pictures/lettering.h"
#include "artgen/pictures/outline.h"
#include "artgen/scripts/script.h"
#include "assets/stock/stock_pictures.h"
#include "base/check.h"
#include "base/parallel_for.h"
#include "formats/archives/wad.h"
#include "formats/images/image.h"
#include "formats/images/picture.h"
#include "formats/models/spr.h"

namespace temblor::artgen {
namespace {

namespace fs = std::filesystem;

base::Result<std::vector<ArtFile>> build_art(const std::string& text) {
  TRY(std::vector<ScriptLine> things, read_script(text));
  base::Jobs jobs(1);
  const std::vector<ScriptFile> scripts = {{"test.script", std::move(things)}};
  return make_art(scripts, jobs);
}

std::string error_message(const std::string& text) {
  const auto art = build_art(text);
  return art.ok() ? "none" : art.error().message();
}

const base::ByteVector& find_file(const std::vector<ArtFile>& art, const std::string& path) {
  static const base::ByteVector kNothing;
  const auto found =
      std::find_if(art.begin(), art.end(), [&](const ArtFile& file) { return file.path == path; });
  EXPECT_NE(found, art.end()) << path;
  return found != art.end() ? found->bytes : kNothing;
}

formats::Picture draw_picture(const std::string& lines, const std::string& size = "8x8") {
  const auto art = build_art("picture p " + size + "\n" + lines);
  EXPECT_TRUE(art.ok()) << art.error().message();
  if (!art.ok()) return {};
  auto picture = formats::read_picture(find_file(*art, "gfx/p.lmp"));
  EXPECT_TRUE(picture.ok());
  return picture.ok() ? std::move(picture).value() : formats::Picture{};
}

std::uint8_t at(const formats::Picture& picture, std::uint32_t x, std::uint32_t y) {
  return picture.pixels[std::size_t{y} * picture.width + x];
}

TEST(Pictures, AShapeCoversItsPixelsAndNoOthers) {
  const formats::Picture picture = draw_picture("  box 2,3 6,5 color=red:0.5\n");
  const std::uint8_t red = ramp_color(Ramp::kRed, 0.5);
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      const bool inside = x >= 2 && x < 6 && y >= 3 && y < 5;
      // The middle of a ramp lies between two of its colors.
      EXPECT_EQ(at(picture, x, y) == kTransparent, !inside) << x << ' ' << y;
      if (inside) {
        EXPECT_LE(std::abs(at(picture, x, y) - red), 1);
      }
    }
  }
}

TEST(Pictures, EraseGroupsAndDefaults) {
  const formats::Picture picture = draw_picture(
      "  usual box color=gold:1\n"
      "  group at=4,0\n"
      "    box 0,0 4,4\n"
      "  box 6,0 8,2 erase=yes\n");
  EXPECT_EQ(at(picture, 1, 1), kTransparent);
  EXPECT_EQ(at(picture, 4, 1), ramp_color(Ramp::kGold, 1));
  EXPECT_EQ(at(picture, 7, 1), kTransparent);
  EXPECT_EQ(at(picture, 7, 3), ramp_color(Ramp::kGold, 1));
}

TEST(Pictures, RaisedEdgesAreBrighterAtTheUpperLeft) {
  const formats::Picture picture = draw_picture("  box 0,0 16,16 color=slate:0.5 raise=4\n", "16x16");
  EXPECT_GT(at(picture, 8, 0), at(picture, 8, 8));
  EXPECT_GT(at(picture, 0, 8), at(picture, 8, 8));
  EXPECT_LT(at(picture, 8, 15), at(picture, 8, 8));
  EXPECT_LT(at(picture, 15, 8), at(picture, 8, 8));
}

TEST(Pictures, BoundColorsStayInTheirRamp) {
  const auto art = build_art(
      "picture p 16x16 without=brown\n"
      "  box 0,0 8,16 color=brown:0.9 to=brown:0.2 keep_ramp=yes\n"
      "  box 8,0 16,16 color=brown:0.9 to=brown:0.2\n");
  ASSERT_TRUE(art.ok());
  const formats::Picture picture = formats::read_picture(find_file(*art, "gfx/p.lmp")).value();
  for (std::uint32_t y = 0; y < 16; ++y)
    for (std::uint32_t x = 0; x < 16; ++x)
      EXPECT_EQ(at(picture, x, y) / kRampColors == static_cast<std::size_t>(Ramp::kBrown), x < 8);
}

TEST(Pictures, OutlinesMeasureTheDistanceToTheirEdge) {
  using namespace pictures;
  const Outline box = make_box({0, 0}, {4, 2}, 0), ring = make_ring({0, 0}, 5, 2);
  EXPECT_DOUBLE_EQ(box.distance({2, 1}), -1);
  EXPECT_DOUBLE_EQ(box.distance({7, 6}), 5);  // a triangle of 3, 4 and 5
  EXPECT_DOUBLE_EQ(ring.distance({5, 0}), -1);
  EXPECT_DOUBLE_EQ(ring.distance({0, 0}), 4);
  const Outline triangle = make_polygon({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_LT(triangle.distance({1, 1}), 0);
  EXPECT_NEAR(triangle.distance({4, 4}), std::sqrt(8.0), 1e-9);
}

TEST(Pictures, EveryLetterLooksDifferent) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNPQRSTUVWXYZ0123456789-:/.!'";  // O is like 0
  std::set<std::vector<bool>> seen;
  for (const char letter : kLetters) {
    const pictures::Outline outline = pictures::make_text({&letter, 1}, {0, 0}, {.height = 20, .weight = 4});
    std::vector<bool> inside;
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 24; ++x) inside.push_back(outline.distance({x + 0.5, y + 0.5}) < 0);
    EXPECT_TRUE(seen.insert(inside).second) << letter;
  }
}

TEST(Pictures, SetsAreEveryDrawingInEveryStyle) {
  const auto art = build_art(
      "wadpictures 8x8\n"
      "  style a_\n"
      "    fill color=red\n"
      "    drawing\n"
      "  style b_\n"
      "    drawing\n"
      "  drawing x\n"
      "    box 0,0 4,8 color=blue\n"
      "  drawing y\n"
      "    box 4,0 8,8 color=blue\n");
  ASSERT_TRUE(art.ok()) << art.error().message();
  const auto lumps = formats::read_wad(find_file(*art, "gfx.wad"));
  ASSERT_TRUE(lumps.ok());
  std::set<std::string> names;
  for (const formats::WadLump& lump : *lumps) names.insert(lump.name);
  EXPECT_EQ(names, (std::set<std::string>{"a_x", "a_y", "b_x", "b_y"}));
  const formats::Picture b_x = formats::read_picture(formats::find_lump(*lumps, "b_x")->data).value();
  EXPECT_EQ(at(b_x, 7, 0), kTransparent);
  EXPECT_NE(at(b_x, 0, 0), kTransparent);
}

TEST(Pictures, SpritesAreCentered) {
  const auto art = build_art("sprite progs/s.spr 16x8\n  frame\n    fill\n  frame\n    disc 8,4 3\n");
  ASSERT_TRUE(art.ok());
  const auto sprite = formats::read_spr(find_file(*art, "progs/s.spr"));
  ASSERT_TRUE(sprite.ok());
  ASSERT_EQ(sprite->frames.size(), 2u);
  EXPECT_EQ(sprite->frames[0].pictures[0].left, -8);
  EXPECT_EQ(sprite->frames[0].pictures[0].up, 4);
  EXPECT_EQ(sprite->frames[1].pictures[0].texels[0], kTransparent);
}

TEST(Pictures, IconsKeepTheirTransparency) {
  const auto art = build_art("icon i 32\n  disc 32,32 20 color=gold\n");
  ASSERT_TRUE(art.ok());
  const auto image = formats::read_png(find_file(*art, "icon/i.png"));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 32u);
  EXPECT_EQ(image->pixels[0] >> 24, 0u);
  EXPECT_EQ(image->pixels[16 * 32 + 16] >> 24, 255u);
}

TEST(Pictures, MarksAreInTrueColorWithTransparency) {
  const auto art = build_art("mark m_1 32x16\n  box 8,4 24,12 color=gold opacity=0.5\n");
  ASSERT_TRUE(art.ok()) << art.error().message();
  const auto image = formats::read_png(find_file(*art, "gfx/marks/m_1.png"));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 32u);
  EXPECT_EQ(image->height, 16u);
  EXPECT_EQ(image->pixels[0] >> 24, 0u);
  EXPECT_NEAR(image->pixels[8 * 32 + 16] >> 24, 128, 1);
  EXPECT_EQ(error_message("mark Smile 8x8\n  fill\n"),
            "test.script: line 1: mark: a mark's name has only lower-case letters, digits, _ and -");
  EXPECT_THAT(error_message("mark m 257x8\n  fill\n"), testing::HasSubstr("256"));
}

TEST(Pictures, ErrorsNameTheLine) {
  EXPECT_EQ(error_message("picture p 8x8\n  boxx 0,0 1,1\n"),
            "test.script: line 2: boxx: unknown keyword; pictures have box, disc, ellipse, ring, arc, "
            "polygon, line, text, blob, wave, crack, ridge, scatter, fill, group, usual, write, tint, shade, "
            "weather, glyph");
  EXPECT_EQ(error_message("picture p 8x8\n  box 0,0 1\n"), "test.script: line 2: box: '1' is not X,Y");
  EXPECT_EQ(error_message("picture p 8x8\n  disc 1,1 1 color=gold:2\n"),
            "test.script: line 2: disc: color=gold:2 is not RAMP:TONE with a tone from 0 to 1");
  EXPECT_EQ(error_message("picture p 8x8\n  text \"a?\" 1,1\n"),
            "test.script: line 2: text: the lettering has no '?'");
  EXPECT_EQ(error_message("picture p 8x8\n  fill colors=red\n"),
            "test.script: line 2: fill: unknown setting 'colors'");
  EXPECT_EQ(error_message("font f\n  glyph A\n    .xo\n"),
            "test.script: line 3: .xo: a glyph's row is up to 8 characters, each . or x");
  EXPECT_EQ(error_message("sprite progs/s.spr 8x8\n"),
            "test.script: line 1: sprite: a sprite needs at least one frame");
  EXPECT_EQ(error_message("wadpictures 8x8\n  drawing a\n"),
            "test.script: line 1: wadpictures: at least one style and one drawing are required");
}

// The shipped scripts, made once for all tests of them. CHECK, because tests after a failed assertion in
// SetUpTestSuite() count as skipped.
class ShippedPictures : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(TEMBLOR_SOURCE_DIR) / "game/art/pictures"))
      if (entry.path().extension() == ".art") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<ScriptFile> scripts;
    for (const fs::path& path : paths) {
      std::ifstream file(path);
      auto things = read_script(std::string(std::istreambuf_iterator<char>(file), {}));
      CHECK(things.ok(), "{}", path.string());
      scripts.push_back({path.filename().string(), std::move(things).value()});
    }
    base::Jobs jobs(2);
    auto art = make_art(scripts, jobs);
    CHECK(art.ok(), "{}", art.error().message());
    art_ = std::move(art).value();
  }
  static base::Result<formats::Picture> stock_picture(std::string_view name) {
    if (name.starts_with("gfx/")) return formats::read_picture(find_file(art_, std::string(name)));
    TRY(const std::vector<formats::WadLump> lumps, formats::read_wad(find_file(art_, "gfx.wad")));
    const formats::WadLump* const lump = formats::find_lump(lumps, name);
    if (lump == nullptr) return base::malformed("no lump {}", name);
    return formats::read_picture(lump->data);
  }
  static formats::Picture characters() {
    const auto lumps = formats::read_wad(find_file(art_, "gfx.wad"));
    return formats::read_conchars(formats::find_lump(*lumps, "conchars")->data).value();
  }
  static std::vector<bool> ink(const formats::Picture& sheet, std::uint32_t code) {
    std::vector<bool> ink;
    constexpr std::uint8_t kDark = 6;  // the shadow is one of the darkest grays
    for (std::uint32_t y = 0; y < 8; ++y)
      for (std::uint32_t x = 0; x < 8; ++x) {
        const std::uint8_t pixel = at(sheet, code % 16 * 8 + x, code / 16 * 8 + y);
        ink.push_back(pixel != kTransparent && pixel >= kDark);
      }
    return ink;
  }
  inline static std::vector<ArtFile> art_;
};

TEST_F(ShippedPictures, EveryStockPictureExistsWithItsSize) {
  for (const auto& list : {assets::stock_wad_pictures(), assets::stock_picture_files()})
    for (const assets::StockPicture& stock : list) {
      const auto picture = stock_picture(stock.name);
      ASSERT_TRUE(picture.ok()) << stock.name;
      EXPECT_EQ(picture->width, stock.width) << stock.name;
      EXPECT_EQ(picture->height, stock.height) << stock.name;
      EXPECT_TRUE(std::any_of(picture->pixels.begin(), picture->pixels.end(), [](std::uint8_t pixel) {
        return pixel != kTransparent;
      })) << stock.name;
    }
}

TEST_F(ShippedPictures, IconsAndTitlesHaveTransparentBackgrounds) {
  for (const char* name :
       {"num_0", "anum_9", "face1", "sb_rocket", "sb_key1", "inv_shotgun", "inv_tremor", "disc",
        "gfx/pause.lmp", "gfx/ttl_main.lmp", "gfx/inter.lmp", "gfx/menuplyr.lmp"}) {
    const auto picture = stock_picture(name);
    ASSERT_TRUE(picture.ok()) << name;
    EXPECT_EQ(picture->pixels[0], kTransparent) << name;
  }
  for (const char* name : {"sbar", "ibar", "scorebar", "backtile", "gfx/conback.lmp", "gfx/help0.lmp"}) {
    const auto picture = stock_picture(name);
    ASSERT_TRUE(picture.ok()) << name;
    EXPECT_EQ(std::count(picture->pixels.begin(), picture->pixels.end(), kTransparent), 0) << name;
  }
}

// The list of docs/modding.md. A mark without clear and opaque pixels would hide the wall, or nothing.
TEST_F(ShippedPictures, MarksAreShapesOnAClearBackground) {
  for (const std::string name : {"arrow", "crack", "hand", "skull", "tremor"}) {
    const auto image = formats::read_png(find_file(art_, "gfx/marks/" + name + ".png"));
    ASSERT_TRUE(image.ok()) << name;
    const auto opaque = std::count_if(image->pixels.begin(), image->pixels.end(),
                                      [](std::uint32_t pixel) { return pixel >> 24 > 127; });
    const auto share = static_cast<double>(opaque) / static_cast<double>(image->pixels.size());
    EXPECT_GT(share, 0.05) << name;
    EXPECT_LT(share, 0.7) << name;
    for (const std::size_t corner : {std::size_t{0}, image->pixels.size() - 1})
      EXPECT_EQ(image->pixels[corner] >> 24, 0u) << name;
  }
}

TEST_F(ShippedPictures, NoTwoCharactersLookAlike) {
  const formats::Picture sheet = characters();
  std::map<std::vector<bool>, std::uint32_t> seen;
  for (std::uint32_t code = '!'; code < 128; ++code) {
    const auto [other, is_new] = seen.emplace(ink(sheet, code), code);
    EXPECT_TRUE(is_new) << code << " looks like " << other->second;
    EXPECT_GE(std::count(other->first.begin(), other->first.end(), true), 3) << code;
  }
  // Characters that are easily confused differ by more than a pixel or two.
  for (const auto& [a, b] :
       {std::pair('0', 'O'), {'1', 'l'}, {'1', 'I'}, {'5', 'S'}, {'8', 'B'}, {'2', 'Z'}}) {
    const std::vector<bool> first = ink(sheet, static_cast<std::uint32_t>(a)),
                            second = ink(sheet, static_cast<std::uint32_t>(b));
    int different = 0;
    for (std::size_t i = 0; i < first.size(); ++i) different += first[i] != second[i] ? 1 : 0;
    EXPECT_GE(different, 3) << a << b;
  }
  EXPECT_EQ(ink(sheet, ' '), std::vector<bool>(64, false));
}

TEST_F(ShippedPictures, LettersOfTheSecondHalfEqualTheFirst) {
  const formats::Picture sheet = characters();
  for (std::uint32_t code = ' '; code < 128; ++code)
    EXPECT_EQ(ink(sheet, code), ink(sheet, code + 128)) << code;
  for (std::uint32_t digit = 0; digit < 10; ++digit)
    EXPECT_NE(ink(sheet, 18 + digit), std::vector<bool>(64, false)) << digit;
}

TEST_F(ShippedPictures, TheFacesGetWorseAndDiffer) {
  std::set<std::vector<std::uint8_t>> seen;
  for (const char* name : {"face1", "face2", "face3", "face4", "face5", "face_p1", "face_p2", "face_p3",
                           "face_p4", "face_p5", "face_invis", "face_invul2", "face_inv2", "face_quad"}) {
    const auto picture = stock_picture(name);
    ASSERT_TRUE(picture.ok()) << name;
    EXPECT_TRUE(seen.insert(picture->pixels).second) << name;
  }
}

TEST_F(ShippedPictures, TheTremorHasItsIcons) {
  for (const char* name : {"inv_tremor", "inv2_tremor", "inva1_tremor", "inva5_tremor"}) {
    const auto picture = stock_picture(name);
    ASSERT_TRUE(picture.ok()) << name;
    EXPECT_EQ(picture->width, 24u);
    EXPECT_EQ(picture->height, 16u);
  }
}

TEST_F(ShippedPictures, SpritesThatGameCodeNamesExist) {
  const std::map<std::string, std::size_t> frames = {{"progs/s_bubble.spr", 2},
                                                     {"progs/s_explod.spr", 6},
                                                     {"progs/s_light.spr", 1},
                                                     {"progs/s_spark.spr", 3}};
  for (const auto& [path, count] : frames) {
    const auto sprite = formats::read_spr(find_file(art_, path));
    ASSERT_TRUE(sprite.ok()) << path;
    EXPECT_EQ(sprite->frames.size(), count) << path;
    for (const formats::SprFrame& frame : sprite->frames)
      EXPECT_EQ(frame.pictures[0].texels[0], kTransparent) << path;
  }
}

TEST_F(ShippedPictures, ThePlayersClothesTakeItsColors) {
  const auto picture = stock_picture("gfx/menuplyr.lmp");
  ASSERT_TRUE(picture.ok());
  std::map<std::size_t, int> ramps;
  for (const std::uint8_t pixel : picture->pixels)
    if (pixel != kTransparent) ++ramps[pixel / kRampColors];
  EXPECT_GT(ramps[static_cast<std::size_t>(Ramp::kBrown)], 150);
  EXPECT_GT(ramps[static_cast<std::size_t>(Ramp::kGold)], 80);
}

}  // namespace
}  // namespace temblor::artgen
