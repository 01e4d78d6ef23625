// The heads-up display, drawn to indexed frames. Each picture has a color of its own, so the frame shows
// which picture is where.
#include "client/hud/hud.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>

#include "assets/stock/stock_pictures.h"
#include "formats/archives/wad.h"
#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/programs/temporary_folder.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::uint8_t kNothing = 0, kFirstPicture = 1, kInk = 254;
// Bits of ClientData::items, from the documentation of QuakeC's `items` field.
constexpr std::uint32_t kAllItems = 0xffffffffu;

struct FrameShape {
  int width, height, scale;
};
constexpr FrameShape kHudSizes[] = {
    {320, 200, 1}, {640, 480, 1}, {1920, 1080, 3}, {3840, 2160, 7}, {1000, 1600, 2}};

// Stock pictures, each filled with its own color; characters are solid squares of kInk.
class Art {
 public:
  Art() : pictures_(load()) {}
  const assets::Pictures& pictures() const { return pictures_; }
  std::uint8_t pick_index(const std::string& name) const { return indices_.at(name); }
  math::Vec2d picture_size(const std::string& name) const {
    const formats::Picture* picture = pictures_.find(name);
    return {picture->width, picture->height};
  }

 private:
  formats::Picture solid(const assets::StockPicture& stock) {
    const auto index = static_cast<std::uint8_t>(kFirstPicture + indices_.size());
    indices_[stock.name] = index;
    return {stock.width, stock.height,
            std::vector<std::uint8_t>(std::size_t{stock.width} * stock.height, index)};
  }
  assets::Pictures load() {
    const test::TemporaryFolder folder;
    std::vector<base::ByteVector> bytes;
    for (const assets::StockPicture& stock : assets::stock_wad_pictures())
      bytes.push_back(formats::write_picture(solid(stock)));
    std::vector<formats::WadLump> lumps;
    for (const assets::StockPicture& stock : assets::stock_wad_pictures())
      lumps.push_back({stock.name, formats::kWadPicture, bytes[lumps.size()]});
    const base::ByteVector characters(128 * 128, std::byte{kInk});
    lumps.push_back({"conchars", formats::kWadTexture, characters});
    folder.write("id1/gfx.wad", formats::write_wad(lumps).value());
    for (const assets::StockPicture& stock : assets::stock_picture_files())
      folder.write(std::string("id1/") + stock.name, formats::write_picture(solid(stock)));
    std::vector<std::string> notes;
    return assets::Pictures::load(vfs::FileSystem::open(folder.path()).value(), notes);
  }

  std::map<std::string, std::uint8_t> indices_;
  assets::Pictures pictures_;
};

const Art& art() {
  static const Art the_art;
  return the_art;
}

const render::Renderer& painter() {
  static const render::Renderer renderer({}, {});
  return renderer;
}

void set(Game& io_game, Stat stat, int value) {
  io_game.stats[static_cast<std::size_t>(stat)] = value;
}

// A healthy player who has had everything for a long time.
Game rich_game() {
  Game game;
  game.level_name = "Level";
  game.data.items = kAllItems;
  set(game, Stat::kHealth, 100);
  set(game, Stat::kArmor, 200);
  set(game, Stat::kAmmo, 100);
  set(game, Stat::kShells, 100);
  set(game, Stat::kNails, 200);
  set(game, Stat::kRockets, 100);
  set(game, Stat::kCells, 100);
  return game;
}

struct Drawn {
  int width = 0, height = 0, scale = 1;
  render::DrawList list;
  std::vector<std::uint8_t> pixels;

  // The next pixel with the index from `first` on, or null. Unlike std::find, memchr is quick without
  // optimization.
  static const std::uint8_t* find(const std::uint8_t* first, const std::uint8_t* end, std::uint8_t index) {
    return static_cast<const std::uint8_t*>(std::memchr(first, index, static_cast<std::size_t>(end - first)));
  }
  std::size_t count(const std::string& picture) const {
    const std::uint8_t index = art().pick_index(picture);
    const std::uint8_t* const end = pixels.data() + pixels.size();
    std::size_t count = 0;
    for (const std::uint8_t* at = pixels.data(); (at = find(at, end, index)) != nullptr; ++at) ++count;
    return count;
  }
  bool shows(const std::string& picture) const { return count(picture) > 0; }
  // The upper left corner, in the original's pixels from the bar's center and the frame's bottom.
  std::optional<math::Vec2d> corner(const std::string& picture) const {
    const auto index = art().pick_index(picture);
    std::optional<math::Vec2d> corner;
    for (int y = 0; y < height; ++y) {
      const std::uint8_t* const row = pixels.data() + std::ptrdiff_t{y} * width;
      const int columns = corner ? static_cast<int>(corner->x) : width;
      if (const std::uint8_t* const found = find(row, row + columns, index))
        corner = math::Vec2d(static_cast<double>(found - row), corner ? corner->y : y);
    }
    if (!corner) return corner;
    return math::Vec2d((corner->x - width / 2.0) / scale + 160, (corner->y - height) / scale);
  }
  // The characters drawn, row by row from the top, with a space for each gap.
  std::vector<std::string> lines() const {
    std::map<int, std::map<int, char>> rows;
    for (const render::DrawCommand& command : list.commands)
      if (command.picture == &art().pictures().characters())
        rows[command.area.y][command.area.x] =
            static_cast<char>(command.part_y / 8 * 16 + command.part_x / 8);
    std::vector<std::string> lines;
    for (const auto& [y, row] : rows) {
      lines.emplace_back();
      int next_x = row.begin()->first;
      for (const auto& [x, character] : row) {
        if (x > next_x) lines.back() += ' ';
        lines.back() += character;
        next_x = x + 8 * scale;
      }
    }
    return lines;
  }
};

