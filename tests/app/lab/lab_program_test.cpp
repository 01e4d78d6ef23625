// `temblor lab`: lists, measures, and pictures techniques.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "support/programs/small_game.h"

namespace temblor::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

ProgramRun lab(const std::filesystem::path& folder, Words words) {
  words.insert(words.begin(), "lab");
  return run_program(folder, words);
}

TEST(LabProgram, ListsTechniquesAndTheirParameters) {
  const TemporaryFolder folder;
  const ProgramRun text = lab(folder.path(), {"list"});
  EXPECT_EQ(text.exit_status, 0);
  EXPECT_THAT(text.out, HasSubstr("painter: Painter's algorithm\n"));
  EXPECT_THAT(text.out, HasSubstr("  pvs=1, 0 to 1. "));
  const json list = json::parse(lab(folder.path(), {"list", "--json"}).out);
  EXPECT_EQ(list.at(0).at("name"), "bsp-edges");
  for (const json& technique : list) EXPECT_FALSE(technique.at("article").get<std::string>().empty());
}

TEST(LabProgram, RunComparesWithTheEngineAndWritesAPicture) {
  const TemporaryFolder folder;
  const ProgramRun run = lab(folder.path(), {"run", "painter", "--size", "64x48", "--step", "180", "--color",
                                             "indexed", "-o", "x.png"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("64x48 indexed"));
  EXPECT_THAT(run.out, HasSubstr("bsp-edges"));
  const Png png = read_png(folder.path() / "x.png");
  EXPECT_EQ(png.width, 3u * 64);
  EXPECT_EQ(png.height, 48u);
  EXPECT_GT(count_colors(png), 10u);
}

// The third panel is black for equal pictures only.
TEST(LabProgram, ThePictureShowsTheDifference) {
  const TemporaryFolder folder;
  const auto count_different = [&](const char* technique) {
    const ProgramRun run = lab(
        folder.path(), {"run", technique, "--size", "160x120", "--step", "360", "--pos",
                        "837.4178,301.96698,-32.26322", "--angles", "4.335917,331.44476,0", "-o", "x.png"});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const Png png = read_png(folder.path() / "x.png");
    std::size_t different = 0;
    for (std::size_t y = 0; y < 120; ++y)
      for (std::size_t x = 0; x < 160; ++x) {
        const std::uint8_t* const pixel = png.rgb.data() + 3 * (y * 480 + 320 + x);
        different += pixel[0] + pixel[1] + pixel[2] > 0;
      }
    return different;
  };
  EXPECT_EQ(count_different("bsp-edges"), 0u);
  EXPECT_EQ(count_different("intersecting-edges"), 0u);
  EXPECT_EQ(count_different("portals"), 0u);
  EXPECT_GT(count_different("independent-edges"), 100u);
}

TEST(LabProgram, CompareCountsWorkAndErrors) {
  const TemporaryFolder folder;
  const ProgramRun run =
      lab(folder.path(), {"compare", "bsp-edges", "painter", "z-buffer:order=1", "intersecting-edges",
                          "--size", "160x120", "--step", "180", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result.at("size"), "160x120");
  const json& techniques = result.at("techniques");
  ASSERT_EQ(techniques.size(), 4u);
  EXPECT_EQ(techniques[0].at("ratio"), 1.0);
  EXPECT_EQ(techniques[0].at("pixels_written"), 1.0);
  EXPECT_GT(techniques[1].at("pixels_written"), 1.0);
  EXPECT_EQ(techniques[2].at("parameters").at("order"), 1.0);
  EXPECT_GT(techniques[2].at("pixels_tested"), 1.0);
  EXPECT_GT(techniques[3].at("comparisons"), 0.0);
  for (const json& technique : techniques) {
    EXPECT_EQ(technique.at("judged").at("wrong"), 0) << technique.at("name");
    EXPECT_GT(technique.at("judged").at("pixels"), 1000) << technique.at("name");
    EXPECT_GT(technique.at("frame_ms").at("p50"), 0.0);
  }
}

// Gouraud's light depends on the view, unless triangles are interpolated in perspective.
TEST(LabProgram, CompareMeasuresLight) {
  const TemporaryFolder folder;
  const ProgramRun run =
      lab(folder.path(), {"compare", "bsp-edges", "one-pass", "gouraud", "gouraud:perspective=1,triangles=1",
                          "--size", "320x240", "--step", "180", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  const json& engine = result.at("techniques").at(0);
  const json& one_pass = result.at("techniques").at(1);
  const json& gouraud = result.at("techniques").at(2);
  const json& steady = result.at("techniques").at(3);
  for (const json* exact : {&engine, &one_pass}) EXPECT_EQ(exact->at("light").at("error").at("max"), 0.0);
  EXPECT_GT(engine.at("surface_texels").at("p50"), 10000.0);
  EXPECT_EQ(one_pass.at("surface_texels").at("max"), 0.0);
  for (const json* wrong : {&gouraud, &steady}) EXPECT_GT(wrong->at("light").at("error").at("mean"), 1.0);
  for (const char* const place : {"seams", "shadow_edges"}) {
    EXPECT_EQ(engine.at("light").at(place).at("max"), 0.0) << place;
    EXPECT_GT(gouraud.at("light").at(place).at("mean"), 0.1) << place;
  }
  for (const char* const camera : {"turn", "roll"}) {
    for (const json* still : {&engine, &one_pass, &steady})
      EXPECT_LT(still->at("light").at(camera).at("max"), 1.0) << camera;
    EXPECT_GT(gouraud.at("light").at(camera).at("max"), 2.0) << camera;
  }
}

// Without perspective, textures swim while the camera turns.
TEST(LabProgram, CompareMeasuresTexels) {
  const TemporaryFolder folder;
  const ProgramRun run =
      lab(folder.path(), {"compare", "bsp-edges", "phong", "affine-spans", "marked-surfaces", "--size",
                          "320x240", "--step", "180", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  const auto texels = [&](std::size_t number) { return result.at("techniques").at(number).at("texels"); };
  // Rounding to whole texels remains.
  const double floor = texels(0).at("turn").at("mean");
  EXPECT_GT(floor, 0.05);
  for (const std::size_t exact : {0, 1}) {
    EXPECT_LT(texels(exact).at("error").at("max"), 0.05);
    for (const char* const camera : {"turn", "roll"}) EXPECT_LT(texels(exact).at(camera).at("max"), 1.05);
  }
  EXPECT_GT(texels(2).at("error").at("mean"), 0.1);
  for (const char* const camera : {"turn", "roll"})
    EXPECT_GT(texels(2).at(camera).at("mean"), floor * 1.5) << camera;
  // It shows other texels on purpose.
  EXPECT_EQ(texels(3).at("error").at("max"), 0.0);
}

TEST(LabProgram, CompareMeasuresModels) {
  const TemporaryFolder folder;
  const ProgramRun run =
      lab(folder.path(),
          {"compare", "bsp-edges", "affine-models:perspective=1", "model-sprites:frames=3", "vertex-boxes",
           "--models", "5", "--distance", "60", "--size", "320x240", "--step", "180", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result.at("map"), "small level, 5 models at 60 units");
  const json& techniques = result.at("techniques");
  const auto error = [&](std::size_t number, const char* name) {
    return techniques.at(number).at("models").at(name).get<double>();
  };
  for (const std::size_t exact : {0, 1}) {
    EXPECT_LT(error(exact, "outline"), 0.002);
    EXPECT_LT(error(exact, "texels_off"), 0.002);
  }
  EXPECT_GT(error(2, "outline"), error(1, "outline"));
  EXPECT_GT(error(3, "outline"), 0.2);
  EXPECT_GT(techniques.at(0).at("stages").at("models"), 0.0);
  EXPECT_GT(techniques.at(2).at("bytes"), 0.0);
}

TEST(LabProgram, ExplainsMistakes) {
  const TemporaryFolder folder;
  struct Mistake {
    Words words;
    const char* message;
    int exit_status = 1;  // 2: the options are wrong, whatever the techniques are
  };
  const std::vector<Mistake> mistakes = {
      {{}, "lab must be followed by one of: list, run, compare", 2},
      {{"run"}, "TECHNIQUE is required", 2},
      {{"run", "nonsense"}, "there is no technique \"nonsense\""},
      {{"compare", "painter", "nonsense"}, "there is no technique \"nonsense\""},
      {{"run", "painter:pvs=7"}, "must be pvs=N, with a whole N from 0 to 1"},
      {{"run", "painter", "--map", "./missing.bsp"}, "missing.bsp"},
      {{"run", "painter", "--demo", "missing"}, "temblor: "},
      {{"run", "portals:portals=3"}, "has more than 3 portals, so portals cannot draw it"},
      {{"compare", "bsp-edges", "portals:portals=3"}, "has more than 3 portals"},
      {{"run", "painter", "-o", "x.gif"}, ".png", 2},
      {{"run", "painter", "-o", "nowhere/x.png"}, "nowhere/x.png"},
      {{"run", "affine-models"}, "affine-models draws models, and small level shows none; add --models N"},
      {{"run", "affine-models", "--models", "1001"}, "--models", 2},
      {{"run", "affine-models", "--models", "1", "--distance", "2"}, "--distance", 2},
      {{"run", "affine-models", "--models", "1", "--demo", "demo1"}, "excludes", 2},
      {{"run", "affine-models", "--models", "1", "--model", "missing"}, "temblor: "},
      {{"run", "painter", "--step", "0"}, "--step", 2}};
  for (const Mistake& mistake : mistakes) {
    Words words = mistake.words;
    if (!words.empty()) words.insert(words.end(), {"--size", "16x16"});
    const ProgramRun run = lab(folder.path(), words);
    EXPECT_EQ(run.exit_status, mistake.exit_status) << mistake.message;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(mistake.message));
  }
}

}  // namespace
}  // namespace temblor::test
