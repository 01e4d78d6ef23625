// Sheets of a plate that is wide from the front, narrow from the side, and grows.
#include "app/inspect/model_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "artgen/models/model.h"
#include "artgen/palette.h"
#include "formats/images/image.h"
#include "formats/images/palette.h"
#include "formats/images/png.h"
#include "support/models/posed_samples.h"
#include "support/programs/temporary_folder.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

using ::testing::HasSubstr;

constexpr const char* kPlate =
    "model progs/plate.mdl\n"
    "  paint glow fire bright=0.4..0.6\n"
    "  bone a 0,0,0\n"
    "  box a 0,0,20 4,40,40\n"
    "  animation grow 3\n"
    "    key 0 a.scale=0.5\n"
    "    key 2 a.scale=1\n";

class ModelSheet : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto script = artgen::read_script(kPlate);
    ASSERT_TRUE(script.ok());
    const auto art = artgen::make_model_art(script->front());
    ASSERT_TRUE(art.ok());
    model_ = folder_.write("progs/plate.mdl", art->front().bytes);
    options_.out = (folder_.path() / "sheet.png").string();
    options_.cell_px = 100;
  }

  formats::Image drawn() {
    const base::Status drawn = draw_model_sheet(model_, options_);
    EXPECT_TRUE(drawn.ok()) << (drawn.ok() ? "" : drawn.error().message());
    const auto bytes = vfs::read_disk_file(options_.out);
    EXPECT_TRUE(bytes.ok());
    const auto image = formats::read_png(*bytes);
    EXPECT_TRUE(image.ok());
    return *image;
  }

  // Columns and rows of a cell that show the plate, the only thing that is bright orange.
  std::pair<int, int> size_in(const formats::Image& image, int column, int row) const {
    std::set<int> columns, rows;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const auto at = static_cast<std::size_t>(row * 100 + y) * image.width +
                        static_cast<std::size_t>(column * 100 + x);
        const std::uint32_t red = image.pixels[at] >> 16 & 255, blue = image.pixels[at] & 255;
        if (red < 150 || blue > 120) continue;
        columns.insert(x);
        rows.insert(y);
      }
    }
    return {static_cast<int>(columns.size()), static_cast<int>(rows.size())};
  }

  test::TemporaryFolder folder_;
  std::filesystem::path model_;
  SheetOptions options_;
};

TEST_F(ModelSheet, HasAColumnForEachFrameAndARowForEachView) {
  options_.frames = "0,grow3";
  options_.views = "front,side";
  const formats::Image image = drawn();
  ASSERT_EQ(image.width, 200u);
  ASSERT_EQ(image.height, 200u);
  const auto [small_width, small_height] = size_in(image, 0, 0);
  const auto [width, height] = size_in(image, 1, 0);
  const auto [side_width, side_height] = size_in(image, 1, 1);
  EXPECT_GT(width, 30);
  EXPECT_NEAR(width, height, 0.15 * width);
  EXPECT_NEAR(small_width, 0.5 * width, 4);
  EXPECT_NEAR(small_height, 0.5 * height, 4);
  EXPECT_LT(side_width, 0.35 * width);
  EXPECT_NEAR(side_height, height, 8);  // its front is nearer to the camera
}

TEST_F(ModelSheet, LightsModelsAboveTheirOrigin) {
  const auto script = artgen::read_script(
      "model progs/high.mdl\n  paint pale sand bright=0.7..0.9\n  bone a 0,0,20\n  box a 0,0,0 8,8,8\n");
  ASSERT_TRUE(script.ok());
  const auto art = artgen::make_model_art(script->front());
  ASSERT_TRUE(art.ok());
  model_ = folder_.write("progs/high.mdl", art->front().bytes);
  options_.views = "front";
  const auto red = [&](int light) {
    options_.light = light;
    const formats::Image image = drawn();
    return image.pixels[std::size_t{50} * image.width + 50] >> 16 & 255;
  };
  EXPECT_GT(red(200), 100u);
  EXPECT_LT(red(20), red(200) / 2);
}

TEST_F(ModelSheet, ShowsAModelAsTheViewWeapon) {
  options_.views = "hand";
  EXPECT_EQ(drawn().width, 300u);
}

// The column, 24 units wide and 96 high, in the bright color of its skin.
TEST_F(ModelSheet, ShowsMd5ModelsWithTheirSkins) {
  const test::Md5Sample sample = test::bending_column(16, 12, 4, "column");
  model_ = folder_.write("progs/column.md5mesh", sample.mesh);
  folder_.write("progs/column.md5anim", sample.animation);
  folder_.write("progs/column_00_00.png", formats::write_png(formats::Image{1, 1, {0xffffa040}}).value());
  folder_.write("gfx/palette.lmp", formats::write_palette(artgen::make_palette()));
  options_.frames = "0";
  options_.views = "front";
  options_.light = 255;
  const auto [width, height] = size_in(drawn(), 0, 0);
  EXPECT_GT(height, 80);
  EXPECT_NEAR(width, height / 4, 4);
}

TEST_F(ModelSheet, UnknownNamesListTheKnownOnes) {
  const auto message = [&] {
    const base::Status drawn = draw_model_sheet(model_, options_);
    return drawn.ok() ? "" : drawn.error().message();
  };
  options_.frames = "walk1";
  EXPECT_THAT(
      message(),
      HasSubstr("--frames: unknown frame \"walk1\"; the model has frames 0 to 2, named grow1 to grow3"));
  options_.frames = "";
  options_.views = "below";
  EXPECT_THAT(message(),
              HasSubstr("unknown view \"below\"; choose from front, side, back, above, quarter, hand"));
  options_.views = "front,side";
  options_.cell_px = 1024;
  for (int i = 0; i < 20; ++i) options_.frames += "0,";
  EXPECT_THAT(message(), HasSubstr("the picture would be 20480 x 2048 pixels"));
  options_.frames = "";
  options_.views = "front";
  model_ = folder_.write("progs/level.mdl", "IBSP and so on");
  EXPECT_THAT(message(), HasSubstr("progs/level.mdl"));
}

}  // namespace
}  // namespace temblor::app