Drawn draw(const Hud& hud, const Game& game, double time_s, const FrameShape& size = kHudSizes[0],
           const HudSettings& settings = {}) {
  Drawn drawn{size.width, size.height, settings.size.scale > 0 ? settings.size.scale : size.scale, {}, {}};
  hud.draw(game, time_s, size.width, size.height, settings, drawn.list);
  render::FrameBuffer frame(size.width, size.height, render::PixelFormat::kIndexed);
  std::fill(frame.indexed().begin(), frame.indexed().end(), kNothing);
  render::FrameStats stats;
  painter().draw_overlay(drawn.list, frame, stats);
  drawn.pixels.assign(frame.indexed().begin(), frame.indexed().end());
  return drawn;
}

// A time at which nothing flashes anymore.
Drawn draw_calm(const Game& game, const FrameShape& size = kHudSizes[0], const HudSettings& settings = {}) {
  return draw(Hud(art().pictures()), game, 1000, size, settings);
}

void expect_inside(const Drawn& drawn) {
  for (const render::DrawCommand& command : drawn.list.commands) {
    EXPECT_GE(command.area.x, 0);
    EXPECT_GE(command.area.y, 0);
    EXPECT_LE(command.area.x + command.area.width, drawn.width);
    EXPECT_LE(command.area.y + command.area.height, drawn.height);
    EXPECT_TRUE(command.picture == nullptr || command.scale == drawn.scale);
  }
}

TEST(Hud, FitsFramesOfEverySize) {
  for (const FrameShape& size : kHudSizes) {
    SCOPED_TRACE(testing::Message() << size.width << "x" << size.height);
    Game game = rich_game();
    game.level_name = std::string(60, 'x');
    game.paused = true;
    game.center_text = std::string(300, 'y');
    game.center_text_since_s = 999.5;
    expect_inside(draw_calm(game, size));
    set(game, Stat::kHealth, 0);
    expect_inside(draw_calm(game, size));
    game.deathmatch = true;
    game.players.assign(16, {std::string(15, 'z'), 999, 4, 13});
    expect_inside(draw_calm(game, size));
    game.ending = Ending::kIntermission;
    expect_inside(draw_calm(game, size));
    game.deathmatch = false;
    expect_inside(draw_calm(game, size));
    game.ending = Ending::kFinale;
    game.ending_text = std::string(400, 'x');
    expect_inside(draw_calm(game, size));
  }
}

TEST(Hud, IsCenteredAtTheBottom) {
  struct Place {
    const char* picture;
    double x, y;
  };
  // The bar's icons are 24 wide, at 0, 112 and 224; the inventory's slots are 24 and then 16 apart.
  constexpr Place kPlaces[] = {{"disc", 0, -24},        {"face_inv2", 112, -24},    {"sb_shells", 224, -24},
                               {"inv_shotgun", 0, -40}, {"inv_srlaunch", 120, -40}, {"inv_lightng", 144, -40},
                               {"sb_key1", 192, -40},   {"sb_key2", 208, -40},      {"sb_invis", 224, -40},
                               {"sb_invuln", 240, -40}, {"sb_suit", 256, -40},      {"sb_quad", 272, -40},
                               {"sb_sigil1", 288, -40}, {"sb_sigil4", 312, -40}};
  for (const FrameShape& size : kHudSizes) {
    const Drawn drawn = draw_calm(rich_game(), size);
    for (const Place& place : kPlaces) {
      SCOPED_TRACE(testing::Message() << place.picture << " at " << size.width << "x" << size.height);
      const auto corner = drawn.corner(place.picture);
      ASSERT_TRUE(corner);
      EXPECT_EQ(corner->x, place.x);
      EXPECT_EQ(corner->y, place.y);
      const math::Vec2d picture = art().picture_size(place.picture);
      EXPECT_EQ(drawn.count(place.picture), picture.x * picture.y * size.scale * size.scale);
    }
  }
}

