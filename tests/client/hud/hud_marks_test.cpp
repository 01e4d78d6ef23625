// Marks on the heads-up display: the crosshair, and shapes that repeat what colors say.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "client/hud/hud.h"
#include "client/hud/panel.h"
#include "client/no_pictures.h"

namespace temblor::client {
namespace {

Game game_with(int health, int armor, int ammo) {
  Game game;
  game.stats[static_cast<std::size_t>(Stat::kHealth)] = health;
  game.stats[static_cast<std::size_t>(Stat::kArmor)] = armor;
  game.stats[static_cast<std::size_t>(Stat::kAmmo)] = ammo;
  return game;
}

struct Fill {
  int left, top, right, bottom, index;
};

std::vector<Fill> fills(const Hud& hud, const Game& game, int width, int height,
                        const HudSettings& settings) {
  render::DrawList list;
  hud.draw(game, 1000, width, height, settings, list);
  std::vector<Fill> found;
  for (const render::DrawCommand& command : list.commands)
    if (command.picture == nullptr)
      found.push_back({command.area.x, command.area.y, command.area.x + command.area.width,
                       command.area.y + command.area.height, command.fill});
  return found;
}

std::vector<Fill> fills(const Game& game, int width, int height, const HudSettings& settings) {
  return fills(Hud(test::no_pictures()), game, width, height, settings);
}

HudSettings with_crosshair(Crosshair shape) {
  HudSettings settings;
  settings.crosshair = {shape, 251};
  return settings;
}

TEST(HudMarks, CrosshairIsCenteredInEveryFrame) {
  for (const auto& [width, height] : {std::pair(320, 200), {641, 480}, {1920, 1080}, {3840, 2160}})
    for (const Crosshair shape : {Crosshair::kDot, Crosshair::kLines}) {
      SCOPED_TRACE(testing::Message() << width << "x" << height);
      const auto found = fills(game_with(100, 100, 100), width, height, with_crosshair(shape));
      ASSERT_FALSE(found.empty());
      int left = width, right = 0, top = height, bottom = 0;
      for (const Fill& fill : found) {
        left = std::min(left, fill.left), right = std::max(right, fill.right);
        top = std::min(top, fill.top), bottom = std::max(bottom, fill.bottom);
      }
      const int line_px = std::max(1, height / 540);
      EXPECT_NEAR(left + right, width, 2 * line_px + 1);
      EXPECT_NEAR(top + bottom, height, 2 * line_px + 1);
      EXPECT_EQ(right - left, bottom - top);
      EXPECT_LE(right - left, 22 * line_px) << "no larger than a target";
      EXPECT_TRUE(std::ranges::any_of(found, [](const Fill& fill) { return fill.index == 251; }));
    }
}

TEST(HudMarks, LinesLeaveTheCenterFree) {
  for (const Fill& fill : fills(game_with(100, 0, 0), 640, 480, with_crosshair(Crosshair::kLines)))
    EXPECT_FALSE(fill.left <= 320 && fill.right > 320 && fill.top <= 240 && fill.bottom > 240);
}

TEST(HudMarks, NoCrosshairWhenOffOrDead) {
  EXPECT_TRUE(fills(game_with(100, 100, 100), 640, 480, {}).empty());
  HudSettings settings = with_crosshair(Crosshair::kDot);
  settings.status_bar = StatusBar::kNone;
  EXPECT_FALSE(fills(game_with(1, 0, 0), 640, 480, settings).empty());
  EXPECT_TRUE(fills(game_with(0, 0, 0), 640, 480, settings).empty());
  Game over = game_with(100, 100, 100);
  over.ending = Ending::kIntermission;
  EXPECT_TRUE(fills(over, 640, 480, settings).empty());
}

// Strokes over the part of the bar that begins at `x`; the bar's upper edge is at 200 - 24.
std::ptrdiff_t strokes_in_well(const std::vector<Fill>& found, int x) {
  return std::ranges::count_if(found, [x](const Fill& fill) {
    return fill.index == 15 && fill.left >= x && fill.right <= x + 24 && fill.top >= 200 - 24;
  });
}

TEST(HudMarks, SafeColorsMarkLowNumbers) {
  HudSettings settings;
  settings.safe_colors = true;
  constexpr int kHealthX = 136, kAmmoX = 248;
  const auto low = fills(game_with(25, 25, 10), 320, 200, settings);
  const auto good = fills(game_with(26, 26, 11), 320, 200, settings);
  for (const int x : {kHealthX, kAmmoX}) {
    EXPECT_EQ(strokes_in_well(low, x), 2) << x;
    EXPECT_EQ(strokes_in_well(good, x), 0) << x;
  }
  EXPECT_TRUE(fills(game_with(25, 25, 10), 320, 200, {}).empty());
}

// A player who has no armor, or who has picked up a little, needs no warning.
TEST(HudMarks, SafeColorsWarnAboutArmorOnlyAfterALoss) {
  HudSettings settings;
  settings.safe_colors = true;
  constexpr int kArmorX = 24;
  const auto strokes = [&](std::initializer_list<std::pair<double, int>> armor_at) {
    Hud hud(test::no_pictures());
    int armor = 0;
    for (const auto& [time_s, value] : armor_at) hud.advance(game_with(100, armor = value, 100), {}, time_s);
    return strokes_in_well(fills(hud, game_with(100, armor, 100), 320, 200, settings), kArmorX);
  };
  EXPECT_EQ(strokes({{999, 0}}), 0);
  EXPECT_EQ(strokes({{990, 0}, {999, 10}}), 0) << "picked up";
  EXPECT_EQ(strokes({{990, 30}, {999, 20}}), 2);
  EXPECT_EQ(strokes({{990, 30}, {999, 0}}), 2);
  EXPECT_EQ(strokes({{990, 100}, {999, 90}}), 0) << "enough is left";
  EXPECT_EQ(strokes({{990, 30}, {996, 20}}), 0) << "a while ago";
}

TEST(HudMarks, SafeColorsMarkTheKindOfArmor) {
  HudSettings settings;
  settings.safe_colors = true;
  constexpr std::uint32_t kFirstArmorItem = 1u << 13;
  for (int kind = 1; kind <= 3; ++kind) {
    Game game = game_with(100, 100, 100);
    game.data.items = kFirstArmorItem << (kind - 1);
    EXPECT_EQ(strokes_in_well(fills(game, 320, 200, settings), 0), kind);
  }
}

TEST(HudMarks, SafeColorsLabelTheKeys) {
  HudSettings settings;
  settings.safe_colors = true;
  Game game = game_with(100, 100, 100);
  struct ShownKey {
    std::uint32_t item;
    char letter;
  };
  for (const ShownKey& key : {ShownKey{1u << 17, 'S'}, ShownKey{1u << 18, 'G'}}) {
    game.data.items = key.item;
    render::DrawList list;
    Hud(test::no_pictures()).draw(game, 1000, 320, 200, settings, list);
    EXPECT_EQ(std::ranges::count_if(list.commands,
                                    [&key](const render::DrawCommand& command) {
                                      return command.picture == &test::no_pictures().characters() &&
                                             command.part_y / 8 * 16 + command.part_x / 8 == key.letter;
                                    }),
              1);
  }
}

}  // namespace
}  // namespace temblor::client
