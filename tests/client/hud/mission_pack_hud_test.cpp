// The status bars of the mission packs. The places are those that QuakeSpasm 0.95 showed with the options
// -hipnotic and -rogue, for a program that sets the items and a gfx.wad with a color for each picture.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "assets/stock/stock_pictures.h"
#include "client/hud/hud.h"
#include "formats/archives/wad.h"
#include "support/programs/temporary_folder.h"

namespace temblor::client {
namespace {

using assets::MissionPack;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// A game whose gfx.wad has these pictures besides the stock ones.
class PackArt {
 public:
  explicit PackArt(const std::vector<std::string>& names) {
    const base::ByteVector bytes =
        formats::write_picture({8, 8, std::vector<std::uint8_t>(std::size_t{64}, std::uint8_t{5})});
    std::vector<formats::WadLump> lumps;
    for (const assets::StockPicture& stock : assets::stock_wad_pictures()) names_.insert(stock.name);
    names_.insert(names.begin(), names.end());
    for (const std::string& name : names_) lumps.push_back({name, formats::kWadPicture, bytes});
    const test::TemporaryFolder folder;
    folder.write("id1/gfx.wad", formats::write_wad(lumps).value());
    std::vector<std::string> notes;
    pictures_ = assets::Pictures::load(vfs::FileSystem::open(folder.path()).value(), notes);
  }
  const assets::Pictures& pictures() const { return pictures_; }
  std::string name(const formats::Picture* picture) const {
    for (const std::string& name : names_)
      if (pictures_.find(name) == picture) return name;
    return "";
  }