TEST(Hud, ShowsThePlayersItems) {
  struct Part {
    std::uint32_t item;
    const char* picture;
  };
  constexpr Part kParts[] = {{1u << 0, "inv_shotgun"},  {1u << 1, "inv_sshotgun"}, {1u << 2, "inv_nailgun"},
                             {1u << 3, "inv_snailgun"}, {1u << 4, "inv_rlaunch"},  {1u << 5, "inv_srlaunch"},
                             {1u << 6, "inv_lightng"},  {1u << 8, "sb_shells"},    {1u << 9, "sb_nails"},
                             {1u << 10, "sb_rocket"},   {1u << 11, "sb_cells"},    {1u << 13, "sb_armor1"},
                             {1u << 14, "sb_armor2"},   {1u << 15, "sb_armor3"},   {1u << 17, "sb_key1"},
                             {1u << 18, "sb_key2"},     {1u << 19, "sb_invis"},    {1u << 20, "sb_invuln"},
                             {1u << 21, "sb_suit"},     {1u << 22, "sb_quad"},     {1u << 28, "sb_sigil1"},
                             {1u << 29, "sb_sigil2"},   {1u << 30, "sb_sigil3"},   {1u << 31, "sb_sigil4"},
                             {1u << 19, "face_invis"},  {1u << 20, "face_invul2"}, {1u << 22, "face_quad"}};
  for (const Part& part : kParts) {
    Game game = rich_game();
    game.data.items = part.item;
    const Drawn with = draw_calm(game);
    game.data.items = 0;
    const Drawn without = draw_calm(game);
    EXPECT_TRUE(with.shows(part.picture)) << part.picture;
    EXPECT_FALSE(without.shows(part.picture)) << part.picture;
    for (const Part& other : kParts)
      EXPECT_TRUE(other.item == part.item || !with.shows(other.picture))
          << part.picture << ", " << other.picture;
  }
}

TEST(Hud, HighlightsTheActiveWeapon) {
  Game game = rich_game();
  set(game, Stat::kActiveWeapon, 4);
  const Drawn drawn = draw_calm(game);
  EXPECT_TRUE(drawn.shows("inv2_nailgun"));
  EXPECT_FALSE(drawn.shows("inv_nailgun"));
  EXPECT_TRUE(drawn.shows("inv_shotgun"));
  EXPECT_FALSE(drawn.shows("inv2_shotgun"));
}

TEST(Hud, FlashesANewWeaponForASecond) {
  Hud hud(art().pictures());
  Game game = rich_game();
  game.data.items = 1;
  hud.advance(game, {}, 5);
  game.data.items = 1 | 1u << 5;
  hud.advance(game, {}, 10);
  EXPECT_TRUE(draw(hud, game, 10.05).shows("inva1_srlaunch"));
  EXPECT_TRUE(draw(hud, game, 10.15).shows("inva2_srlaunch"));
  EXPECT_TRUE(draw(hud, game, 10.45).shows("inva5_srlaunch"));
  EXPECT_TRUE(draw(hud, game, 10.55).shows("inva1_srlaunch"));
  EXPECT_TRUE(draw(hud, game, 11.05).shows("inv_srlaunch"));
  EXPECT_TRUE(draw(hud, game, 10.05).shows("inv_shotgun")) << "held for a long time";
  hud.advance(game, {}, 11);
  EXPECT_TRUE(draw(hud, game, 11.05).shows("inv_srlaunch")) << "a held weapon is not new";
}

TEST(Hud, ShowsAFaceForEachFifthOfHealth) {
  const auto face_at = [](int health) {
    Game game = rich_game();
    game.data.items = 0;
    set(game, Stat::kHealth, health);
    const Drawn drawn = draw_calm(game);
    std::string faces;
    for (const char* face : {"face1", "face2", "face3", "face4", "face5"})
      if (drawn.shows(face)) faces += face;
    return faces;
  };
  EXPECT_EQ(face_at(250), "face1");
  EXPECT_EQ(face_at(100), "face1");
  EXPECT_EQ(face_at(80), "face1");
  EXPECT_EQ(face_at(79), "face2");
  EXPECT_EQ(face_at(45), "face3");
  EXPECT_EQ(face_at(20), "face4");
  EXPECT_EQ(face_at(19), "face5");
  EXPECT_EQ(face_at(1), "face5");
}

TEST(Hud, ShowsPainForAFifthOfASecond) {
  Hud hud(art().pictures());
  Game game = rich_game();
  game.data.items = 0;
  Events events;
  events.damages.push_back({.armor = 0, .blood = 0});
  hud.advance(game, events, 9);
  EXPECT_TRUE(draw(hud, game, 9.1).shows("face1")) << "no damage";
  events.damages = {{.armor = 0, .blood = 7}};
  hud.advance(game, events, 10);
  EXPECT_TRUE(draw(hud, game, 10.1).shows("face_p1"));
  EXPECT_FALSE(draw(hud, game, 10.1).shows("face1"));
  EXPECT_TRUE(draw(hud, game, 10.3).shows("face1"));
  hud.advance(game, {}, 2);
  EXPECT_TRUE(draw(hud, game, 2).shows("face1")) << "a demo was rewound";
}

