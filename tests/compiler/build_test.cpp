// Incremental builds: a level that is brought up to date equals the level of a clean build.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

#include "artgen/palette.h"
#include "compiler/build_file.h"
#include "compiler/compile_level.h"
#include "formats/levels/lit.h"
#include "support/effort.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using compiler::Build;
using compiler::CompileOptions;
using compiler::StagePolicy;
using math::Vec3d;

class Stopper : public compiler::CompileWatcher {
 public:
  void begin_stage(const char* name) override { stage_ = name; }
  bool progress(std::size_t, std::size_t) override { return stage_ != stop_at; }

  std::string stop_at;

 private:
  std::string stage_;
};

// Two rooms with a door between them, and everything that can be changed in them.
struct Place {
  Vec3d lamp{0, 64, 96}, monster{-64, 0, 40};
  int lamp_brightness = 250;
  std::string lamp_name, door_speed = "100", wall = "wall";
  double pillar_x = 64;
  int minlight = 0;
  std::string glow_wait = "1";
  std::string lamp_keys, door_keys;

  std::string text() const {
    std::string brushes = walls_text({-128, -128, 0}, {384, 128, 128}, wall);
    brushes += box_text({120, -128, 0}, {136, -32, 128}, wall);
    brushes += box_text({120, 32, 0}, {136, 128, 128}, wall);
    brushes += box_text({pillar_x, 64, 0}, {pillar_x + 16, 80, 128}, wall);
    const std::string name = lamp_name.empty() ? "" : fmt::format("\n\"targetname\" \"{}\"", lamp_name);
    return entity_text("worldspawn", fmt::format("\"_minlight\" \"{}\"", minlight), brushes) +
           point_text("info_player_start", {0, 0, 32}) + point_text("monster_ogre", monster) +
           entity_text("light", fmt::format("\"origin\" \"{} {} {}\"\n\"light\" \"{}\"{}\n{}", lamp.x, lamp.y,
                                            lamp.z, lamp_brightness, name, lamp_keys)) +
           entity_text("light", "\"origin\" \"300 0 96\"\n\"_color\" \"1 0.5 0\"") +
           entity_text("light_glow", fmt::format("\"origin\" \"200 0 60\"\n\"wait\" \"{}\"", glow_wait),
                       box_text({250, 90, 0}, {260, 100, 20}, "lamp")) +
           entity_text("func_door", fmt::format("\"speed\" \"{}\"\n{}", door_speed, door_keys),
                       box_text({124, -32, 0}, {132, 32, 96}, "door"));
  }
};

compiler::CompileReport bring_up_to_date(const Place& place, const CompileOptions& options, Build& io_build,
                                         int threads = 1) {
  base::Jobs jobs(threads, base::JobBackend::kStdThread);
  Stopper watcher;
  compiler::Warnings warnings;
  return compiler::compile_level({parse_map(place.text()), {}, artgen::make_palette()}, options,
                                 {jobs, watcher, warnings}, io_build)
      .value();
}

Build make(const Place& place, const CompileOptions& options = {}) {
  Build build;
  bring_up_to_date(place, options, build);
  return build;
}

// The stages that a run built, in order; reused ones are left out.
std::vector<std::string> stages_run(const compiler::CompileReport& report) {
  std::vector<std::string> names;
  for (const compiler::StageTime& time : report.times)
    if (time.wall_s && std::string(time.name) != "textures") names.emplace_back(time.name);
  return names;
}

struct Files {
  base::ByteVector bsp, lit, build;
};
Files list_build_files(const Build& build) {
  Files files;
  files.bsp = formats::write_bsp(build.bsp, build.bsp.version).value();
  if (build.lit) files.lit = formats::write_lit(*build.lit);
  files.build = compiler::write_build(build, {files.bsp, files.lit});
  return files;
}
Build reread(const Files& files) {
  return compiler::read_build(files.build, {files.bsp, files.lit}).value();
}

void expect_same_level(const Build& a, const Build& b) {
  EXPECT_EQ(a.bsp, b.bsp);
  EXPECT_EQ(a.lit, b.lit);
}

TEST(Build, OnlyChangedStagesRun) {
  using Names = std::vector<std::string>;
  struct Case {
    const char* what;
    void (*change)(Place&);
    Names stages;
  };
  const Case cases[] = {
      {"nothing", [](Place&) {}, {}},
      {"a monster", [](Place& place) { place.monster.x = -30; }, {}},
      {"what only the game reads of a door", [](Place& place) { place.door_speed = "40"; }, {}},
      {"a lamp's place", [](Place& place) { place.lamp.x = 20; }, {"light"}},
      {"a lamp's name", [](Place& place) { place.lamp_name = "lamp"; }, {"light"}},
      {"the world's least light", [](Place& place) { place.minlight = 9; }, {"light"}},
      {"how far a light with a brush reaches", [](Place& place) { place.glow_wait = "4"; }, {"light"}},
      {"a lamp's channels",
       [](Place& place) { place.lamp_keys = "\"_light_channel_mask\" \"3\""; },
       {"light"}},
      {"a picture", [](Place& place) { place.lamp_keys = "\"_project_texture\" \"wall\""; }, {"light"}},
      {"a switchable shadow",
       [](Place& place) { place.door_keys = "\"_switchableshadow\" \"1\""; },
       {"light"}},
      {"a brush", [](Place& place) { place.pillar_x = 32; }, {"bsp", "visibility", "light"}},
      {"a texture", [](Place& place) { place.wall = "brick"; }, {"bsp", "visibility", "light"}},
      {"a lamp's place, into a pillar",
       [](Place& place) {
         place.lamp = {70, 70, 60};
       },
       {"bsp", "visibility", "light"}},
  };
  for (const Case& c : cases) {
    Place place;
    Build build = make(place);
    c.change(place);
    EXPECT_EQ(stages_run(bring_up_to_date(place, {}, build)), c.stages) << c.what;
    expect_same_level(build, make(place));
  }
}

