// Draws every page over a bright scene with stock pictures, for people to look at
// (support/pictures/picture_file.h). The test checks that a page uses the game's pictures and stays in the
// frame.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "client/menu/canvas.h"
#include "client/menu/menu_driver.h"
#include "formats/images/palette.h"
#include "render/renderer.h"
#include "support/game_data.h"
#include "support/pictures/picture_file.h"

namespace temblor::client {
namespace {

using test::MenuDriver;

// The pixels of a scene: stripes of all colors, brightest in the middle.
std::vector<std::uint8_t> paint_scene(int width, int height) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.push_back(static_cast<std::uint8_t>((x * 24 / width) % 16 * 16 + 8 + (y / 16 + x / 16) % 8));
  return pixels;
}

// A placeholder for a level's overview: rectangles.
formats::Picture some_overview() {
  formats::Picture picture{320, 200, std::vector<std::uint8_t>(320 * 200, 0)};
  for (std::size_t y = 0; y < 200; ++y)
    for (std::size_t x = 0; x < 320; ++x)
      if ((x / 40 + y / 50) % 2 == 0)
        picture.pixels[y * 320 + x] = static_cast<std::uint8_t>(96 + x % 40 / 4);
  return picture;
}

TEST(MenuPictures, EveryPageStaysInTheFrame) {
  DATA_FOLDER_OR_SKIP(base);
  std::vector<std::string> notes;
  const auto files = vfs::FileSystem::open(base).value();
  const assets::Pictures pictures = assets::Pictures::load(files, notes);
  const formats::Palette palette = formats::read_palette(*files.read("gfx/palette.lmp")).value();
  const render::Renderer painter(palette, formats::make_colormap(palette));
  command::Variables variables;
  test::register_menu_variables(variables);
  const formats::Picture overview = some_overview();
  MenuContent content = MenuDriver::some_content();
  content.save_picture = [&](std::string_view) { return &overview; };
  content.level_pictures = [&](std::string_view) { return MenuLevelPictures{&overview, &overview}; };
  content.unsaved = [] { return std::string("The game since the last save would be lost."); };
  Menu menu(variables, pictures, content);

  struct Size {
    int width, height;
  };
  const std::pair<const char*, int> text_sizes[] = {{"0.5", 50}, {"1", 100}, {"2", 200}, {"4", 400}};
  for (const Size& size :
       {Size{320, 200}, Size{640, 480}, Size{1280, 720}, Size{1920, 1080}, Size{600, 1500}}) {
    const std::vector<std::uint8_t> scene = paint_scene(size.width, size.height);
    for (int shown = 0; shown < static_cast<int>(MenuPage::kCount) * 4; ++shown) {
      const int page = shown / 4;
      const auto& [text_size, percent] = text_sizes[shown % 4];
      ASSERT_TRUE(variables.set("scr_textsize", text_size).ok());
      menu.close();
      menu.open(static_cast<MenuPage>(page));
      menu.handle({0, platform::KeyChange{platform::Key::kDownArrow, true, false}});
      render::FrameBuffer frame(size.width, size.height, render::PixelFormat::kIndexed);
      std::ranges::copy(scene, frame.indexed().begin());
      render::DrawList list;
      menu.draw(size.width, size.height, 0.1, list);
      render::FrameStats stats;
      painter.draw_overlay(list, frame, stats);
      bool has_title_picture = false;
      // Large text leaves no room for it.
      const bool canvas_has_title =
          size.height / choose_menu_scale(size.width, size.height, percent / 100.0) >= 160;
      for (const render::DrawCommand& command : list.commands) {
        has_title_picture |= command.picture == pictures.find_real("gfx/p_option.lmp");
        if (command.picture == nullptr) continue;
        EXPECT_GE(command.area.x, 0);
        EXPECT_GE(command.area.y, 0);
        EXPECT_LE(command.area.x + command.area.width, size.width);
        EXPECT_LE(command.area.y + command.area.height, size.height);
      }
      EXPECT_EQ(has_title_picture, page == static_cast<int>(MenuPage::kOptions) && canvas_has_title) << page;
      test::show_picture(fmt::format("menu_{}_{}_{}", size.width, page, percent), frame, palette);
    }
  }
}

}  // namespace
}  // namespace temblor::client