// The three digits of a bar at scale 1 from `first_x` on; "a" before digits in the warning color.
std::string digits_at(const Drawn& drawn, int first_x) {
  std::array<std::string, 3> digits{" ", " ", " "};
  for (const char* kind : {"num", "anum"})
    for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "minus"})
      for (const render::DrawCommand& command : drawn.list.commands) {
        const int x = command.area.x - first_x;
        if (command.picture == art().pictures().find(std::string(kind) + "_" + digit) && x >= 0 && x < 72)
          digits[static_cast<std::size_t>(x / 24)] = std::string(*kind == 'a' ? "a" : "") + digit;
      }
  return digits[0] + digits[1] + digits[2];
}

TEST(Hud, WarnsOfLowNumbers) {
  constexpr int kArmorX = 24, kHealthX = 136, kAmmoX = 248;
  Game game;
  const auto show = [&](int armor, int health, int ammo) {
    set(game, Stat::kArmor, armor);
    set(game, Stat::kHealth, health);
    set(game, Stat::kAmmo, ammo);
    return draw_calm(game, kHudSizes[0], {.status_bar = StatusBar::kSmall});
  };
  EXPECT_EQ(digits_at(show(150, 77, 888), kArmorX), "150");
  EXPECT_EQ(digits_at(show(111, 26, 333), kHealthX), " 26");
  EXPECT_EQ(digits_at(show(111, 25, 333), kHealthX), " a2a5");
  EXPECT_EQ(digits_at(show(25, 333, 111), kArmorX), " a2a5");
  EXPECT_EQ(digits_at(show(26, 333, 111), kArmorX), " 26");
  EXPECT_EQ(digits_at(show(333, 222, 10), kAmmoX), " a1a0");
  EXPECT_EQ(digits_at(show(333, 222, 14), kAmmoX), " 14");
  EXPECT_EQ(digits_at(show(222, 333, 5000), kAmmoX), "999") << "limited to three digits";
  EXPECT_EQ(digits_at(show(-7, 333, 222), kArmorX), " aminusa7");
  game.data.items = 1u << 20;
  const Drawn invulnerable = show(50, 333, 222);
  EXPECT_EQ(digits_at(invulnerable, kArmorX), "a6a6a6");
  EXPECT_TRUE(invulnerable.shows("disc"));
}

TEST(Hud, ShowsAmmoCounts) {
  Game game = rich_game();
  set(game, Stat::kNails, 7);
  const std::vector<std::string> lines = draw_calm(game).lines();
  std::string plain;
  for (const char c : lines.at(0)) plain += c >= 18 && c < 28 ? static_cast<char>('0' + c - 18) : c;
  EXPECT_EQ(plain, "100 7 100 100");
}

TEST(Hud, StatusBarHasTwoSizesAndOff) {
  const Game game = rich_game();
  const Drawn full = draw_calm(game);
  EXPECT_TRUE(full.shows("sbar") && full.shows("ibar"));
  const Drawn small = draw_calm(game, kHudSizes[0], {.status_bar = StatusBar::kSmall});
  EXPECT_TRUE(small.shows("sbar"));
  EXPECT_FALSE(small.shows("ibar") || small.shows("inv_shotgun"));
  EXPECT_THAT(draw_calm(game, kHudSizes[0], {.status_bar = StatusBar::kNone}).list.commands, IsEmpty());
}

TEST(Hud, ScalesByWholeNumbersThatFit) {
  const auto width_of_bar = [](int width, int height, int wished) {
    const Drawn drawn = draw_calm(rich_game(), {width, height, 1}, {.size = {.scale = wished}});
    for (const render::DrawCommand& command : drawn.list.commands)
      if (command.picture == art().pictures().find("sbar")) return command.area.width;
    return 0;
  };
  EXPECT_EQ(width_of_bar(320, 200, 0), 320);
  EXPECT_EQ(width_of_bar(160, 100, 0), 320);
  EXPECT_EQ(width_of_bar(1920, 1080, 0), 3 * 320);
  EXPECT_EQ(width_of_bar(3840, 2160, 0), 7 * 320);
  EXPECT_EQ(width_of_bar(1920, 1080, 1), 320);
  EXPECT_EQ(width_of_bar(1920, 1080, 5), 5 * 320);
  EXPECT_EQ(width_of_bar(1920, 1080, 6), 5 * 320) << "200 x 6 rows do not fit";
}

