// Command lines of qbsp, vis, and light, without running them.
#include "app/stock_tools/stock_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/stock_tools/stock_flags.h"
#include "app/stock_tools/world_key_flags.h"

namespace temblor::test {
namespace {

using app::StockCommand;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Optional;
using ::testing::Pair;

StockCommand parse(const std::vector<const char*>& words, std::string_view program = "temblor") {
  auto command = app::parse_stock_command(program, words);
  EXPECT_TRUE(command.ok() && *command) << (command.ok() ? "no stock tool" : command.error().what);
  return command.ok() && *command ? **command : StockCommand();
}

std::string find_problem(const std::vector<const char*>& words) {
  const auto command = app::parse_stock_command("temblor", words);
  if (command.ok()) return "none";
  EXPECT_EQ(command.error().code, base::ErrorCode::kUsage);
  return command.error().what;
}

bool is_stock(const std::vector<const char*>& words, std::string_view program = "temblor") {
  const auto command = app::parse_stock_command(program, words);
  return command.ok() && command->has_value();
}

TEST(StockCommand, IsFoundByItsName) {
  EXPECT_TRUE(is_stock({"qbsp", "a"}));
  EXPECT_TRUE(is_stock({"--basedir", "quake", "-game", "mod", "vis", "a"}));
  EXPECT_TRUE(is_stock({"a"}, "/opt/tools/light"));
  EXPECT_TRUE(is_stock({"a"}, "vis.exe"));
  EXPECT_FALSE(is_stock({"compile", "light"}));
  EXPECT_FALSE(is_stock({"--map", "vis"}));
  EXPECT_FALSE(is_stock({}));
  EXPECT_EQ(parse({"--basedir", "quake", "--game", "mod", "vis", "a"}).folders.base_folder, "quake");
}

TEST(StockCommand, CompletesFileNames) {
  EXPECT_EQ(parse({"qbsp", "a"}).options.source, "a.map");
  EXPECT_EQ(parse({"qbsp", "d.e/a.map", "b"}).options.source, "d.e/a.map");
  EXPECT_EQ(parse({"qbsp", "a.map", "out/b"}).options.out, "out/b.bsp");
  EXPECT_EQ(parse({"qbsp", "a.map"}).options.out, "");
  EXPECT_EQ(parse({"vis", "maps/a"}).options.source, "maps/a.bsp");
  EXPECT_EQ(parse({"light", "a.map"}).options.source, "a.bsp");
  EXPECT_THAT(find_problem({"qbsp", "-bsp2"}), HasSubstr("no map given"));
  EXPECT_THAT(find_problem({"vis", "a", "b"}), HasSubstr("unexpected file b"));
  EXPECT_THAT(find_problem({"light"}), HasSubstr("no level given"));
  EXPECT_TRUE(parse({"qbsp", "--help"}).wants_help);
}

TEST(StockCommand, TranslatesFlags) {
  const app::CompileCommandOptions qbsp =
      parse({"qbsp", "-bsp2", "-threads", "3", "-leakdist", "16", "-noclip", "-nofill", "-notranswater",
             "-omitdetail", "-leaktest", "-subdivide", "128", "--litwater", "0", "a.map"})
          .options;
  EXPECT_EQ(qbsp.only, app::CompileStage::kBsp);
  EXPECT_TRUE(qbsp.bsp2 && qbsp.no_clip && qbsp.no_fill && qbsp.opaque_water && qbsp.leak_is_error);
  EXPECT_TRUE(qbsp.portals);
  EXPECT_EQ(qbsp.threads, 3);
  EXPECT_EQ(qbsp.leak_step, 16);
  EXPECT_EQ(qbsp.subdivide_texels, 128);
  EXPECT_EQ(qbsp.omitted_detail, app::kAllDetail);
  EXPECT_THAT(qbsp.world_keys, ElementsAre(Pair("litwater", "0")));
  EXPECT_EQ(parse({"qbsp", "-omitdetailfence", "-omitdetailwall", "a"}).options.omitted_detail,
            app::kFenceDetail | app::kWallDetail);

  const app::CompileCommandOptions vis = parse({"vis", "-FAST", "-level", "4", "a"}).options;
  EXPECT_EQ(vis.only, app::CompileStage::kVisibility);
  EXPECT_TRUE(vis.fast && vis.keeps_portals && !vis.portals);
  EXPECT_THAT(parse({"vis", "-path", ".", "a"}).options.wads, IsEmpty());
  EXPECT_THAT(parse({"qbsp", "-path", ".", "-wadpath", "..", "a"}).options.wads, ElementsAre(".", ".."));

  const app::CompileCommandOptions light =
      parse({"light", "-extra4", "-bounce",     "-dirt", "-minlight", "20",         "-sunlight_mangle", "90",
             "-45",   "0",       "-sunsamples", "64",    "-lit",      "-lightgrid", "-lightgrid_dist",  "16",
             "32",    "64",      "-lmscale",    "0.25",  "a.bsp"})
          .options;
  EXPECT_EQ(light.only, app::CompileStage::kLight);
  EXPECT_EQ(light.extra, 4);
  EXPECT_EQ(light.bounces, 1);
  EXPECT_EQ(light.sky_rays, 64);
  EXPECT_EQ(light.luxel_texels, 4);
  EXPECT_TRUE(light.force_lit && light.light_grid);
  EXPECT_EQ(light.light_grid_dist, math::Vec3(16, 32, 64));
  EXPECT_THAT(light.light_keys,
              ElementsAre(Pair("dirt", "1"), Pair("minlight", "20"), Pair("sun_mangle", "90 -45 0")));
  EXPECT_EQ(parse({"light", "-bounce", "3", "a"}).options.bounces, 3);
  for (const char* const flag : {"-lux", "-bspx", "-bspxlux", "-bspxonly"})
    EXPECT_TRUE(parse({"light", flag, "a"}).options.directions) << flag;
}

TEST(StockCommand, NotesFlagsWithoutEffect) {
  EXPECT_THAT(parse({"qbsp", "-nopercent", "-oldaxis", "-verbose", "-log", "a"}).notes, IsEmpty());
  EXPECT_THAT(parse({"light", "-novanilla", "a"}).notes, ElementsAre(HasSubstr("-novanilla has no effect")));
  // Build scripts still have the flags of older versions.
  EXPECT_THAT(parse({"qbsp", "-bspleak", "-transsky", "a"}).notes,
              ElementsAre(HasSubstr("-bspleak has no effect"), HasSubstr("-transsky has no effect")));
  EXPECT_THAT(parse({"qbsp", "-wadpath", "no/such/folder", "a"}).notes,
              ElementsAre(HasSubstr("no/such/folder")));
  EXPECT_THAT(parse({"qbsp", "-basedir", "no/such", "a"}).notes, ElementsAre(HasSubstr("has no id1")));
  EXPECT_TRUE(parse({"qbsp", "-quiet", "a"}).options.quiet);
  EXPECT_THAT(parse({"light", "-lmscale", "0.5", "a"}).notes, IsEmpty());
  EXPECT_THAT(parse({"light", "-lmscale", "3", "a"}).notes, ElementsAre("-lmscale 3: 4 is used"));
}

TEST(StockCommand, ExplainsUnknownFlags) {
  EXPECT_THAT(find_problem({"qbsp", "-wadpaht", "x", "a"}), HasSubstr("did you mean -wadpath?"));
  EXPECT_THAT(find_problem({"light", "-sunligth", "9", "a"}), HasSubstr("did you mean -sunlight?"));
  EXPECT_THAT(find_problem({"vis", "-qqqq", "a"}), HasSubstr("`temblor vis -help`"));
  EXPECT_THAT(find_problem({"qbsp", "-q2bsp", "a"}), HasSubstr("-q2bsp is not supported"));
  EXPECT_THAT(find_problem({"qbsp", "-leakdist", "a"}), HasSubstr("-leakdist needs a number"));
  EXPECT_THAT(find_problem({"qbsp", "a", "-wadpath"}), HasSubstr("-wadpath needs a value"));
  EXPECT_THAT(find_problem({"light", "-lightgrid_dist", "8", "8", "a"}), HasSubstr("needs three numbers"));
}

// Every flag either works, or says why not, or is one that needs no words. A flag in two tables would hide
// the second.
TEST(StockFlags, TablesAreSortedAndComplete) {
  for (const app::StockTool tool : {app::StockTool::kQbsp, app::StockTool::kVis, app::StockTool::kLight}) {
    std::vector<std::string> names;
    for (const auto flags : {app::list_tool_flags(tool), app::list_common_flags()}) {
      EXPECT_TRUE(std::ranges::is_sorted(
          flags, {}, [](const app::StockFlag& flag) { return std::string_view(flag.name); }));
      for (const app::StockFlag& flag : flags) {
        names.emplace_back(flag.name);
        EXPECT_FALSE(flag.apply != nullptr && flag.note != nullptr) << flag.name;
        EXPECT_FALSE(flag.is_refused && flag.note == nullptr) << flag.name;
      }
    }
    if (tool == app::StockTool::kLight)
      for (const app::WorldKeyFlag& flag : app::list_world_key_flags()) names.emplace_back(flag.flag);
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  }
  EXPECT_TRUE(std::ranges::is_sorted(app::list_world_key_flags(), {}, &app::WorldKeyFlag::flag));
}

}  // namespace
}  // namespace temblor::test
