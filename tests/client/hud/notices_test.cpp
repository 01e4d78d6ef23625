// The notices of the HUD: pickups, weapons, power-ups, and the direction of damage. Pictures are placeholders
// of the right sizes, so each drawing command can be named.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "client/hud/hud.h"
#include "client/no_pictures.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using assets::MissionPack;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// Bits of ClientData::items, from the documentation of QuakeC's `items` field.
constexpr std::uint32_t kHasShotgun = 1u << 0, kHasNailgun = 1u << 2, kHasLauncher = 1u << 5,
                        kShells = 1u << 8, kGreenArmor = 1u << 13, kSilverKey = 1u << 17, kSuit = 1u << 21,
                        kQuad = 1u << 22;

void set_number(Game& io_game, Stat stat, int value) {
  io_game.stats[static_cast<std::size_t>(stat)] = value;
}

// A game and its HUD, with one kind of notice.
struct NoticeScene {
  explicit NoticeScene(NoticeSettings notices, MissionPack pack = MissionPack::kNone)
      : hud(test::no_pictures(), pack) {
    // Without the bar, everything drawn belongs to the notices.
    settings.status_bar = StatusBar::kNone;
    settings.notices = notices;
    game.signon = kPlaying;
    set_number(game, Stat::kHealth, 50);
    set_number(game, Stat::kShells, 25);
    set_number(game, Stat::kActiveWeapon, kHasShotgun);
    game.data.items = kHasShotgun | kShells;
    step();
  }

  void step(double seconds = 0.1, const Events& events = {}) {
    time_s += seconds;
    hud.advance(game, events, time_s);
  }
  std::vector<render::DrawCommand> draw() const {
    render::DrawList list;
    hud.draw(game, time_s, 640, 480, settings, list);
    return list.commands;
  }
  // Names of pictures, and runs of characters as text, in the order of drawing.
  std::vector<std::string> names() const {
    constexpr const char* kKnown[] = {"face1",        "sb_armor1",    "sb_armor3",    "sb_shells",
                                      "sb_nails",     "sb_rocket",    "sb_cells",     "sb_key1",
                                      "sb_key2",      "sb_quad",      "sb_suit",      "sb_invis",
                                      "sb_invuln",    "inv_shotgun",  "inv2_shotgun", "inv_nailgun",
                                      "inv2_nailgun", "inv_srlaunch", "inv2_srlaunch"};
    std::vector<std::string> names;
    const std::vector<render::DrawCommand> commands = draw();
    const render::DrawCommand* before = nullptr;
    for (const render::DrawCommand& command : commands) {
      if (command.picture == &test::no_pictures().characters()) {
        const char letter = static_cast<char>(command.part_y / 8 * 16 + command.part_x / 8);
        if (before == nullptr || before->picture != command.picture || before->area.y != command.area.y)
          names.emplace_back();
        names.back() += letter;
      } else if (command.picture != nullptr) {
        for (const char* const name : kKnown)
          if (command.picture == test::no_pictures().find(name)) names.emplace_back(name);
      }
      if (command.picture != nullptr) before = &command;
    }
    return names;
  }

  Game game;
  Hud hud;
  HudSettings settings;
  double time_s = 10;
};

constexpr NoticeSettings kPickups{.pickups = true}, kWeapons{.weapons = true}, kTimers{.power_timers = true},
    kDamage{.damage = true};

TEST(Pickups, AreListedWithTheirAmountsNewestFirstFromTheBottom) {
  NoticeScene scene(kPickups);
  EXPECT_THAT(scene.names(), IsEmpty()) << "the first items are no pickups";
  set_number(scene.game, Stat::kHealth, 75);
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("face1", "+25"));
  set_number(scene.game, Stat::kShells, 45);
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("sb_shells", "+20", "face1", "+25"));
  scene.game.data.items |= kHasNailgun;
  set_number(scene.game, Stat::kNails, 30);
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("inv_nailgun", "sb_nails", "+30", "sb_shells", "+20"));
}

TEST(Pickups, OfEachKindHaveAnIcon) {
  NoticeScene scene(kPickups);
  const auto gain = [&](std::uint32_t items, Stat stat, int value) {
    scene.game.data.items |= items;
    set_number(scene.game, stat, value);
    scene.step();
    const std::vector<std::string> names = scene.names();
    scene.step(3);
    return names;
  };
  EXPECT_THAT(gain(kGreenArmor, Stat::kArmor, 100), ElementsAre("sb_armor1", "+100"));
  EXPECT_THAT(gain(0, Stat::kRockets, 5), ElementsAre("sb_rocket", "+5"));
  EXPECT_THAT(gain(0, Stat::kCells, 12), ElementsAre("sb_cells", "+12"));
  EXPECT_THAT(gain(kSilverKey, Stat::kCells, 12), ElementsAre("sb_key1"));
  EXPECT_THAT(gain(kQuad, Stat::kCells, 12), ElementsAre("sb_quad"));
  EXPECT_THAT(gain(kHasLauncher, Stat::kRockets, 10), ElementsAre("inv_srlaunch", "sb_rocket", "+5"));
}