TEST(Hud, BackgroundCanBeTranslucent) {
  const Drawn drawn = draw_calm(rich_game(), kHudSizes[0], {.opacity = 0.5f});
  for (const render::DrawCommand& command : drawn.list.commands) {
    const bool is_ground =
        command.picture == art().pictures().find("sbar") || command.picture == art().pictures().find("ibar");
    EXPECT_EQ(command.opacity, is_ground ? 0.5f : 1.0f);
  }
}

TEST(Hud, ShowsTheLevelsScoresWhenDead) {
  Game game = rich_game();
  set(game, Stat::kHealth, -10);
  set(game, Stat::kMonsters, 7);
  set(game, Stat::kTotalMonsters, 142);
  set(game, Stat::kTotalSecrets, 3);
  const Drawn drawn = draw(Hud(art().pictures()), game, 125.9);
  EXPECT_TRUE(drawn.shows("scorebar"));
  EXPECT_FALSE(drawn.shows("sbar"));
  const std::vector<std::string> lines = drawn.lines();
  EXPECT_THAT(lines, Contains("Monsters: 7 /142 Time : 2:05"));
  EXPECT_THAT(lines, Contains("Secrets : 0 / 3 Level"));
}

TEST(Hud, ShortensLongLevelNames) {
  Game game = rich_game();
  set(game, Stat::kHealth, -10);
  game.level_name = "Exactly twenty chars";
  EXPECT_THAT(draw_calm(game).lines(), Contains(testing::EndsWith("0 / 0 Exactly twenty chars")));
  game.level_name = "The long way down to the old mines";
  EXPECT_THAT(draw_calm(game).lines(), Contains(testing::EndsWith("0 / 0 The long way down...")));
}

// A second after death a hint says what the player can do, above everything else at the bottom.
TEST(Hud, ShowsAHintAfterDeath) {
  Hud hud(art().pictures());
  Game game = rich_game();
  const HudSettings settings{.death_hint = "Fire: this\nJump: that"};
  hud.advance(game, {}, 10);
  EXPECT_THAT(draw(hud, game, 20, kHudSizes[0], settings).lines(), Not(Contains("Fire: this")));
  set(game, Stat::kHealth, 0);
  hud.advance(game, {}, 20);
  hud.advance(game, {}, 20.5);
  EXPECT_THAT(draw(hud, game, 20.9, kHudSizes[0], settings).lines(), Not(Contains("Fire: this")));
  hud.advance(game, {}, 21);
  for (const FrameShape& size : kHudSizes) {
    const Drawn drawn = draw(hud, game, 21.1, size, settings);
    EXPECT_THAT(drawn.lines(), testing::IsSupersetOf({"Fire: this", "Jump: that"}));
    expect_inside(drawn);
  }
  set(game, Stat::kHealth, 50);
  hud.advance(game, {}, 22);
  set(game, Stat::kHealth, -1);
  hud.advance(game, {}, 23);
  EXPECT_THAT(draw(hud, game, 23.5, kHudSizes[0], settings).lines(), Not(Contains("Fire: this")))
      << "dead again";
}

Game deathmatch() {
  Game game = rich_game();
  game.deathmatch = true;
  game.players = {{"Ann", 3, 4, 13}, {"Bob", 12, 0, 15}, {"", 50, 0, 0},
                  {"Cid", 3, 1, 2},  {"Dot", -1, 9, 9},  {"Eve", 0, 5, 6}};
  game.view_entity = 4;
  return game;
}

TEST(Hud, ShowsTheLeadersOfADeathmatch) {
  const Drawn drawn = draw_calm(deathmatch());
  EXPECT_THAT(drawn.lines().at(0), testing::EndsWith("12 3 \x10 3\x11 0")) << "the viewer's own in brackets";
  const auto has_fill = [&](int index) {
    return std::any_of(drawn.list.commands.begin(), drawn.list.commands.end(), [&](const auto& command) {
      return command.picture == nullptr && command.fill == index;
    });
  };
  EXPECT_TRUE(has_fill(15 * 16 + 8)) << "the leader's pants";
  EXPECT_FALSE(has_fill(9 * 16 + 8)) << "the fifth player is not shown";
  Game alone = deathmatch();
  alone.deathmatch = false;
  EXPECT_THAT(draw_calm(alone).lines().at(0), Not(testing::HasSubstr("12")));
}

TEST(Hud, ShowsTheScoresOfTheGameMode) {
  Game game = deathmatch();
  set(game, Stat::kTotalMonsters, 9);
  const HudSettings settings{.shows_scores = true};
  std::vector<std::string> lines = draw_calm(game, kHudSizes[1], settings).lines();
  EXPECT_THAT(lines, Contains(testing::StartsWith("Frags: 3 Time"))) << "Cid's";
  EXPECT_THAT(lines, Contains("Place: 2 / 5 Level")) << "only Bob has more";
  EXPECT_THAT(lines, Not(Contains(testing::HasSubstr("Monsters"))));
  EXPECT_THAT(lines, Not(Contains(testing::HasSubstr("Secrets"))));
  EXPECT_THAT(lines, Contains("12 Bob"));
  // In co-op the monsters and secrets count.
  game.deathmatch = false;
  lines = draw_calm(game, kHudSizes[1], settings).lines();
  EXPECT_THAT(lines, Contains(testing::StartsWith("Monsters: 0 / 9 Time")));
  EXPECT_THAT(lines, Contains("12 Bob"));
}

