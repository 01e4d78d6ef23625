// The game configuration for TrenchBroom: it names every class of the game, and its models are shipped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "app/program.h"
#include "formats/game/progs.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;

const fs::path kFolder = fs::path(TEMBLOR_SOURCE_DIR) / "packaging/trenchbroom/Temblor";

std::set<std::string> find_all(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

// Classes that entities can have; a base class only gives its keys to others.
std::set<std::string> list_fgd_classes() {
  return find_all(read_text(kFolder / "Temblor.fgd"),
                  std::regex("(?:^|\n)@(?:Point|Solid)Class[^\n=]* = (\\w+)"));
}

std::set<std::string> subtract(const std::set<std::string>& from, const std::set<std::string>& other) {
  std::set<std::string> rest;
  std::ranges::set_difference(from, other, std::inserter(rest, rest.end()));
  return rest;
}

TEST(TrenchBroom, FilesAreJson) {
  for (const char* name : {"GameConfig.cfg", "CompilationProfiles.cfg"})
    EXPECT_TRUE(nlohmann::json::accept(read_text(kFolder / name))) << name;
  const auto config = nlohmann::json::parse(read_text(kFolder / "GameConfig.cfg"));
  EXPECT_EQ(config.at("name").get<std::string>(), kFolder.filename().string());
  for (const auto& definitions : config.at("entities").at("definitions"))
    EXPECT_TRUE(fs::exists(kFolder / definitions.get<std::string>())) << definitions;
}

// TrenchBroom splits parameters at blanks, which paths may contain.
TEST(TrenchBroom, ProfilesQuotePaths) {
  const auto config = nlohmann::json::parse(read_text(kFolder / "CompilationProfiles.cfg"));
  const std::regex path("\\$\\{[A-Z_]*PATH\\}"), quoted_path("\"\\$\\{[A-Z_]*PATH\\}[^\" ]*\"");
  std::size_t tools = 0;
  for (const auto& profile : config.at("profiles"))
    for (const auto& task : profile.at("tasks")) {
      if (task.at("type") != "tool") continue;
      const std::string words = task.at("parameters");
      EXPECT_FALSE(std::regex_search(std::regex_replace(words, quoted_path, ""), path)) << words;
      ++tools;
    }
  EXPECT_GT(tools, 0u);
}

// The compiled program lists every function; those of classes that a map can contain have no parameters and
// begin like this. Other functions that begin so are helpers of these classes.
TEST(TrenchBroom, EveryClassOfTheGameIsDefined) {
  if (!fs::exists(TEMBLOR_GAME_PROGRAM)) GTEST_SKIP() << "the game was not compiled (is fteqcc missing?)";
  const std::set<std::string> helpers = {
      "item_comes_back", "item_comes_back_in", "item_falls",  "item_hides",   "item_touched",
      "light_or_remove", "light_used",         "trigger_go",  "trigger_shot", "trigger_touched",
      "trigger_used",    "trigger_rearm",      "weapon_taken"};
  // The compiler's own.
  const std::set<std::string> compiled = {"func_group",
                                          "func_detail",
                                          "func_detail_wall",
                                          "func_detail_fence",
                                          "func_detail_illusionary",
                                          "func_illusionary_visblocker",
                                          "misc_external_map"};
  const auto progs = formats::read_progs(read_file(TEMBLOR_GAME_PROGRAM));
  ASSERT_TRUE(progs.ok()) << progs.error().what;
  const std::regex begins(
      "(monster|item|weapon|func|trigger|info|misc|ambient|trap|event|light)_\\w+|light|worldspawn|path_"
      "corner|"
      "air_bubbles|viewthing|noclass|testplayerstart");
  std::set<std::string> functions, classes;
  for (const formats::ProgsFunction& function : progs->functions) {
    const std::string name(progs->string_at(function.name));
    functions.insert(name);
    if (function.parameter_count == 0 && std::regex_match(name, begins) && !helpers.contains(name))
      classes.insert(name);
  }
  EXPECT_GT(classes.size(), 90u);
  const std::set<std::string> defined = list_fgd_classes();
  EXPECT_THAT(subtract(classes, defined), IsEmpty()) << "classes that are not in Temblor.fgd";
  EXPECT_THAT(subtract(subtract(defined, compiled), functions), IsEmpty())
      << "classes that the game does not have";
  EXPECT_THAT(subtract(compiled, defined), IsEmpty());
}

// A script makes each file of the shipped game.
TEST(TrenchBroom, ModelsAreShipped) {
  const fs::path game = fs::path(TEMBLOR_SOURCE_DIR) / "game";
  std::set<std::string> shipped;
  for (const auto& entry : fs::recursive_directory_iterator(game / "art"))
    if (entry.path().extension() == ".art")
      for (const std::string& name :
           find_all(read_text(entry.path()), std::regex("(?:^|\n)(?:model|sprite) (\\S+)")))
        shipped.insert(name);
  for (const auto& entry : fs::directory_iterator(game / "maps"))
    if (entry.path().extension() == ".level") shipped.insert("maps/" + entry.path().stem().string() + ".bsp");
  const std::string fgd = read_text(kFolder / "Temblor.fgd");
  const std::set<std::string> shown = find_all(fgd, std::regex("\":((?:progs|maps)/[^\"]+)\""));
  EXPECT_GT(shown.size(), 40u);
  EXPECT_THAT(subtract(shown, shipped), IsEmpty());
  EXPECT_THAT(subtract(find_all(fgd, std::regex("model\\(string\\) : \"\\w+\" : \"([^\"]+)\"")), shipped),
              IsEmpty());
}

// Base classes are defined before they are used, and brackets match.
TEST(TrenchBroom, FgdIsWellFormed) {
  std::istringstream lines(read_text(kFolder / "Temblor.fgd"));
  std::set<std::string> known;
  int open = 0;
  const std::regex head("^@(?:base|Point|Solid)[Cc]lass(?: base\\(([^)]*)\\))?[^=\n]* ?= (\\w+)"),
      word("(\\w+)");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('@')) {
      EXPECT_EQ(open, 0) << line;
      std::smatch found;
      ASSERT_TRUE(std::regex_search(line, found, head)) << line;
      for (const std::string& base : find_all(found[1], word)) EXPECT_TRUE(known.contains(base)) << line;
      EXPECT_TRUE(known.insert(found[2]).second) << line;
    }
    open += static_cast<int>(std::ranges::count(line, '[') - std::ranges::count(line, ']'));
    EXPECT_GE(open, 0) << line;
    EXPECT_EQ(std::ranges::count(line, '"') % 2, 0) << line;
  }
  EXPECT_EQ(open, 0);
}

}  // namespace
}  // namespace temblor::test