TEST(Pickups, OfOneKindAddUpAndVanishAfterThreeSeconds) {
  NoticeScene scene(kPickups);
  set_number(scene.game, Stat::kShells, 45);
  scene.step();
  set_number(scene.game, Stat::kShells, 40);
  scene.step();
  set_number(scene.game, Stat::kShells, 60);
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("sb_shells", "+40"));
  scene.step(2.9);
  EXPECT_THAT(scene.names(), ElementsAre("sb_shells", "+40"));
  for (const render::DrawCommand& command : scene.draw()) EXPECT_LT(command.opacity, 0.25f) << "fades";
  scene.step(0.2);
  EXPECT_THAT(scene.names(), IsEmpty());
}

TEST(Pickups, AreNotAStartOrALoadOrARespawnOrARegeneration) {
  NoticeScene scene(kPickups);
  set_number(scene.game, Stat::kHealth, 51);
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty()) << "healing by a mod";
  Events flash;
  flash.bonus_flashes = 1;
  set_number(scene.game, Stat::kHealth, 53);
  scene.step(0.1, flash);
  EXPECT_THAT(scene.names(), ElementsAre("face1", "+2")) << "a box that fills up the health";
  scene.step(4);
  set_number(scene.game, Stat::kHealth, 0);
  scene.step();
  set_number(scene.game, Stat::kHealth, 100);
  set_number(scene.game, Stat::kShells, 99);
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty()) << "a respawn";
  Events level;
  level.new_level = true;
  scene.game.signon = 0;
  scene.step(0.1, level);
  set_number(scene.game, Stat::kNails, 99);
  scene.game.data.items |= kQuad | kHasNailgun;
  scene.game.signon = kPlaying;
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty()) << "a new level";
  set_number(scene.game, Stat::kNails, 200);
  scene.time_s = 5;
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty()) << "a demo was rewound";
}

// Dissolution of Eternity sends other counts for its other weapons: 1 << 12 is the lava nailgun.
TEST(Pickups, OfAMissionPackAreNoChangesOfWeapons) {
  NoticeScene scene(kPickups, MissionPack::kRogue);
  set_number(scene.game, Stat::kActiveWeapon, 12);
  set_number(scene.game, Stat::kNails, 90);
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty());
  set_number(scene.game, Stat::kNails, 95);
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("sb_nails", "+5"));
}

TEST(WeaponList, AppearsForASecondAfterAChange) {
  NoticeScene scene(kWeapons);
  scene.game.data.items |= kHasNailgun | kHasLauncher;
  set_number(scene.game, Stat::kNails, 7);
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty());
  set_number(scene.game, Stat::kActiveWeapon, kHasNailgun);
  scene.step();
  std::vector<std::string> names = scene.names();
  // Digits are the small ones of the character set, from 18 on.
  EXPECT_THAT(names, ElementsAre("inv_shotgun", "\x14\x17", "inv2_nailgun", "\x19", "inv_srlaunch", "\x12"));
  scene.step(0.9);
  EXPECT_FALSE(scene.names().empty());
  scene.step(0.5);
  EXPECT_THAT(scene.names(), IsEmpty());
  set_number(scene.game, Stat::kHealth, 0);
  scene.step();
  set_number(scene.game, Stat::kHealth, 100);
  set_number(scene.game, Stat::kActiveWeapon, kHasShotgun);
  scene.step();
  EXPECT_THAT(scene.names(), IsEmpty()) << "a respawn";
}

TEST(PowerTimers, CountDownFromThePickup) {
  NoticeScene scene(kTimers);
  scene.game.data.items |= kQuad;
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("sb_quad", "30"));
  scene.step(17.5);
  EXPECT_THAT(scene.names(), ElementsAre("sb_quad", "13"));
  scene.game.data.items |= kSuit;
  scene.step(9.5);
  EXPECT_THAT(scene.names(), UnorderedElementsAre("sb_quad", "\xb3", "sb_suit", "30")) << "the last seconds";
  scene.step(3.5);
  EXPECT_THAT(scene.names(), UnorderedElementsAre("sb_quad", "sb_suit", "27")) << "lasts longer than usual";
  scene.game.data.items &= ~kQuad;
  scene.step();
  EXPECT_THAT(scene.names(), ElementsAre("sb_suit", "27"));
}