TEST(Hud, ShowsTheRankingWhenDead) {
  Game game = deathmatch();
  EXPECT_FALSE(draw_calm(game).shows("gfx/ranking.lmp"));
  set(game, Stat::kHealth, 0);
  const Drawn drawn = draw_calm(game, kHudSizes[2]);
  EXPECT_TRUE(drawn.shows("gfx/ranking.lmp"));
  std::vector<std::string> lines = drawn.lines();
  lines.resize(5);
  EXPECT_THAT(lines, ElementsAre("12 Bob", "3 Ann", "3 \r Cid", "0 Eve", "-1 Dot"));
  game.ending = Ending::kIntermission;
  EXPECT_TRUE(draw_calm(game).shows("gfx/ranking.lmp"));
  EXPECT_FALSE(draw_calm(game).shows("gfx/inter.lmp"));
}

TEST(Hud, ShowsTheSumsOfTeamsAboveTheRanking) {
  Game game = deathmatch();
  set(game, Stat::kHealth, 0);
  const std::vector<std::string> without = draw_calm(game, kHudSizes[2]).lines();
  for (Player& player : game.players) player.pants = player.name == "Bob" ? 4 : 13;
  for (const int teamplay : {1, 2})
    EXPECT_THAT(draw_calm(game, kHudSizes[2], {.teamplay = teamplay}).lines(), Contains("12 5")) << teamplay;
  EXPECT_EQ(draw_calm(game, kHudSizes[2], {.teamplay = 3}).lines(), without) << "captures count, not frags";
  for (Player& player : game.players) player.pants = 4;
  EXPECT_EQ(draw_calm(game, kHudSizes[2], {.teamplay = 1}).lines(), without) << "one team";
  game.ending = Ending::kIntermission;
  game.players[0].pants = 13;
  EXPECT_GT(draw_calm(game, kHudSizes[2], {.teamplay = 1}).lines().size(),
            draw_calm(game, kHudSizes[2]).lines().size());
}

TEST(Hud, ShowsTheCapturesOfTeamsAboveTheRanking) {
  Game game = deathmatch();
  set(game, Stat::kHealth, 0);
  for (Player& player : game.players) player.pants = player.name == "Bob" ? 4 : 13;
  game.captures[4] = 0;
  game.captures[13] = 2;
  EXPECT_THAT(draw_calm(game, kHudSizes[2], {.teamplay = 3}).lines(), Contains("Captures 2 0"));
  game.ending = Ending::kIntermission;
  EXPECT_THAT(draw_calm(game, kHudSizes[2], {.teamplay = 3}).lines(), Contains("Captures 2 0"));
}

TEST(Hud, CentersTextForTwoSeconds) {
  Game game = rich_game();
  game.center_text = "one\ntwo three\n\nfour";
  game.center_text_since_s = 10;
  const Hud hud(art().pictures());
  EXPECT_THAT(draw(hud, game, 11.9).lines(), Contains("two three"));
  EXPECT_THAT(draw(hud, game, 12.1).lines(), Not(Contains("two three")));
  for (const FrameShape& size : kHudSizes) {
    const Drawn drawn = draw(hud, game, 11, size);
    int left = size.width, right = 0, top = size.height;
    for (const render::DrawCommand& command : drawn.list.commands)
      if (command.picture == &art().pictures().characters() && command.area.y < size.height * 3 / 5) {
        left = std::min(left, command.area.x);
        right = std::max(right, command.area.x + command.area.width);
        top = std::min(top, command.area.y);
      }
    EXPECT_EQ(right - left, 9 * 8 * size.scale);
    EXPECT_LE(std::abs(left - (size.width - right)), size.scale);
    EXPECT_EQ(top, static_cast<int>(size.height * 0.35));
  }
}

TEST(Hud, BreaksLinesOfMoreThanFortyCharacters) {
  Game game = rich_game();
  game.center_text = std::string(40, 'a') + "\n" + std::string(41, 'b') + "\nc";
  game.center_text_since_s = 999;
  const std::vector<std::string> lines = draw_calm(game).lines();
  EXPECT_EQ(lines.at(0), std::string(40, 'a'));
  EXPECT_EQ(lines.at(1), std::string(40, 'b'));
  EXPECT_EQ(lines.at(2), "b");
  EXPECT_EQ(lines.at(3), "c");
}

