// The HUD's layouts with all notices, in frames of many sizes: everything is inside the frame, and nothing
// covers anything else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/hud/hud.h"
#include "client/no_pictures.h"

namespace temblor::client {
namespace {

using assets::MissionPack;

constexpr std::uint32_t kEverything = 0xffffffffu;

void set_stat(Game& io_game, Stat stat, int value) {
  io_game.stats[static_cast<std::size_t>(stat)] = value;
}

struct FrameSize {
  int width, height;
};
constexpr FrameSize kFrameSizes[] = {{320, 200},  {320, 240},   {640, 480},   {800, 600},
                                     {1280, 720}, {1920, 1080}, {3440, 1440}, {1000, 1600}};
constexpr float kTextSizes[] = {0.5f, 1, 2, 4};
constexpr HudLayout kLayouts[] = {HudLayout::kClassic, HudLayout::kCorners, HudLayout::kMinimal};
constexpr StatusBar kBars[] = {StatusBar::kNone, StatusBar::kSmall, StatusBar::kFull};

using Commands = std::vector<render::DrawCommand>;

bool is_same(const render::DrawCommand& a, const render::DrawCommand& b) {
  return a.picture == b.picture && a.area.x == b.area.x && a.area.y == b.area.y &&
         a.area.width == b.area.width && a.area.height == b.area.height;
}

bool overlaps(const render::ScreenRect& a, const render::ScreenRect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

// A player who has just picked up everything and changed weapons.
struct Busy {
  explicit Busy(MissionPack pack) : hud(test::no_pictures(), pack) {
    game.signon = kPlaying;
    set_stat(game, Stat::kHealth, 1);
    hud.advance(game, {}, 10);
    game.data.items = kEverything;
    for (const Stat stat : {Stat::kHealth, Stat::kArmor, Stat::kAmmo, Stat::kShells, Stat::kNails,
                            Stat::kRockets, Stat::kCells})
      set_stat(game, stat, 200);
    set_stat(game, Stat::kActiveWeapon, 4);
    hud.advance(game, {}, 11);
  }
  Commands draw(const FrameSize& size, const HudSettings& settings) const {
    render::DrawList list;
    hud.draw(game, 11, size.width, size.height, settings, list);
    return list.commands;
  }

  Game game;
  Hud hud;
};

// The commands that the settings add.
Commands find_added(const Busy& busy, const FrameSize& size, const HudSettings& settings) {
  HudSettings without = settings;
  without.notices = {};
  const Commands base = busy.draw(size, without);
  Commands added = busy.draw(size, settings);
  std::erase_if(added, [&](const render::DrawCommand& command) {
    return std::ranges::any_of(base, [&](const auto& other) { return is_same(command, other); });
  });
  return added;
}

void expect_apart(const Commands& some, const Commands& others, const char* what) {
  for (const render::DrawCommand& a : some)
    for (const render::DrawCommand& b : others)
      if (overlaps(a.area, b.area)) {
        ADD_FAILURE() << what << " overlap at " << a.area.x << ", " << a.area.y << " and " << b.area.x << ", "
                      << b.area.y;
        return;
      }
}

void check_frame(const Busy& busy, const FrameSize& size, const HudSettings& settings) {
  HudSettings one = settings;
  one.notices = {.pickups = true};
  const Commands pickups = find_added(busy, size, one);
  one.notices = {.weapons = true};
  const Commands weapons = find_added(busy, size, one);
  one.notices = {.power_timers = true};
  const Commands timers = find_added(busy, size, one);
  EXPECT_FALSE(pickups.empty() || weapons.empty() || timers.empty());
  expect_apart(pickups, weapons, "pickups and weapons");
  expect_apart(pickups, timers, "pickups and timers");
  expect_apart(weapons, timers, "weapons and timers");
  one.notices = {.power_timers = true};  // hides their icons in the corners
  Commands layout = busy.draw(size, one);
  std::erase_if(layout, [&](const render::DrawCommand& command) {
    return std::ranges::any_of(timers, [&](const auto& timer) { return is_same(command, timer); });
  });
  expect_apart(pickups, layout, "pickups and layout");
  expect_apart(weapons, layout, "weapons and layout");
  expect_apart(timers, layout, "timers and layout");
  // Scourge of Armagon has smaller keys than the stock ones, which leave the bar.
  std::erase_if(layout, [](const render::DrawCommand& command) {
    return command.picture == test::no_pictures().find("sb_key2");
  });
  for (const Commands& part : {pickups, weapons, timers, layout})
    for (const render::DrawCommand& command : part) {
      EXPECT_GE(std::min(command.area.x, command.area.y), 0);
      EXPECT_LE(command.area.x + command.area.width, size.width);
      EXPECT_LE(command.area.y + command.area.height, size.height);
    }
  one.notices = {.weapons = true};
  const int top = size.height - busy.hud.weapon_list_height_px(busy.game, 11, size.width, size.height, one);
  for (const render::DrawCommand& command : weapons) EXPECT_GE(command.area.y, top) << "captions are above";
}

TEST(Layouts, FitFramesOfEverySize) {
  for (const MissionPack pack : {MissionPack::kNone, MissionPack::kHipnotic, MissionPack::kRogue}) {
    Busy busy(pack);
    for (const bool deathmatch : {false, true}) {
      busy.game.deathmatch = deathmatch;
      busy.game.players.assign(deathmatch ? 4 : 1, {"Ann", 10, 4, 13});
      for (const FrameSize& size : kFrameSizes)
        for (const float text : kTextSizes)
          for (const HudLayout layout : kLayouts)
            for (const StatusBar bar : kBars) {
              SCOPED_TRACE(testing::Message()
                           << size.width << "x" << size.height << " text " << text << " layout "
                           << static_cast<int>(layout) << " bar " << static_cast<int>(bar) << " pack "
                           << static_cast<int>(pack) << (deathmatch ? " deathmatch" : ""));
              HudSettings settings;
              settings.layout = layout;
              settings.status_bar = bar;
              settings.size.text = text;
              check_frame(busy, size, settings);
            }
    }
  }
}

// Where a picture is drawn, in the original's pixels at scale 1; empty if it is not.
std::vector<render::ScreenRect> find_places(const Commands& commands, const char* name) {
  std::vector<render::ScreenRect> places;
  for (const render::DrawCommand& command : commands)
    if (command.picture == test::no_pictures().find(name)) places.push_back(command.area);
  return places;
}

TEST(Layouts, CornersHaveFiguresAtTheEdges) {
  Busy busy(MissionPack::kNone);
  busy.game.data.items = 1u << 8 | 1u << 13 | 1u << 17 | 1u << 28;  // shells, armor, a key, a sigil
  HudSettings settings;
  settings.layout = HudLayout::kCorners;
  const Commands drawn = busy.draw({400, 300}, settings);
  const auto corner = [&](const char* name) {
    const auto places = find_places(drawn, name);
    return places.empty() ? math::Vec2d(-1) : math::Vec2d(places[0].x, places[0].y);
  };
  EXPECT_EQ(corner("face1"), math::Vec2d(2, 300 - 26));
  EXPECT_EQ(corner("sb_armor1"), math::Vec2d(2, 300 - 52));
  EXPECT_EQ(corner("sb_shells"), math::Vec2d(400 - 98, 300 - 26));
  EXPECT_EQ(corner("sb_sigil1"), math::Vec2d(400 - 10, 300 - 44));
  EXPECT_EQ(corner("sb_key1"), math::Vec2d(400 - 26, 300 - 44));
  EXPECT_TRUE(find_places(drawn, "sbar").empty());
  set_stat(busy.game, Stat::kArmor, 0);
  EXPECT_TRUE(find_places(busy.draw({400, 300}, settings), "anum_0").empty()) << "no armor, no number";
  settings.status_bar = StatusBar::kSmall;
  EXPECT_TRUE(find_places(busy.draw({400, 300}, settings), "sb_key1").empty());
  settings.status_bar = StatusBar::kNone;
  EXPECT_TRUE(busy.draw({400, 300}, settings).empty());
}

TEST(Layouts, MinimalHasHealthAndAmmoOnly) {
  Busy busy(MissionPack::kNone);
  set_stat(busy.game, Stat::kAmmo, 37);
  HudSettings settings;
  settings.layout = HudLayout::kMinimal;
  const Commands drawn = busy.draw({400, 300}, settings);
  EXPECT_EQ(drawn.size(), 5u) << "200 and 37";
  EXPECT_EQ(find_places(drawn, "num_2").at(0).x, 2);
  EXPECT_EQ(find_places(drawn, "num_7").at(0).x, 400 - 26);
  busy.game.data.items = 1;  // a weapon without ammo is in hand
  EXPECT_EQ(busy.draw({400, 300}, settings).size(), 3u);
}

TEST(Layouts, GiveWayToTheScoreBar) {
  Busy busy(MissionPack::kNone);
  for (const HudLayout layout : kLayouts) {
    HudSettings settings;
    settings.layout = layout;
    EXPECT_TRUE(find_places(busy.draw({640, 480}, settings), "scorebar").empty());
    settings.shows_scores = true;
    const Commands drawn = busy.draw({640, 480}, settings);
    EXPECT_EQ(find_places(drawn, "scorebar").size(), 1u);
    EXPECT_TRUE(find_places(drawn, "face_inv2").empty()) << static_cast<int>(layout);
  }
}

// Power-ups with timers are not shown a second time in the corner.
TEST(Layouts, CornersShowPowerupsWithoutTimers) {
  const Busy busy(MissionPack::kNone);
  HudSettings settings;
  settings.layout = HudLayout::kCorners;
  EXPECT_EQ(find_places(busy.draw({640, 480}, settings), "sb_quad").size(), 1u);
  settings.notices.power_timers = true;
  EXPECT_EQ(find_places(busy.draw({640, 480}, settings), "sb_quad").size(), 1u);
}

}  // namespace
}  // namespace temblor::client