TEST(PowerTimers, ShowNoNumberIfTheStartIsUnknown) {
  NoticeScene scene(kTimers);
  Events level;
  level.new_level = true;
  scene.game.data.items |= kQuad;
  scene.step(0.1, level);
  scene.step(5);
  EXPECT_THAT(scene.names(), ElementsAre("sb_quad"));
}

TEST(PowerTimers, EndWhenTheServerSays) {
  NoticeScene scene(kTimers);
  Events level;
  level.new_level = true;
  scene.game.data.items |= kQuad | kSuit;
  scene.game.powerup_ends_s[22] = static_cast<float>(scene.time_s + 12.5);
  scene.step(0.1, level);
  EXPECT_THAT(scene.names(), UnorderedElementsAre("sb_quad", "13", "sb_suit")) << "a saved game";
  scene.game.powerup_ends_s[21] = static_cast<float>(scene.time_s + 60);
  scene.step(1);
  EXPECT_THAT(scene.names(), UnorderedElementsAre("sb_quad", "12", "sb_suit", "59"));
  scene.game.powerup_ends_s[21] = static_cast<float>(scene.time_s + 200);
  scene.step(12);
  EXPECT_THAT(scene.names(), UnorderedElementsAre("sb_quad", "sb_suit")) << "three digits do not fit";
}

// The middle of what the arcs cover, relative to the crosshair, in units of its distance from there.
math::Vec2d find_arc(const NoticeScene& scene) {
  math::Vec2d sum(0);
  double area = 0;
  for (const render::DrawCommand& command : scene.draw()) {
    const render::ScreenRect& rect = command.area;
    const double part = static_cast<double>(rect.width) * rect.height;
    sum += part * math::Vec2d(rect.x + rect.width / 2.0 - 320, rect.y + rect.height / 2.0 - 240);
    area += part;
  }
  return area > 0 ? glm::normalize(sum / area) : sum;
}

TEST(DamageArcs, PointAtTheSourceAsTheCameraTurns) {
  test::Random random(5);
  for (int i = 0; i < 50; ++i) {
    NoticeScene scene(kDamage);
    const math::Vec3 eye(random.uniform(-4000, 4000), random.uniform(-4000, 4000), random.uniform(-200, 200));
    const double direction_deg = random.uniform(0, 360), yaw_deg = random.uniform(0, 360);
    const double angle = direction_deg / 180 * std::numbers::pi;
    Events events;
    events.damages.push_back(
        {.blood = 10, .from = eye + math::Vec3(500 * std::cos(angle), 500 * std::sin(angle), 30)});
    scene.step(0.1, events);
    scene.settings.camera.emplace();
    scene.settings.camera->origin_world = eye;
    scene.settings.camera->angles_deg = {20, static_cast<float>(yaw_deg), 0};
    // Yaw grows to the left. Forward is up on the screen.
    const double left = (direction_deg - yaw_deg) / 180 * std::numbers::pi;
    const math::Vec2d arc = find_arc(scene);
    EXPECT_NEAR(arc.x, -std::sin(left), 0.03) << direction_deg << ", " << yaw_deg;
    EXPECT_NEAR(arc.y, -std::cos(left), 0.03);
    scene.step(0.75);
    for (const render::DrawCommand& command : scene.draw()) EXPECT_NEAR(command.opacity, 0.5, 0.01);
    scene.step(0.35);
    EXPECT_TRUE(scene.draw().empty());
  }
}

TEST(DamageArcs, AreNotDrawnForDamageWithoutDirection) {
  NoticeScene scene(kDamage);
  scene.settings.camera.emplace();
  scene.settings.camera->origin_world = {100, 100, 24};
  Events events;
  events.damages = {{.blood = 5, .from = {}},               // a fall
                    {.blood = 5, .from = {100, 100, -50}},  // from below
                    {.from = {500, 0, 0}}};                 // no damage
  scene.step(0.1, events);
  EXPECT_TRUE(scene.draw().empty());
}

TEST(Notices, AreOffByDefaultAndUnderAHudProgram) {
  NoticeScene scene({true, true, true, true});
  scene.settings.camera.emplace();
  Events events;
  events.damages.push_back({.blood = 5, .from = {500, 0, 0}});
  scene.game.data.items |= kQuad;
  set_number(scene.game, Stat::kActiveWeapon, kHasNailgun);
  scene.step(0.1, events);
  EXPECT_FALSE(scene.draw().empty());
  HudSettings settings = scene.settings;
  scene.settings.parts.bars = false;
  EXPECT_TRUE(scene.draw().empty()) << "a HUD program draws its own";
  scene.settings = settings;
  scene.settings.notices = {};
  EXPECT_TRUE(scene.draw().empty());
}

}  // namespace
}  // namespace temblor::client