TEST(Hud, WritesTheFinaleLetterByLetter) {
  Game game = rich_game();
  game.ending = Ending::kFinale;
  game.ending_since_s = 100;
  game.ending_text = "abcdefgh\nijkl";
  const Hud hud(art().pictures());
  const auto letters_at = [&](double time_s) {
    std::string letters;
    for (const std::string& line : draw(hud, game, time_s).lines()) letters += line;
    return letters;
  };
  EXPECT_EQ(letters_at(100), "");
  EXPECT_EQ(letters_at(100.5), "abcd");
  EXPECT_EQ(letters_at(101.13), "abcdefghi") << "line ends take no time";
  EXPECT_EQ(letters_at(200), "abcdefghijkl");
  const Drawn drawn = draw(hud, game, 101);
  EXPECT_TRUE(drawn.shows("gfx/finale.lmp"));
  EXPECT_FALSE(drawn.shows("sbar"));
  game.ending = Ending::kCutScene;
  EXPECT_FALSE(draw(hud, game, 101).shows("gfx/finale.lmp"));
  EXPECT_EQ(letters_at(200), "abcdefghijkl");
}

// At 640 x 480, text is larger than the title.
TEST(Hud, TextOfTheFinaleIsBelowItsTitle) {
  Game game = rich_game();
  game.ending = Ending::kFinale;
  game.ending_text = "one\ntwo\nthree\nfour\nfive\nsix\nseven\nlast";
  const Drawn drawn = draw_calm(game, {640, 480, 2}, {.size = {.text = 1.5f}});
  int title_bottom = 0, text_top = drawn.height;
  for (const render::DrawCommand& command : drawn.list.commands)
    if (command.picture == &art().pictures().characters())
      text_top = std::min(text_top, command.area.y);
    else
      title_bottom = std::max(title_bottom, command.area.y + command.area.height);
  EXPECT_GT(title_bottom, 0);
  EXPECT_GE(text_top, title_bottom);
}

TEST(Hud, ShowsTheIntermission) {
  Game game = rich_game();
  game.ending = Ending::kIntermission;
  game.ending_since_s = 754;  // 12:34
  set(game, Stat::kSecrets, 5);
  set(game, Stat::kTotalSecrets, 6);
  set(game, Stat::kMonsters, 78);
  set(game, Stat::kTotalMonsters, 90);
  for (const double time_s : {760.0, 900.0}) {
    const Drawn drawn = draw(Hud(art().pictures()), game, time_s);
    EXPECT_TRUE(drawn.shows("gfx/complete.lmp") && drawn.shows("gfx/inter.lmp"));
    EXPECT_FALSE(drawn.shows("sbar"));
    // 12 : 34, 5 / 6, 78 / 90: each digit once, at the rows of the original's screen.
    const auto place = [&](const char* picture) { return *drawn.corner(picture) + math::Vec2d(0, 200); };
    EXPECT_EQ(place("num_1"), math::Vec2d(184, 64));
    EXPECT_EQ(place("num_2"), math::Vec2d(208, 64));
    EXPECT_EQ(place("num_colon").y, 64);
    EXPECT_EQ(place("num_4"), math::Vec2d(272, 64));
    EXPECT_EQ(place("num_5"), math::Vec2d(208, 104));
    EXPECT_EQ(place("num_6"), math::Vec2d(296, 104));
    EXPECT_EQ(place("num_7"), math::Vec2d(184, 144));
    EXPECT_EQ(place("num_0"), math::Vec2d(296, 144));
  }
}

TEST(Hud, ShowsTheParTimeInGoldIfItIsReached) {
  Game game = rich_game();
  game.ending = Ending::kIntermission;
  HudSettings settings;
  settings.par_s = 270;
  const auto text_after = [&](double ending_since_s) {
    game.ending_since_s = ending_since_s;
    const std::vector<std::string> lines = draw_calm(game, kHudSizes[0], settings).lines();
    return lines.empty() ? std::string() : lines.at(0);
  };
  const auto in_gold = [](std::string text) {
    for (char& letter : text)
      if (letter != ' ') letter = static_cast<char>(letter | 0x80);
    return text;
  };
  EXPECT_EQ(text_after(271.5), "par 4:30");
  EXPECT_EQ(text_after(270.5), in_gold("par 4:30"));  // shown as 4:30
  settings.par_s = 0;
  EXPECT_EQ(text_after(10), "");
}

TEST(Hud, ShowsThatTheGameIsPaused) {
  Game game = rich_game();
  EXPECT_FALSE(draw_calm(game).shows("gfx/pause.lmp"));
  game.paused = true;
  EXPECT_TRUE(draw_calm(game).shows("gfx/pause.lmp"));
}

