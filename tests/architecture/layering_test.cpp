// The rules of the house, held against the real sources; and each rule against small invented sources that
// break it, so that a rule which no longer sees anything is found out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "architecture/source_tree.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kMaxFileLines = 600;

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> files =
      read_source_tree(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "src");
  return files;
}

std::vector<SourceFile> invent(const std::vector<std::pair<std::string, std::string>>& path_and_text) {
  std::vector<SourceFile> files;
  for (const auto& [path, text] : path_and_text) files.push_back(parse_source(path, text));
  return files;
}

TEST(Layering, SourcesAreFound) {
  std::size_t includes = 0;
  for (const SourceFile& file : sources()) includes += file.includes.size();
  EXPECT_GT(sources().size(), 20u);
  EXPECT_GT(includes, 2 * sources().size());
}

TEST(Layering, FoldersIncludeOnlyWhatTheTableAllows) {
  EXPECT_THAT(layering_breaches(sources()), IsEmpty());
}

TEST(Layering, FilesAreShort) {
  EXPECT_THAT(length_breaches(sources(), kMaxFileLines), IsEmpty());
}

TEST(Layering, TypesOfANamespaceHaveNamesOfTheirOwn) {
  EXPECT_THAT(type_breaches(sources()), IsEmpty());
}

TEST(Layering, KernelFilesDrawInNoCodeOfOurs) {
  EXPECT_THAT(kernel_breaches(sources()), IsEmpty());
}

TEST(LayeringRules, UpwardIncludeIsABreach) {
  EXPECT_THAT(layering_breaches(invent({{"world/level.cpp", "#include \"render/scene.h\"\n"}})),
              ElementsAre(HasSubstr("world may not include render")));
  EXPECT_THAT(layering_breaches(invent({{"render/renderer.cpp", "#include \"vfs/file_system.h\"\n"}})),
              ElementsAre(HasSubstr("render may not include vfs")));
  EXPECT_THAT(layering_breaches(invent({{"vfs/file_system.h", "#include \"math/vec.h\"\n"}})),
              ElementsAre(HasSubstr("vfs may not include math")));
  EXPECT_THAT(layering_breaches(invent({{"client/input.cpp", "#include \"server/game/edicts.h\"\n"}})),
              ElementsAre(HasSubstr("client may not include server")));
  EXPECT_THAT(layering_breaches(invent({{"host/loop.cpp", "#include \"compiler/csg.h\"\n"}})),
              ElementsAre(HasSubstr("host may not include compiler")));
}

TEST(LayeringRules, DownwardIncludeIsNone) {
  EXPECT_THAT(
      layering_breaches(invent({{"world/level.h", "#include \"formats/levels/bsp.h\"\n#include <vector>\n"},
                                {"app/main.cpp", "#include \"compiler/csg.h\"\n"},
                                {"app/main.cpp", "#include \"platform/sdl2/window.h\"\n"},
                                {"render/renderer.cpp", "#include \"render/spans/draw.h\"\n"}})),
      IsEmpty());
}

TEST(LayeringRules, SubFolderIsPrivate) {
  EXPECT_THAT(layering_breaches(
                  invent({{"app/commands/render_command.cpp", "#include \"render/edges/edge_table.h\"\n"}})),
              ElementsAre(HasSubstr("render/edges is private to render")));
}

TEST(LayeringRules, RenderStagesRunOneWay) {
  EXPECT_THAT(
      layering_breaches(invent({{"render/edges/scan.cpp", "#include \"render/view/view_frame.h\"\n"},
                                {"render/spans/draw.cpp", "#include \"render/surfaces/cache.h\"\n"}})),
      IsEmpty());
  EXPECT_THAT(
      layering_breaches(invent({{"render/view/view_frame.h", "\n#include \"render/edges/edge_table.h\"\n"},
                                {"render/screen/present.cpp", "#include \"render/spans/draw.h\"\n"},
                                {"render/spans/draw.h", "#include \"render/screen/present.h\"\n"}})),
      ElementsAre(HasSubstr("view_frame.h:2:"), HasSubstr("present.cpp:1:"), HasSubstr("draw.h:1:")));
}

