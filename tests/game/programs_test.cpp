// The programs that the build compiles from game/: they have what engines require, and what the stock levels
// require.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "base/check.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "formats/levels/map.h"
#include "game/program_file.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Le;

const std::filesystem::path kGames = TEMBLOR_GAMES;

// Numbers of stock Quake's built-in functions (section 15 of quake-facts.md).
const std::set<std::int32_t> kStockBuiltins = {
    1,  2,  3,  4,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23,
    24, 25, 26, 27, 28, 29, 30, 31, 32, 34, 35, 36, 37, 38, 40, 41, 43, 44, 45, 46, 47, 48,
    49, 51, 52, 53, 54, 55, 56, 57, 58, 59, 67, 68, 69, 70, 72, 73, 74, 75, 76, 77, 78};

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class Programs : public ::testing::TestWithParam<std::string> {
 protected:
  ProgramFile program() const { return read_program_file(kGames / GetParam() / "progs.dat"); }
};

TEST_P(Programs, HaveTheVersionAndDefinitionsOfStockEngines) {
  EXPECT_EQ(program().version, 6);
  EXPECT_EQ(program().crc, 5927);
  EXPECT_THAT(*program().opcodes.rbegin(), Le(65));
}

// Extensions are called only if checkextension() reports them, and that only if pr_checkextension is set:
// tracebox, checkextension, bots, whichpack.
const std::set<std::int32_t> kExtensionBuiltins = {90, 99, 453, 454, 455, 503};

TEST_P(Programs, UseStockBuiltinsAndExtensionsThatTheyCheck) {
  const std::set<std::int32_t> used = program().builtin_numbers;
  EXPECT_FALSE(used.empty());
  for (const std::int32_t number : used)
    if (!kExtensionBuiltins.contains(number)) {
      EXPECT_THAT(kStockBuiltins, Contains(number));
    }
}

TEST_P(Programs, HaveWhatTheEngineCalls) {
  EXPECT_THAT(
      program().functions,
      IsSupersetOf({"main", "StartFrame", "PlayerPreThink", "PlayerPostThink", "ClientKill", "ClientConnect",
                    "PutClientInServer", "ClientDisconnect", "SetNewParms", "SetChangeParms", "worldspawn"}));
}

TEST_P(Programs, CompileWithoutAWarning) {
  const std::string folder = GetParam() == "id1" ? "quakec" : "examples/" + GetParam();
  const std::string said = read_text(kGames / "source" / folder / "compile.txt");
  EXPECT_THAT(said, ::testing::HasSubstr("\n0 warnings"));
  EXPECT_THAT(said, ::testing::Not(::testing::HasSubstr("warning:")));
}

TEST_P(Programs, NameOnlyFilesInTheData) {
  DATA_FOLDER_OR_SKIP(data);
  const std::regex sound_name(R"([a-z0-9_]+/[A-Za-z0-9_]+\.wav)");
  const std::regex model_name(R"((progs|maps)/[A-Za-z0-9_]+\.(mdl|spr|bsp))");
  // This name is only compared, to recognize a stock level.
  const std::set<std::string> not_loaded = {"maps/e1m8.bsp"};
  // These files of our own data are checked before they are loaded.
  const std::set<std::string> own = {"progs/v_tremor.mdl", "progs/g_tremor.mdl",  "progs/tremor.mdl",
                                     "weapons/tremor.wav", "weapons/tremor2.wav", "progs/debris.mdl",
                                     "break/stone.wav",    "break/wood.wav",      "break/glass.wav",
                                     "break/metal.wav",    "progs/flag.mdl",      "flags/taken.wav",
                                     "flags/dropped.wav",  "flags/returned.wav",  "flags/captured.wav"};
  std::vector<std::string> missing;
  std::size_t found = 0;
  for (const std::string& text : program().strings) {
    if (not_loaded.contains(text) || own.contains(text)) continue;
    std::filesystem::path path;
    if (std::regex_match(text, sound_name)) path = data / "id1/sound" / text;
    if (std::regex_match(text, model_name)) path = data / "id1" / text;
    if (path.empty()) continue;
    if (std::filesystem::exists(path))
      ++found;
    else
      missing.push_back(text);
  }
  EXPECT_THAT(missing, IsEmpty());
  EXPECT_GT(found, 150u);
}