// Drawing must not allocate in the steady state.
TEST(Hud, AllocatesNothingInTheSteadyState) {
  Game game;
  game.data.items = kAllItems;
  game.level_name = "a name that is longer than a string has room for in itself";
  game.center_text = game.ending_text =
      "several\nlines of text, some of them of many more than forty characters";
  for (int i = 0; i < 255; ++i)
    game.players.push_back({fmt::format("player number {}", i), static_cast<std::int16_t>(i % 50)});
  const Hud hud(art().pictures());
  render::DrawList list;
  const auto draw_all = [&] {
    for (const Ending ending : {Ending::kNone, Ending::kIntermission, Ending::kFinale, Ending::kCutScene})
      for (const std::int32_t health : {0, 100, 999})
        for (const bool deathmatch : {false, true}) {
          game.ending = ending;
          game.stats.fill(health);
          game.deathmatch = deathmatch;
          list.clear();
          hud.draw(game, 1, 640, 480, {}, list);
        }
  };
  draw_all();
  const std::size_t before = test::allocation_count();
  draw_all();
  EXPECT_EQ(test::allocation_count() - before, 0u);
}

// The largest text still shows a message of several words without losing any of them.
TEST(Hud, TextSizeWorksInFramesOfAnySize) {
  struct Size {
    int width, height;
    // At 50, 100, 200 and 400 %: frame pixels per pixel of the status bar, and of text.
    std::array<int, 4> bars, text;
  };
  constexpr Size kSizes[] = {{320, 200, {1, 1, 1, 1}, {1, 1, 2, 2}},
                             {640, 480, {1, 1, 2, 2}, {1, 1, 2, 4}},
                             {1280, 720, {1, 2, 3, 3}, {1, 2, 4, 8}},
                             {1920, 1080, {2, 3, 5, 5}, {2, 3, 6, 12}}};
  constexpr std::array<float, 4> kTextSizes = {0.5f, 1, 2, 4};
  Game game = rich_game();
  game.center_text = "You found a secret area behind the old copper pipes!";
  game.center_text_since_s = 999.5;
  for (const Size& size : kSizes)
    for (std::size_t i = 0; i < kTextSizes.size(); ++i) {
      SCOPED_TRACE(testing::Message() << size.width << "x" << size.height << ", " << kTextSizes[i]);
      const client::HudSize chosen{.text = kTextSizes[i]};
      EXPECT_EQ(choose_scale(size.width, size.height, chosen), size.bars[i]);
      EXPECT_EQ(choose_text_scale(size.width, size.height, chosen), size.text[i]);
      const Drawn drawn = draw_calm(game, {size.width, size.height, size.bars[i]}, {.size = chosen});
      std::string words;
      for (const render::DrawCommand& command : drawn.list.commands) {
        if (command.picture != &art().pictures().characters() || command.scale != size.text[i]) continue;
        const char letter = static_cast<char>(command.part_y / 8 * 16 + command.part_x / 8);
        if (letter < '!') continue;  // the digits of the ammo counts
        words += letter;
        EXPECT_GE(command.area.x, 0);
        EXPECT_LE(command.area.x + command.area.width, size.width);
        EXPECT_GE(command.area.y, 0);
        EXPECT_LE(command.area.y + command.area.height, size.height);
      }
      EXPECT_EQ(words, "Youfoundasecretareabehindtheoldcopperpipes!");
    }
}

TEST(Hud, SurvivesAnyGame) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::effort(500, 60)); ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const auto text = [&](std::size_t most) {
      std::string out;
      for (std::size_t size = random.below(most + 1); out.size() < size;)
        out += static_cast<char>(random.bits());
      return out;
    };
    Game game;
    for (std::int32_t& stat : game.stats)
      stat = static_cast<std::int32_t>(random.chance(0.5) ? random.bits() : random.below(300));
    game.data.items = static_cast<std::uint32_t>(random.bits());
    game.deathmatch = random.chance(0.5);
    game.level_name = text(100);
    game.center_text = text(500);
    game.ending = static_cast<Ending>(random.below(4));
    game.ending_since_s = random.uniform(-1e9, 1e9);
    game.ending_text = text(500);
    game.paused = random.chance(0.5);
    for (std::size_t players = random.below(40); game.players.size() < players;)
      game.players.push_back({text(40), static_cast<std::int16_t>(random.bits()),
                              static_cast<std::uint8_t>(random.bits()),
                              static_cast<std::uint8_t>(random.bits())});
    const FrameShape size{1 + static_cast<int>(random.below(1500)), 1 + static_cast<int>(random.below(1000)),
                          1};
    Hud hud(art().pictures());
    hud.advance(game, {}, random.uniform(-1e9, 1e9));
    const Drawn drawn =
        draw(hud, game, random.uniform(-1e9, 1e9), size,
             {.size = {static_cast<int>(random.below(20)), static_cast<float>(random.uniform(0.5, 4))},
              .opacity = static_cast<float>(random.uniform(0, 1))});
    EXPECT_EQ(drawn.pixels.size(), static_cast<std::size_t>(size.width * size.height));
  }
}

}  // namespace
}  // namespace temblor::client