TEST(LayeringRules, IncludesAreFullPathsOfKnownFolders) {
  EXPECT_THAT(layering_breaches(invent({{"base/text.cpp", "#include \"text.h\"\n"},
                                        {"base/text.cpp", "#include \"support/game_data.h\"\n"},
                                        {"newcomer/thing.cpp", "#include \"base/text.h\"\n"}})),
              ElementsAre(HasSubstr("full path"), HasSubstr("full path"), HasSubstr("not in the table")));
}

TEST(LayeringRules, CommentedIncludesDoNotCount) {
  EXPECT_THAT(layering_breaches(invent({{"base/text.h",
                                         "// #include \"app/a.h\"\n/*\n#include \"app/b.h\"\n*/\n"
                                         "  #  include \"app/c.h\"  // why\n"}})),
              ElementsAre(HasSubstr("text.h:5:")));
}

TEST(LayeringRules, LongFileIsABreach) {
  const auto files = invent({{"base/long.cpp", "a\nb\nc\nd\n"}, {"base/short.cpp", "a\nb\nc\n"}});
  EXPECT_THAT(length_breaches(files, 3), ElementsAre(HasSubstr("long.cpp: 4 lines")));
}

TEST(LayeringRules, TwoTypesOfOneNameAreABreach) {
  const auto text = [](const std::string& space, const std::string& type) {
    return "namespace " + space + " {\n" + type + " Plan {\n  int x;\n};\n}  // namespace " + space + "\n";
  };
  EXPECT_THAT(
      type_breaches(invent({{"a/x.h", text("t::a", "struct")}, {"a/y.h", text("t::a", "enum class")}})),
      ElementsAre(HasSubstr("a/y.h: t::a::Plan is also in a/x.h")));
  EXPECT_THAT(type_breaches(invent({{"a/x.h", text("t::a", "struct")}, {"b/y.h", text("t::b", "struct")}})),
              IsEmpty());
  EXPECT_THAT(type_breaches(invent(
                  {{"a/x.h", text("t::a", "class") + text("", "class")},
                   {"a/y.cpp", "namespace t::a {\n" + text("", "struct") + "}  // namespace t::a\n"},
                   {"a/z.cpp", "namespace t::a {\n" + text("", "struct") + "}  // namespace t::a\n"}})),
              IsEmpty());
}

TEST(LayeringRules, KernelFileMayDrawInPlainDataOnly) {
  const std::string kernel =
      "#define HWY_TARGET_INCLUDE \"render/spans/kernel.cpp\"\n"
      "#include \"hwy/foreach_target.h\"\n#include <hwy/highway.h>\n#include \"render/spans/kernel.h\"\n";
  const std::string plain = "struct Span {\n  int x = 0;\n};\nvoid draw(const Span& span);\n";
  EXPECT_THAT(
      kernel_breaches(invent({{"render/spans/kernel.cpp", kernel}, {"render/spans/kernel.h", plain}})),
      IsEmpty());
  for (const char* body :
       {"inline int f(int x) { return x; }\n", "struct S {\n  int f() const { return 0; }\n};\n",
        "inline auto f(int x) noexcept -> int {\n  return x;\n}\n"}) {
    EXPECT_THAT(kernel_breaches(invent({{"render/spans/kernel.cpp", kernel},
                                        {"render/spans/kernel.h", "#include \"base/deep.h\"\n"},
                                        {"base/deep.h", body}})),
                ElementsAre(HasSubstr("draws in base/deep.h")))
        << body;
  }
}

TEST(LayeringRules, VectorCodeElsewhereIsABreach) {
  EXPECT_THAT(kernel_breaches(invent({{"world/level.cpp", "#include <hwy/highway.h>\n"}})),
              ElementsAre(HasSubstr("outside the folders of kernels")));
  const std::string intrinsic = "x = _mm256_add_ps(a, b);\n";
  EXPECT_THAT(kernel_breaches(invent({{"render/spans/draw.cpp", intrinsic}})),
              ElementsAre(HasSubstr("one instruction set")));
  EXPECT_THAT(
      kernel_breaches(invent({{"render/spans/kernel.cpp", "#include <hwy/foreach_target.h>\n" + intrinsic}})),
      IsEmpty());
}

}  // namespace
}  // namespace temblor::test