TEST(Build, AnyEditsGiveTheSameLevelAsACleanBuild) {
  std::mt19937 random(7);
  const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  Place place;
  Build build = make(place);
  for (int edit = 0; edit < effort(40, 6); ++edit) {
    constexpr const char* kLampKeys[] = {"", "\"_shadow_channel_mask\" \"2\"",
                                         "\"_light_channel_mask\" \"6\"", "\"_project_texture\" \"wall\"",
                                         "\"_dirt\" \"1\""};
    constexpr const char* kDoorKeys[] = {"", "\"_switchableshadow\" \"1\"", "\"_object_channel_mask\" \"2\"",
                                         "\"_minlight_exclude\" \"door\"",
                                         "\"_switchableshadow_target\" \"lamp\""};
    switch (number(9)) {
      case 0:
        place.monster = {number(200) - 100, number(200) - 100, 40};
        break;
      case 1:
        place.lamp = {number(400) - 100, number(200) - 100, 16 + number(100)};
        break;
      case 2:
        place.lamp_brightness = 100 + number(300);
        break;
      case 3:
        place.lamp_name = number(2) == 0 ? "" : "lamp";
        break;
      case 4:
        place.door_speed = fmt::format("{}", 50 + number(100));
        break;
      case 5:
        place.pillar_x = 8 * number(8);
        break;
      case 6:
        place.lamp_keys = kLampKeys[number(5)];
        break;
      case 7:
        place.door_keys = kDoorKeys[number(5)];
        break;
      default:
        place.minlight = number(40);
        break;
    }
    CompileOptions options;
    options.fast_visibility = number(4) == 0;
    options.visibility_policy = number(5) == 0 ? StagePolicy::kSkip : StagePolicy::kBuild;
    options.light_policy = number(5) == 0 ? StagePolicy::kSkip : StagePolicy::kBuild;
    options.bsp2 = number(6) == 0;
    if (number(2) == 0) build = reread(list_build_files(build));  // as a new process reads it
    bring_up_to_date(place, options, build, 1 + number(2));
    expect_same_level(build, make(place, options));
    ASSERT_FALSE(testing::Test::HasFailure()) << "edit " << edit;
  }
}

// Running a single stage keeps the results of the others that still fit the brushes.
TEST(Build, ReusedStagesStayUntilBrushesChange) {
  CompileOptions only_bsp;
  only_bsp.visibility_policy = only_bsp.light_policy = StagePolicy::kReuse;
  Place place;
  Build build = make(place);
  const formats::Bsp before = build.bsp;
  place.lamp.x = 30;
  bring_up_to_date(place, only_bsp, build);
  EXPECT_EQ(build.bsp.lighting, before.lighting);
  EXPECT_EQ(build.bsp.visibility, before.visibility);
  EXPECT_NE(build.bsp.entities, before.entities);
  // The old result is known to be out of date.
  EXPECT_EQ(stages_run(bring_up_to_date(place, {}, build)), std::vector<std::string>{"light"});
  expect_same_level(build, make(place));
  place.pillar_x = 0;
  bring_up_to_date(place, only_bsp, build);
  EXPECT_TRUE(build.bsp.lighting.empty());
  EXPECT_TRUE(build.bsp.visibility.empty());
  EXPECT_FALSE(build.lit);
}

TEST(Build, LeaksAreFoundEachTime) {
  Place place;
  place.monster = {2000, 0, 0};
  Build build;
  EXPECT_TRUE(bring_up_to_date(place, {}, build).leak);
  EXPECT_TRUE(bring_up_to_date(place, {}, build).leak);
  place.monster = {0, 0, 40};
  EXPECT_FALSE(bring_up_to_date(place, {}, build).leak);
  expect_same_level(build, make(place));
}

// A wall that seals the room in the drawn hull but not in the clip hulls. Whether those get filled depends on
// where entities are, though none of them moves into or out of drawn solid.
std::string room_open_to_boxes(const Vec3d& start, int hulls) {
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  const std::size_t first_end = walls.find("}\n") + 2;
  return entity_text("worldspawn", "", walls.substr(first_end)) +
         entity_text("func_group", fmt::format("\"_hulls\" \"{}\"", hulls), walls.substr(0, first_end)) +
         point_text("info_player_start", start);
}