INSTANTIATE_TEST_SUITE_P(All, Programs, ::testing::Values("id1", "homing_rockets", "flying_craft", "alerter"),
                         [](const auto& program) { return program.param; });

// The names of all levels of the data.
std::map<std::string, std::vector<formats::Entity>> stock_levels(const std::filesystem::path& data) {
  std::map<std::string, std::vector<formats::Entity>> levels;
  for (const auto& file : std::filesystem::directory_iterator(data / "id1/maps")) {
    if (file.path().extension() != ".bsp") continue;
    const auto bsp = formats::read_bsp(read_file(file.path()));
    CHECK(bsp.ok(), "{}", file.path().string());
    auto entities = formats::read_entities(bsp->entities);
    CHECK(entities.ok(), "{}", file.path().string());
    levels[file.path().stem().string()] = std::move(*entities);
  }
  return levels;
}

TEST(Game, HasASpawnFunctionForEveryClassOfTheStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  const ProgramFile game = read_program_file(kGames / "id1/progs.dat");
  std::set<std::string> unknown;
  std::size_t seen = 0;
  for (const auto& [level, entities] : stock_levels(data))
    for (const formats::Entity& entity : entities) {
      ++seen;
      const std::string name(entity.classname());
      if (!game.functions.contains(name)) unknown.insert(level + ": " + name);
    }
  EXPECT_THAT(unknown, IsEmpty());
  EXPECT_GT(seen, 1000u);
}

// Also for levels of which only the source exists. Classes for compilers never reach the game.
TEST(Game, HasASpawnFunctionForEveryClassOfTheStockSources) {
  DATA_FOLDER_OR_SKIP(data);
  const ProgramFile game = read_program_file(kGames / "id1/progs.dat");
  std::set<std::string> unknown;
  std::size_t seen = 0;
  for (const auto& file : std::filesystem::directory_iterator(data / "mapsrc")) {
    if (file.path().extension() != ".map") continue;
    const auto map = formats::read_map(read_text(file.path()));
    ASSERT_TRUE(map.ok()) << file.path();
    for (const formats::MapEntity& entity : map->entities) {
      ++seen;
      const std::string name(entity.fields.classname());
      if (name == "func_group" || name.starts_with("func_detail")) continue;
      if (!game.functions.contains(name)) unknown.insert(file.path().stem().string() + ": " + name);
    }
  }
  EXPECT_THAT(unknown, IsEmpty());
  EXPECT_GT(seen, 1000u);
}

// Keys are fields. A key without a field must be a known key of compilers or tools.
TEST(Game, HasAFieldForEveryKeyOfTheStockLevelsThatMatters) {
  DATA_FOLDER_OR_SKIP(data);
  const ProgramFile game = read_program_file(kGames / "id1/progs.dat");
  const std::set<std::string> compilers = {"angle", "light", "mapversion", "wad",
                                           "fog",   "sky",   "wateralpha", "credits_"};
  std::set<std::string> unknown;
  for (const auto& [level, entities] : stock_levels(data))
    for (const formats::Entity& entity : entities)
      for (const auto& [key, value] : entity.pairs)
        if (!key.starts_with('_') && !key.starts_with("//") && !compilers.contains(key) &&
            !game.fields.contains(key))
          unknown.insert(level + ": " + std::string(entity.classname()) + " " + key);
  EXPECT_THAT(unknown, IsEmpty());
}

TEST(Game, HasTheFunctionsThatLevelsName) {
  DATA_FOLDER_OR_SKIP(data);
  const ProgramFile game = read_program_file(kGames / "id1/progs.dat");
  std::size_t named = 0;
  for (const auto& [level, entities] : stock_levels(data))
    for (const formats::Entity& entity : entities)
      for (const char* key : {"use", "touch", "think", "blocked"})
        if (const auto function = entity.find(key)) {
          ++named;
          EXPECT_TRUE(game.functions.contains(std::string(*function))) << level << ": " << *function;
        }
  EXPECT_GT(named, 0u);
}

}  // namespace
}  // namespace temblor::test