 private:
  std::set<std::string> names_;
  assets::Pictures pictures_;
};

const PackArt& pack_art() {
  static const PackArt art = [] {
    std::vector<std::string> names = {"r_invbar1",   "r_invbar2",    "r_lava",    "r_superlava", "r_gren",
                                      "r_multirock", "r_plasma",     "r_shield1", "r_agrav1",    "r_ammolava",
                                      "r_ammomulti", "r_ammoplasma", "sb_wsuit",  "sb_eshld"};
    for (const char* state : {"inv", "inv2", "inva1", "inva2", "inva3", "inva4", "inva5"})
      for (const char* weapon : {"laser", "mjolnir", "gren_prox", "prox_gren", "prox"})
        names.push_back(fmt::format("{}_{}", state, weapon));
    return PackArt(names);
  }();
  return art;
}

Game game_with_items(std::uint32_t items, int weapon_index) {
  Game game;
  game.data.items = items;
  game.stats[static_cast<std::size_t>(Stat::kHealth)] = 100;
  game.stats[static_cast<std::size_t>(Stat::kActiveWeapon)] = weapon_index;
  return game;
}

// Returns "PICTURE X Y" of each item on top at its place, from the upper left corner of the status bar.
std::vector<std::string> visible_items(const Hud& hud, const PackArt& art, const Game& game, double time_s) {
  render::DrawList list;
  hud.draw(game, time_s, 320, 200, {}, list);
  std::map<std::pair<int, int>, std::string> at;
  for (const render::DrawCommand& command : list.commands)
    at[{command.area.x, command.area.y - 176}] = art.name(command.picture);
  std::vector<std::string> items;
  for (const auto& [place, name] : at)
    if (!name.empty() && name != "sbar" && !name.starts_with("num_") && !name.starts_with("anum_") &&
        !name.starts_with("face") && name != "ibar" && name != "r_invbar2")
      items.push_back(fmt::format("{} {} {}", name, place.first, place.second));
  return items;
}

std::vector<std::string> visible_items(MissionPack pack, std::uint32_t items, int weapon_index) {
  return visible_items(Hud(pack_art().pictures(), pack), pack_art(), game_with_items(items, weapon_index),
                       1000);
}

constexpr std::uint32_t bit(int index) {
  return std::uint32_t{1} << index;
}
constexpr int kAxe = 12, kRogueAxe = 11;

TEST(HipnoticHud, ShowsItsWeapons) {
  const auto shown = [](std::uint32_t items, int weapon) {
    return visible_items(MissionPack::kHipnotic, items, weapon);
  };
  EXPECT_THAT(shown(bit(4), 4), UnorderedElementsAre("inv2_rlaunch 96 -16"));
  EXPECT_THAT(shown(bit(16), 16), UnorderedElementsAre("inv2_prox 96 -16"));
  EXPECT_THAT(shown(bit(16), kAxe), UnorderedElementsAre("inv_prox 96 -16"));
  EXPECT_THAT(shown(bit(4) | bit(16), kAxe), UnorderedElementsAre("inv_prox_gren 96 -16"));
  EXPECT_THAT(shown(bit(4) | bit(16), 4), UnorderedElementsAre("inv2_gren_prox 96 -16"));
  EXPECT_THAT(shown(bit(4) | bit(16), 16), UnorderedElementsAre("inv2_prox_gren 96 -16"));
  EXPECT_THAT(shown(bit(7), 7), UnorderedElementsAre("inv2_mjolnir 200 -16"));
  EXPECT_THAT(shown(bit(7), kAxe), UnorderedElementsAre("inv_mjolnir 200 -16"));
  EXPECT_THAT(shown(bit(23), 23), UnorderedElementsAre("inv2_laser 176 -16"));
  EXPECT_THAT(shown(bit(23), kAxe), UnorderedElementsAre("inv_laser 176 -16"));
  EXPECT_THAT(shown(bit(0) | bit(6), 0), UnorderedElementsAre("inv2_shotgun 0 -16", "inv_lightng 144 -16"));
}

TEST(HipnoticHud, ShowsItsKeysAndPowerups) {
  const auto shown = [](std::uint32_t items) { return visible_items(MissionPack::kHipnotic, items, kAxe); };
  EXPECT_THAT(shown(bit(17) | bit(18)), UnorderedElementsAre("sb_key1 209 3", "sb_key2 209 12"));
  EXPECT_THAT(shown(bit(24)), UnorderedElementsAre("sb_wsuit 288 -16"));
  EXPECT_THAT(shown(bit(25)), UnorderedElementsAre("sb_eshld 304 -16"));
  EXPECT_THAT(shown(bit(26) | bit(27)), IsEmpty());
  EXPECT_THAT(shown(bit(21) | bit(31)), UnorderedElementsAre("sb_suit 256 -16", "sb_sigil4 312 -16"));
  EXPECT_THAT(shown(bit(8) | bit(13)), UnorderedElementsAre("sb_armor1 0 0", "sb_shells 224 0"));
}

TEST(HipnoticHud, BothLaunchersFlashInOnePicture) {
  Hud hud(pack_art().pictures(), MissionPack::kHipnotic);
  hud.advance(game_with_items(bit(16), kAxe), {}, 5);
  const Game both = game_with_items(bit(4) | bit(16), kAxe);
  hud.advance(both, {}, 10);
  const auto at = [&](double time_s) { return visible_items(hud, pack_art(), both, time_s); };
  EXPECT_THAT(at(10.25), UnorderedElementsAre("inva3_gren_prox 96 -16"));
  EXPECT_THAT(at(11.05), UnorderedElementsAre("inv_prox_gren 96 -16"));
}

TEST(RogueHud, ShowsTheWeaponsOfOtherAmmo) {
  const auto shown = [](std::uint32_t items, int weapon) {
    return visible_items(MissionPack::kRogue, items, weapon);
  };
  EXPECT_THAT(shown(bit(2), kRogueAxe), UnorderedElementsAre("inv_nailgun 48 -16"));
  EXPECT_THAT(shown(bit(2), 2), UnorderedElementsAre("inv2_nailgun 48 -16"));
  const std::string bar = "r_invbar1 0 -24";
  EXPECT_THAT(shown(bit(2) | bit(12), 12), UnorderedElementsAre(bar, "r_lava 48 -16"));
  EXPECT_THAT(shown(bit(13), 13), UnorderedElementsAre(bar, "r_superlava 72 -16"));
  EXPECT_THAT(shown(bit(14), 14), UnorderedElementsAre(bar, "r_gren 96 -16"));
  EXPECT_THAT(shown(bit(15), 15), UnorderedElementsAre(bar, "r_multirock 120 -16"));
  EXPECT_THAT(shown(bit(6) | bit(16), 16), UnorderedElementsAre(bar, "r_plasma 144 -16"));
  EXPECT_THAT(shown(bit(12) | bit(16), kRogueAxe), IsEmpty());
}

TEST(RogueHud, ShowsItsAmmoArmorAndPowerups) {
  struct Part {
    int bit;
    const char* shown;
  };
  constexpr Part kParts[] = {{7, "sb_shells 224 0"},    {8, "sb_nails 224 0"},     {9, "sb_rocket 224 0"},
                             {10, "sb_cells 224 0"},    {17, "sb_key1 192 -16"},   {18, "sb_key2 208 -16"},
                             {19, "sb_invis 224 -16"},  {21, "sb_suit 256 -16"},   {22, "sb_quad 272 -16"},
                             {23, "sb_armor1 0 0"},     {24, "sb_armor2 0 0"},     {25, "sb_armor3 0 0"},
                             {26, "r_ammolava 224 0"},  {27, "r_ammomulti 224 0"}, {28, "r_ammoplasma 224 0"},
                             {29, "r_shield1 288 -16"}, {30, "r_agrav1 304 -16"}};
  for (const Part& part : kParts)
    EXPECT_THAT(visible_items(MissionPack::kRogue, bit(part.bit), kRogueAxe),
                UnorderedElementsAre(part.shown));
  EXPECT_THAT(visible_items(MissionPack::kRogue, bit(31) | bit(11), kRogueAxe), IsEmpty());
}

// The characters and fills on top of the team frame: "CODE X Y" and "fill COLOR X Y".
std::vector<std::string> team_frame_parts(MissionPack pack, const Player& player, int teamplay,
                                          std::size_t players = 4) {
  static const PackArt art({"r_teambord"});
  Game game = game_with_items(0, kRogueAxe);
  game.players.assign(players, {});
  game.players[0] = player;
  game.view_entity = 1;
  render::DrawList list;
  Hud(art.pictures(), pack).draw(game, 1000, 320, 200, {.teamplay = teamplay}, list);
  std::vector<std::string> parts;
  for (const render::DrawCommand& command : list.commands) {
    const int x = command.area.x, y = command.area.y - 176;
    if (x < 112 || x >= 136 || y < 0) continue;
    if (command.picture == nullptr)
      parts.push_back(
          fmt::format("fill {} {} {} {}x{}", command.fill, x, y, command.area.width, command.area.height));
    else if (command.picture == &art.pictures().characters())
      parts.push_back(fmt::format("char {} {} {}", command.part_x / 8 + command.part_y / 8 * 16, x, y));
    else
      parts.push_back(fmt::format("{} {} {}", art.name(command.picture), x, y));
  }
  return parts;
}

TEST(RogueHud, TeamsWithFlagsSeeTheirColorsInsteadOfAFace) {
  const Player red{.name = "a", .frags = -12, .shirt = 4, .pants = 12};
  using ::testing::ElementsAre;
  for (const int teamplay : {4, 5, 6})
    EXPECT_THAT(team_frame_parts(MissionPack::kRogue, red, teamplay),
                ElementsAre("r_teambord 112 0", "fill 72 113 3 22x9", "fill 200 113 12 22x9", "char 45 113 3",
                            "char 49 120 3", "char 50 127 3"));
  const Player white{.name = "a", .frags = 123, .shirt = 0, .pants = 12};
  EXPECT_THAT(team_frame_parts(MissionPack::kRogue, white, 4),
              ElementsAre("r_teambord 112 0", "fill 8 113 3 22x9", "fill 200 113 12 22x9", "char 19 113 3",
                          "char 20 120 3", "char 21 127 3"));
  for (const int teamplay : {0, 1, 3, 7})
    EXPECT_THAT(team_frame_parts(MissionPack::kRogue, red, teamplay), ElementsAre("face1 112 0"));
  EXPECT_THAT(team_frame_parts(MissionPack::kRogue, red, 4, 1), ElementsAre("face1 112 0")) << "alone";
  EXPECT_THAT(team_frame_parts(MissionPack::kHipnotic, red, 4), ElementsAre("face1 112 0"));
}

// The server may be of another game, and a mod's gfx.wad may lack the pictures of its pack.
TEST(MissionPackHud, WithstandsOtherServersAndPictures) {
  const PackArt stock({});
  for (const MissionPack pack : {MissionPack::kNone, MissionPack::kHipnotic, MissionPack::kRogue})
    for (const int weapon : {-1, 0, 12, 16, 23, 31, 32, 255}) {
      const Hud hud(stock.pictures(), pack);
      render::DrawList list;
      hud.draw(game_with_items(0xffffffffu, weapon), 1000, 320, 200, {}, list);
      const auto draws = [&](const char* name) {
        return std::ranges::any_of(list.commands, [&](const render::DrawCommand& command) {
          return command.picture == stock.pictures().find(name);
        });
      };
      EXPECT_TRUE(draws("ibar") && draws("sbar") && draws("sb_quad"));
      EXPECT_TRUE(draws("inv_nailgun")) << weapon;
    }
}

}  // namespace
}  // namespace temblor::client