TEST(Build, OpenHullsAreFilledAsInACleanBuild) {
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  compiler::CompileWatcher nobody;
  compiler::Warnings warnings;
  const auto compile = [&](const Vec3d& start, int hulls, Build& io_build) {
    ASSERT_TRUE(
        compiler::compile_level({parse_map(room_open_to_boxes(start, hulls)), {}, artgen::make_palette()}, {},
                                {jobs, nobody, warnings}, io_build)
            .ok());
  };
  std::mt19937 random(5);
  const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  // Drawn only; missing in the players' hull; missing in that of large monsters.
  for (const int hulls : {1, 5, 3}) {
    std::set<std::size_t> hull_sizes;
    Build build;
    for (int edit = 0; edit < effort(30, 8); ++edit) {
      // At the center of the room, or so near to a wall that a box does not fit.
      const Vec3d start(number(90), number(2) == 0 ? number(60) : 120, 60);
      compile(start, hulls, build);
      Build fresh;
      compile(start, hulls, fresh);
      hull_sizes.insert(fresh.bsp.clipnodes.size());
      expect_same_level(build, fresh);
      ASSERT_FALSE(testing::Test::HasFailure()) << "hulls " << hulls << ", edit " << edit;
    }
    EXPECT_GE(hull_sizes.size(), 2u) << "both filled hulls and open ones";
  }
}

TEST(Build, MapsWithoutLeadingWorldspawnFailEachTime) {
  const std::string text = Place{}.text();
  Build build = make({});
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  compiler::CompileWatcher nobody;
  compiler::Warnings warnings;
  EXPECT_FALSE(compiler::compile_level(
                   {parse_map(point_text("monster_ogre", {0, 0, 40}) + text), {}, artgen::make_palette()}, {},
                   {jobs, nobody, warnings}, build)
                   .ok());
}

TEST(Build, StoppedVisibilityIsKept) {
  const Place place;
  Build build;
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  Stopper watcher;
  watcher.stop_at = "visibility";
  compiler::Warnings warnings;
  const auto stopped = compiler::compile_level({parse_map(place.text()), {}, artgen::make_palette()}, {},
                                               {jobs, watcher, warnings}, build);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, base::ErrorCode::kUsage);
  ASSERT_FALSE(build.visibility_state.empty());
  // The level was not written, so the next run has only the state.
  Build next;
  next.visibility_state = build.visibility_state;
  bring_up_to_date(place, {}, next);
  EXPECT_TRUE(next.visibility_state.empty());
  expect_same_level(next, make(place));
}

TEST(Build, RelightingWithoutAMapKeepsEverythingElse) {
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  compiler::CompileWatcher nobody;
  compiler::Warnings warnings;
  formats::Bsp bsp = make({}).bsp;
  bsp.bspx.push_back({"BRUSHLIST", base::ByteVector(4)});
  Build build = compiler::make_build_from_level(bsp, {}, true).value();
  CompileOptions options;
  options.light_policy = StagePolicy::kSkip;
  const auto finish = [&] {
    return stages_run(
        compiler::finish_level(artgen::make_palette(), options, {jobs, nobody, warnings}, build).value());
  };
  const std::vector<std::string> visibility_alone{"visibility"};
  EXPECT_EQ(finish(), visibility_alone);
  EXPECT_TRUE(build.bsp.lighting.empty());
  EXPECT_EQ(build.bsp.find_bspx("RGBLIGHTING"), nullptr);
  EXPECT_NE(build.bsp.find_bspx("BRUSHLIST"), nullptr);
  EXPECT_TRUE(finish().empty());
  options.draft.water_is_transparent = false;
  EXPECT_EQ(finish(), visibility_alone) << "its portals are others";
}

TEST(BuildFile, ReadsBackEqual) {
  const Files files = list_build_files(make({}));
  EXPECT_EQ(list_build_files(reread(files)).build, files.build);
}

TEST(BuildFile, IgnoresAnotherLevel) {
  const Files files = list_build_files(make({}));
  Place other;
  other.lamp.x = 40;
  const Files others = list_build_files(make(other));
  EXPECT_TRUE(compiler::read_build(files.build, {others.bsp, others.lit})->bsp.models.empty());
  EXPECT_TRUE(compiler::read_build(files.build, {files.bsp, {}})->bsp.models.empty());
  EXPECT_TRUE(compiler::read_build(files.build, {})->bsp.models.empty());
}

TEST(BuildFile, DetectsDamage) {
  const Files files = list_build_files(make({}));
  for (std::size_t i = 0; i < files.build.size(); i += 1 + files.build.size() / 97) {
    base::ByteVector damaged = files.build;
    damaged[i] ^= std::byte{0x10};
    EXPECT_FALSE(compiler::read_build(damaged, {files.bsp, files.lit}).ok()) << "byte " << i;
    damaged.resize(i);
    EXPECT_FALSE(compiler::read_build(damaged, {files.bsp, files.lit}).ok()) << "cut at " << i;
  }
}

}  // namespace
}  // namespace temblor::test
