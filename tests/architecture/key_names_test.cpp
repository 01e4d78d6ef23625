// The names of entity keys are in three places: key_names.cpp lists those that cause no warning,
// key_values.cpp those that take numbers, and the compiler's other sources read them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

using NameSet = std::set<std::string>;
using ::testing::IsEmpty;

// The first group of each match, in small letters.
NameSet find_names(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  NameSet found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    std::string name = (*it)[1];
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    found.insert(name);
  }
  return found;
}

NameSet without(const NameSet& names, const NameSet& others) {
  NameSet rest;
  std::ranges::set_difference(names, others, std::inserter(rest, rest.end()));
  return rest;
}

constexpr const char* kLiteral = R"re("_?(\w+)")re";

// The tables of key_names.cpp or key_values.cpp, which are in front of the functions.
std::string read_tables(const std::string& name) {
  for (const SourceFile& file : engine_sources())
    if (file.path == "compiler/bsp/brushes/" + name) return file.text.substr(0, file.text.find("\n}"));
  return {};
}

// All other sources of the compiler.
std::string read_other_sources() {
  std::string text;
  for (const SourceFile& file : engine_sources())
    if (file.path.starts_with("compiler/") && !file.path.ends_with("/key_names.cpp") &&
        !file.path.ends_with("/key_values.cpp"))
      text += file.text;
  return text;
}

// Calls that read a key: read_number(entity, "name") and the like add the underscore themselves.
NameSet find_read_names(const std::string& text) {
  NameSet read = find_names(text, R"re((?:read_\w+|whole_number_or)\(\s*\w+(?:\.\w+|\(\))*,\s*"(\w+)")re");
  read.merge(find_names(text, R"re(find\w*\(\s*"_(\w+)")re"));
  return read;
}

TEST(KeyNames, AreKnownIfTheCompilerReadsThem) {
  const NameSet known = find_names(read_tables("key_names.cpp"), kLiteral);
  const NameSet typed = find_names(read_tables("key_values.cpp"), kLiteral);
  const NameSet read = find_read_names(read_other_sources());
  EXPECT_GT(typed.size(), 80u);
  EXPECT_GT(read.size(), 80u);
  EXPECT_THAT(without(typed, known), IsEmpty());
  EXPECT_THAT(without(read, known), IsEmpty());
}

// Known names that occur nowhere else in the compiler belong to other programs (docs/ericw-tools.md), or are
// notes.
TEST(KeyNames, AreReadUnlessTheyBelongToOthers) {
  const NameSet others = {"author",
                          "bouncelightsubdivision",
                          "chop",
                          "choplight",
                          "comment",
                          "credits",
                          "dirt_off_radius",
                          "dirt_on_radius",
                          "noambient",
                          "nonudge",
                          "note",
                          "sky_surface",
                          "skybox",
                          "skyfog",
                          "skyname",
                          "sun_surface",
                          "sunlight2_mangle",
                          "sunlight3_dirt",
                          "surface_group",
                          "surface_minlight_scale",
                          "surface_radiosity",
                          "surflight_atten",
                          "surflight_minlight_scale",
                          "surflight_radiosity",
                          "surflight_wait",
                          "surflightscale",
                          "surflightskyscale",
                          "surflightsubdivision",
                          "switchableshadow_style",
                          "title"};
  NameSet ours = find_names(read_other_sources(), kLiteral);
  ours.merge(find_names(read_tables("key_values.cpp"), kLiteral));
  ours.insert("fog");  // checked apart from the tables
  for (int i = 2; i <= 9; ++i) ours.insert("minlight_exclude" + std::to_string(i));  // made of two parts
  const NameSet known = find_names(read_tables("key_names.cpp"), kLiteral);
  EXPECT_EQ(without(known, ours), others);
}

}  // namespace
}  // namespace temblor::test
