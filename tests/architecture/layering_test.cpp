// Checks the includes of the real sources, and checks each rule on small invented sources that break it, so
// that a rule that has stopped working is noticed.
#include "architecture/layering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Layering, SourcesAreFound) {
  std::size_t includes = 0;
  for (const SourceFile& file : engine_sources()) includes += file.includes.size();
  EXPECT_GT(engine_sources().size(), 20u);
  EXPECT_GT(includes, 2 * engine_sources().size());
}

TEST(Layering, FoldersIncludeOnlyWhatTheTableAllows) {
  EXPECT_THAT(find_layering_violations(engine_sources()), IsEmpty());
}

TEST(Layering, HeadersInAFoldersRootArePublic) {
  EXPECT_THAT(find_unused_public_headers(engine_sources()), IsEmpty());
}

TEST(LayeringRules, RejectUpwardIncludes) {
  EXPECT_THAT(find_layering_violations(invent({{"world/level.cpp", "#include \"render/scene.h\"\n"}})),
              ElementsAre(HasSubstr("world may not include render")));
  EXPECT_THAT(find_layering_violations(invent({{"render/renderer.cpp", "#include \"vfs/file_system.h\"\n"}})),
              ElementsAre(HasSubstr("render may not include vfs")));
  EXPECT_THAT(find_layering_violations(invent({{"vfs/file_system.h", "#include \"math/vec.h\"\n"}})),
              ElementsAre(HasSubstr("vfs may not include math")));
  EXPECT_THAT(find_layering_violations(invent({{"client/input.cpp", "#include \"server/edicts.h\"\n"}})),
              ElementsAre(HasSubstr("client may not include server")));
  EXPECT_THAT(find_layering_violations(invent({{"host/loop.cpp", "#include \"compiler/csg.h\"\n"}})),
              ElementsAre(HasSubstr("host may not include compiler")));
}

TEST(LayeringRules, AcceptDownwardIncludes) {
  EXPECT_THAT(find_layering_violations(
                  invent({{"world/level.h", "#include \"formats/levels/bsp.h\"\n#include <vector>\n"},
                          {"app/main.cpp", "#include \"compiler/csg.h\"\n"},
                          {"app/main.cpp", "#include \"platform/sdl2/window.h\"\n"},
                          {"render/renderer.cpp", "#include \"render/spans/draw.h\"\n"}})),
              IsEmpty());
}

TEST(LayeringRules, RejectPrivateHeadersOfOtherFolders) {
  EXPECT_THAT(find_layering_violations(
                  invent({{"app/render_command.cpp", "#include \"render/edges/edge_table.h\"\n"}})),
              ElementsAre(HasSubstr("render/edges is private to render")));
  EXPECT_THAT(find_layering_violations(invent({{"host/loop.cpp", "#include \"client/menu/menu.h\"\n"}})),
              IsEmpty());
}

TEST(LayeringRules, RenderStagesRunOneWay) {
  EXPECT_THAT(
      find_layering_violations(invent({{"render/edges/scan.cpp", "#include \"render/view/view_frame.h\"\n"},
                                       {"render/spans/draw.cpp", "#include \"render/surfaces/cache.h\"\n"}})),
      IsEmpty());
  EXPECT_THAT(find_layering_violations(
                  invent({{"render/view/view_frame.h", "\n#include \"render/edges/edge_table.h\"\n"},
                          {"render/screen/present.cpp", "#include \"render/spans/draw.h\"\n"},
                          {"render/spans/draw.h", "#include \"render/screen/present.h\"\n"}})),
              ElementsAre(HasSubstr("view_frame.h:2:"), HasSubstr("present.cpp:1:"), HasSubstr("draw.h:1:")));
}

TEST(LayeringRules, RenderStagesDoNotIncludeTheRenderer) {
  EXPECT_THAT(
      find_layering_violations(invent({{"render/spans/draw.cpp", "#include \"render/settings.h\"\n"}})),
      IsEmpty());
  EXPECT_THAT(
      find_layering_violations(invent({{"render/spans/draw.cpp", "#include \"render/renderer.h\"\n"}})),
      ElementsAre(HasSubstr("may not include a header of the folder above it")));
}

TEST(LayeringRules, RequireFullPathsOfKnownFolders) {
  EXPECT_THAT(find_layering_violations(invent({{"base/text.cpp", "#include \"text.h\"\n"},
                                               {"base/text.cpp", "#include \"support/game_data.h\"\n"},
                                               {"newcomer/thing.cpp", "#include \"base/text.h\"\n"}})),
              ElementsAre(HasSubstr("full path"), HasSubstr("full path"), HasSubstr("not in the table")));
}

TEST(LayeringRules, IgnoreIncludesInComments) {
  EXPECT_THAT(find_layering_violations(invent({{"base/text.h",
                                                "// #include \"app/a.h\"\n/*\n#include \"app/b.h\"\n*/\n"
                                                "  #  include \"app/c.h\"  // why\n"}})),
              ElementsAre(HasSubstr("text.h:5:")));
}

TEST(LayeringRules, RejectAPublicHeaderThatOnlyItsOwnFolderIncludes) {
  EXPECT_THAT(find_unused_public_headers(invent({{"server/areas.h", ""},
                                                 {"server/session/clients.h", ""},
                                                 {"server/game.cpp", "#include \"server/areas.h\"\n"}})),
              ElementsAre(HasSubstr("server/areas.h: no other folder includes it")));
  EXPECT_THAT(find_unused_public_headers(
                  invent({{"server/areas.h", ""}, {"host/host.cpp", "#include \"server/areas.h\"\n"}})),
              IsEmpty());
}

}  // namespace
}  // namespace temblor::test
