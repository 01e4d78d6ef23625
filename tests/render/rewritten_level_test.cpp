// A level draws the same pixels in every file format: BSP 29, 2PSB, BSP2; with colored light in the file or
// beside it; as loose files, in a PAK, in a PK3.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assets/assets.h"
#include "formats/archives/pak.h"
#include "formats/archives/pk3.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

constexpr int kViews = effort(10, 2);
using LevelPointer = std::shared_ptr<const world::Level>;

// A level as files, and its picture.
struct LevelFiles {
  formats::Bsp bsp;
  std::optional<formats::Lit> lit;
  formats::Palette palette;
  formats::Colormap colormap;
};

LevelFiles small_files() {
  const DrawableLevel drawable = small_level();
  LevelFiles files{artgen::make_small_level({.colored_light = true}), std::nullopt, drawable.palette,
                   drawable.colormap};
  const formats::BspxLump* colors = files.bsp.find_bspx("RGBLIGHTING");
  CHECK(colors != nullptr);
  const auto samples = base::as_u8(colors->data);
  files.lit = formats::Lit{{samples.begin(), samples.end()}};
  files.bsp.bspx.clear();
  return files;
}

LevelFiles stock_files(const std::filesystem::path& base_folder, const std::string& map_name) {
  const DrawableLevel drawable = stock_level(base_folder, map_name);
  const std::filesystem::path maps = base_folder / "id1" / "maps";
  return {formats::read_bsp(read_file(maps / (map_name + ".bsp"))).value(),
          formats::read_lit(read_file(maps / (map_name + ".lit"))).value(), drawable.palette,
          drawable.colormap};
}

const formats::Lit* colored_light(const LevelFiles& files) {
  return files.lit ? &*files.lit : nullptr;
}

LevelPointer as_it_is(const LevelFiles& files) {
  return world::make_level(files.bsp, "level", colored_light(files)).value();
}

LevelPointer rewritten(const LevelFiles& files, formats::BspVersion version) {
  const base::ByteVector bytes = formats::write_bsp(files.bsp, version).value();
  formats::Bsp bsp = formats::read_bsp(bytes).value();
  EXPECT_EQ(bsp.version, version);
  return world::make_level(std::move(bsp), "level", colored_light(files)).value();
}

formats::Bsp with_light_inside(const LevelFiles& files) {
  formats::Bsp bsp = files.bsp;
  const auto samples = std::as_bytes(std::span(files.lit->samples));
  bsp.bspx.push_back({"RGBLIGHTING", {samples.begin(), samples.end()}});
  return bsp;
}

LevelPointer lit_from_inside(const LevelFiles& files) {
  const base::ByteVector bytes =
      formats::write_bsp(with_light_inside(files), formats::BspVersion::k29).value();
  return world::make_level(formats::read_bsp(bytes).value(), "level").value();
}

// Loads the level through the game's file system; `archive` makes the archive `archive_name` from the files.
template <typename Archive>
LevelPointer from_archive(const LevelFiles& files, const std::string& archive_name, Archive archive) {
  const base::ByteVector bsp = formats::write_bsp(files.bsp, formats::BspVersion::k29).value();
  const base::ByteVector lit = formats::write_lit(*files.lit);
  const std::vector<formats::ArchiveFile> contents = {{"maps/level.bsp", bsp}, {"maps/level.lit", lit}};
  const TemporaryFolder folder;
  folder.write("id1/" + archive_name, base::ByteVector(archive(contents).value()));
  const vfs::FileSystem mounted = vfs::FileSystem::open(folder.path()).value();
  const assets::LoadedLevel loaded = assets::load_level(mounted, "level").value();
  EXPECT_TRUE(loaded.level->light_rgb.size() == files.lit->samples.size());
  return loaded.level;
}

std::vector<FrameCopy> draw_pictures(const LevelFiles& files, const world::Level& level) {
  std::vector<FrameCopy> pictures;
  render::Renderer renderer(files.palette, files.colormap);
  for (int number = 0; number < kViews; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    const Viewpoint viewpoint{.camera = random_camera(level, random),
                              .brush_models = shown_brush_models(level),
                              .time_s = random.uniform(0, 100)};
    for (const render::PixelFormat format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
      render::FrameBuffer frame(320, 200, format);
      renderer.render(viewpoint.scene(level), {}, frame);
      pictures.push_back(copy_picture(frame));
    }
  }
  return pictures;
}

void expect_same_pictures(const LevelFiles& files) {
  const std::vector<FrameCopy> expected = draw_pictures(files, *as_it_is(files));
  const auto expect_same = [&](const LevelPointer& level, const char* what) {
    EXPECT_TRUE(draw_pictures(files, *level) == expected) << what;
  };
  expect_same(rewritten(files, formats::BspVersion::k29), "29");
  expect_same(rewritten(files, formats::BspVersion::k2Psb), "2PSB");
  expect_same(rewritten(files, formats::BspVersion::kBsp2), "BSP2");
  expect_same(lit_from_inside(files), "light in BSPX");
  expect_same(
      from_archive(files, "pak0.pak", [](const auto& contents) { return formats::write_pak(contents); }),
      "in a PAK");
  expect_same(
      from_archive(files, "level.pk3", [](const auto& contents) { return formats::write_pk3(contents); }),
      "in a PK3");
}

TEST(RewrittenLevel, MadeInCodeDrawsTheSamePixels) {
  expect_same_pictures(small_files());
}

class RewrittenStockLevel : public testing::TestWithParam<const char*> {};
TEST_P(RewrittenStockLevel, DrawsTheSamePixels) {
  DATA_FOLDER_OR_SKIP(data);
  expect_same_pictures(stock_files(data, GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Levels, RewrittenStockLevel, testing::Values("start", "lq_e0m1", "lq_e1m2"),
                         [](const auto& test) { return std::string(test.param); });

// The tests above would pass trivially if light did not change the picture.
TEST(RewrittenLevel, WithoutItsColoredLightDrawsOthers) {
  LevelFiles files = small_files();
  const std::vector<FrameCopy> colored = draw_pictures(files, *as_it_is(files));
  files.lit.reset();
  EXPECT_FALSE(draw_pictures(files, *as_it_is(files)) == colored);
}

}  // namespace
}  // namespace temblor::test
