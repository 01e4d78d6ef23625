#include "architecture/sizes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kMaxFileLines = 600;
constexpr int kMaxFolderFiles = 25;
constexpr int kMaxParameters = 7;

// Every file that people write, except data: fuzz corpora and golden pictures.
std::vector<std::string> written_files() {
  namespace fs = std::filesystem;
  std::vector<std::string> paths;
  for (const char* top : {"src", "tests", "bench", "fuzz", "game", "cmake", "tools", "docs"}) {
    for (const auto& entry : fs::recursive_directory_iterator(repository_root() / top)) {
      const std::string path = entry.path().lexically_relative(repository_root()).generic_string();
      const bool is_data = path.starts_with("fuzz/corpus/") || path.starts_with("tests/golden/pictures/") ||
                           path.starts_with("docs/pictures/");
      // fteqcc writes its results next to the source when somebody runs it by hand.
      static constexpr std::array kResults = {".dat", ".lno", ".log"};
      const bool is_result = std::ranges::find(kResults, entry.path().extension()) != kResults.end();
      if (entry.is_regular_file() && !is_data && !is_result) paths.push_back(path);
    }
  }
  return paths;
}

TEST(Sizes, FilesAreShort) {
  EXPECT_THAT(find_long_files(engine_sources(), kMaxFileLines), IsEmpty());
}

TEST(Sizes, FoldersHoldAtMost25Files) {
  EXPECT_THAT(find_crowded_folders(written_files(), kMaxFolderFiles), IsEmpty());
}

TEST(Sizes, FunctionsTakeAtMost7Parameters) {
  EXPECT_THAT(find_long_parameter_lists(engine_sources(), kMaxParameters), IsEmpty());
}

TEST(Sizes, TypesOfANamespaceHaveDifferentNames) {
  EXPECT_THAT(find_duplicate_types(engine_sources()), IsEmpty());
}

TEST(SizeRules, RejectLongFiles) {
  const auto files = invent({{"base/long.cpp", "a\nb\nc\nd\n"}, {"base/short.cpp", "a\nb\nc\n"}});
  EXPECT_THAT(find_long_files(files, 3), ElementsAre(HasSubstr("long.cpp: 4 lines")));
}

TEST(SizeRules, RejectCrowdedFolders) {
  EXPECT_THAT(find_crowded_folders({"a/x.h", "a/y.h", "a/z.h", "a/b/x.h", "a/b/y.h"}, 2),
              ElementsAre(HasSubstr("a: 3 files")));
}

TEST(SizeRules, RejectLongParameterLists) {
  const auto count = [](const std::string& text) {
    return find_long_parameter_lists(invent({{"a/x.h", text}}), 2).size();
  };
  EXPECT_EQ(count("void f(int a, int b);\n"), 0u);
  EXPECT_EQ(count("void f(int a, int b, int c);\n"), 1u);
  EXPECT_EQ(count("std::span<int> f(int a, int b,\n        int c) const {\n}\n"), 1u);
  EXPECT_EQ(count("void f(std::map<int, int> a, std::function<void(int, int, int)> b);\n"), 0u);
  EXPECT_EQ(count("  g(1, 2, 3);\n  return h(1, 2, 3);\n"), 0u);
}

TEST(SizeRules, RejectTwoTypesOfOneName) {
  const auto text = [](const std::string& space, const std::string& type) {
    return "namespace " + space + " {\n" + type + " Plan {\n  int x;\n};\n}  // namespace " + space + "\n";
  };
  EXPECT_THAT(find_duplicate_types(
                  invent({{"a/x.h", text("t::a", "struct")}, {"a/y.h", text("t::a", "enum class")}})),
              ElementsAre(HasSubstr("a/y.h: t::a::Plan is also in a/x.h")));
  EXPECT_THAT(
      find_duplicate_types(invent({{"a/x.h", text("t::a", "struct")}, {"b/y.h", text("t::b", "struct")}})),
      IsEmpty());
  EXPECT_THAT(find_duplicate_types(invent(
                  {{"a/x.h", text("t::a", "class") + text("", "class")},
                   {"a/y.cpp", "namespace t::a {\n" + text("", "struct") + "}  // namespace t::a\n"},
                   {"a/z.cpp", "namespace t::a {\n" + text("", "struct") + "}  // namespace t::a\n"}})),
              IsEmpty());
}

}  // namespace
}  // namespace temblor::test
