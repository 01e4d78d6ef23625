// Compares level scripts with their meaning: what is solid and what is not, tested point by point against the
// brushes of the map, and against the level that they compile to.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/level_script/carve.h"
#include "artgen/level_script/level_maker.h"
#include "artgen/level_script/level_script_map.h"
#include "artgen/scripts/script.h"
#include "compiler/drafts.h"
#include "formats/levels/map.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::artgen {
namespace {

ScriptLine parse_level(std::string_view text) {
  base::Result<std::vector<ScriptLine>> script = read_script(text);
  EXPECT_TRUE(script.ok()) << (script.ok() ? "" : script.error().message());
  return script.ok() && !script->empty() ? std::move(script)->front() : ScriptLine();
}

std::string make_level_text(std::string_view lines) {
  return fmt::format("level test floor=f walls=w ceiling=c\n{}", lines);
}

base::Result<std::string> make_map_text(std::string_view lines) {
  TRY(const std::vector<ArtPart> parts, make_level(parse_level(make_level_text(lines))));
  EXPECT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].path, "maps/test.map");
  return std::string(reinterpret_cast<const char*>(parts[0].bytes.data()), parts[0].bytes.size());
}

formats::Map build_map(std::string_view lines) {
  const base::Result<std::string> text = make_map_text(lines);
  EXPECT_TRUE(text.ok()) << (text.ok() ? "" : text.error().message());
  if (!text.ok()) return {};
  base::Result<formats::Map> map = formats::read_map(*text);
  EXPECT_TRUE(map.ok());
  return map.ok() ? std::move(map).value() : formats::Map();
}

std::string level_error(std::string_view lines) {
  const base::Result<std::string> text = make_map_text(lines);
  return text.ok() ? "none" : text.error().message();
}

const formats::MapEntity* find_class(const formats::Map& map, std::string_view classname) {
  const auto found = std::find_if(map.entities.begin(), map.entities.end(),
                                  [&](const auto& entity) { return entity.fields.classname() == classname; });
  return found == map.entities.end() ? nullptr : &*found;
}

// From the definition of a brush: a point is inside if it is behind all planes.
bool is_behind_all(const formats::MapBrush& brush, const math::Vec3d& point) {
  return std::all_of(brush.sides.begin(), brush.sides.end(), [&](const formats::MapSide& side) {
    const auto& [a, b, c] = side.points_world;
    return glm::dot(glm::cross(a - b, c - b), point - b) <= 0;
  });
}

bool is_solid(const formats::Map& map, const math::Vec3d& point) {
  for (const formats::MapEntity& entity : map.entities)
    for (const formats::MapBrush& brush : entity.brushes)
      if (is_behind_all(brush, point)) return true;
  return false;
}

struct RandomRooms {
  std::string lines;
  std::vector<Box> boxes;
};

RandomRooms make_random_rooms(std::uint64_t seed) {
  test::Random random(seed);
  RandomRooms rooms;
  for (int i = 0; i < 8; ++i) {
    Point low(0), size(0);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = 8 * static_cast<int>(random.below(32));
      size[axis] = 8 * (1 + static_cast<int>(random.below(20)));
    }
    rooms.boxes.push_back({low, low + size});
    rooms.lines += fmt::format("  room r{} {},{},{} size {}x{}x{} walls=w{}\n", i, low.x, low.y, low.z,
                               size.x, size.y, size.z, i % 3);
  }
  return rooms;
}

// How far the point is outside of the box, on the axis where it is farthest.
double distance_outside(const Box& box, const math::Vec3d& point) {
  double most = -1e9;
  for (int axis = 0; axis < 3; ++axis)
    most = std::max({most, box.low[axis] - point[axis], point[axis] - box.high[axis]});
  return most;
}

TEST(LevelScripts, TheShellFillsEverythingNearASpace) {
  for (std::uint64_t seed = 1; seed <= test::effort(40, 6); ++seed) {
    const RandomRooms rooms = make_random_rooms(seed);
    const formats::Map map = build_map(rooms.lines);
    test::Random random(seed + 1000);
    for (int i = 0; i < test::effort(3000, 300); ++i) {
      math::Vec3d point(0);
      for (int axis = 0; axis < 3; ++axis) point[axis] = static_cast<int>(random.below(480)) - 32 + 0.5;
      double nearest = 1e9;
      for (const Box& box : rooms.boxes) nearest = std::min(nearest, distance_outside(box, point));
      if (nearest > kShellThickness) continue;  // undefined
      ASSERT_EQ(is_solid(map, point), nearest > 0)
          << "seed " << seed << " at " << point.x << " " << point.y << " " << point.z;
    }
  }
}

TEST(LevelScripts, RoomsOfAnyShapeCompileWithoutALeak) {
  for (std::uint64_t seed = 1; seed <= test::effort(30, 4); ++seed) {
    const RandomRooms rooms = make_random_rooms(seed);
    const Point middle = (rooms.boxes[0].low + rooms.boxes[0].high) / 2;
    const std::string start =
        fmt::format("  entity info_player_start {},{},{}\n", middle.x, middle.y, middle.z);
    const base::Result<std::string> text = make_map_text(rooms.lines + start);
    ASSERT_TRUE(text.ok()) << "seed " << seed;
    compiler::Warnings warnings;
    const base::Result<compiler::DraftResult> draft = test::try_compile_draft(*text, warnings);
    ASSERT_TRUE(draft.ok()) << "seed " << seed;
    EXPECT_FALSE(draft->leak) << "seed " << seed;
    EXPECT_FALSE(draft->clip_hulls_leak) << "seed " << seed;
    for (const compiler::Warning& warning : warnings)
      ADD_FAILURE() << "seed " << seed << ": " << warning.what;
  }
}

// The texture of the first brush side that a ray from `from` meets, from the definition of brushes.
std::string find_visible_texture(const formats::Map& map, const math::Vec3d& from, const math::Vec3d& way) {
  double nearest = 1e9;
  std::string texture;
  for (const formats::MapEntity& entity : map.entities)
    for (const formats::MapBrush& brush : entity.brushes) {
      double enters = 0, leaves = 1e9;
      const formats::MapSide* through = nullptr;
      for (const formats::MapSide& side : brush.sides) {
        const auto& [a, b, c] = side.points_world;
        const math::Vec3d normal = glm::cross(a - b, c - b);
        const double before = glm::dot(normal, from - b), along = glm::dot(normal, way);
        if (along == 0) {
          if (before > 0) leaves = -1;
        } else if (along < 0) {
          if (-before / along >= enters) {
            enters = -before / along;
            through = &side;
          }
        } else {
          leaves = std::min(leaves, -before / along);
        }
      }
      if (through != nullptr && enters < leaves && enters < nearest) {
        nearest = enters;
        texture = through->texture;
      }
    }
  return texture;
}

TEST(LevelScripts, EachSpaceShowsItsOwnTextures) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 256,256,128 walls=wa north=na\n"
      "  room b 272,0,0 to 512,256,192 walls=wb\n"
      "  opening a b width=96 height=96 walls=wo floor=fo\n");
  EXPECT_EQ(find_visible_texture(map, {128, 128, 64}, {0, 1, 0}), "na");
  EXPECT_EQ(find_visible_texture(map, {128, 20, 64}, {1, 0, 0}), "wa");
  EXPECT_EQ(find_visible_texture(map, {400, 20, 64}, {-1, 0, 0}), "wb");
  EXPECT_EQ(find_visible_texture(map, {128, 128, 64}, {1, 0, 0}), "wb") << "through the opening";
  EXPECT_EQ(find_visible_texture(map, {264, 128, 64}, {0, 1, 0}), "wo");
  EXPECT_EQ(find_visible_texture(map, {264, 128, 64}, {0, 0, -1}), "fo");
  EXPECT_EQ(find_visible_texture(map, {300, 128, 64}, {0, 0, -1}), "f");
}

TEST(LevelScripts, EntitiesAreRelativeToTheirRoom) {
  const formats::Map map = build_map(
      "  room a 100,200,8 size 300x200x128\n"
      "    monster knight mid,end-50 face=north skill=normal,hard dm=no\n"
      "    item shells 50,60\n");
  const formats::MapEntity* knight = find_class(map, "monster_knight");
  ASSERT_NE(knight, nullptr);
  EXPECT_EQ(knight->fields.find("origin"), "250 350 32");
  EXPECT_EQ(knight->fields.find("angle"), "90");
  EXPECT_EQ(knight->fields.find("spawnflags"), "2304") << "not in easy, not in a deathmatch";
  const formats::MapEntity* shells = find_class(map, "item_shells");
  ASSERT_NE(shells, nullptr);
  EXPECT_EQ(shells->fields.find("origin"), "134 244 8") << "its box begins at its origin";
}

TEST(LevelScripts, GroupsAreTurnedAndMirrored) {
  const formats::Map map = build_map(
      "  group hut\n"
      "    room h$ 0,0,0 size 200x300x128 east=e\n"
      "      monster dog 50,100 face=east target=t$\n"
      "  place hut 1000,0,0 turn=90 copy=A\n"
      "  place hut 0,0,0 mirror=yes copy=B\n");
  std::vector<std::string> seen;
  for (const formats::MapEntity& entity : map.entities)
    if (entity.fields.classname() == "monster_dog")
      seen.push_back(fmt::format("{}; {}; {}", *entity.fields.find("origin"), *entity.fields.find("angle"),
                                 *entity.fields.find("target")));
  EXPECT_EQ(seen, (std::vector<std::string>{"900 50 24; 90; tA", "-50 100 24; 180; tB"}));
  EXPECT_EQ(find_visible_texture(map, {850, 100, 64}, {0, 1, 0}), "e") << "turned: its east is north";
  EXPECT_EQ(find_visible_texture(map, {-100, 100, 64}, {-1, 0, 0}), "e") << "mirrored: its east is west";
}

TEST(LevelScripts, ArchesStairsAndRampsAreSolidWhereTheyShouldBe) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 256,256,256\n"
      "    arch 0,0,128 to 256,32,256 along=y pieces=16\n"
      "    stairs 0,64,0 to 64,192,64 up=north\n"
      "    ramp 128,64,0 to 192,192,64 up=east\n");
  // Below a half circle that is 256 wide and 128 high, with one unit of tolerance for its chords.
  for (int x = 4; x < 256; x += 12)
    for (int z = 130; z < 256; z += 12) {
      const double from_middle = std::hypot(x - 128.0, z - 128.0);
      if (std::abs(from_middle - 128) < 3) continue;
      EXPECT_EQ(is_solid(map, {x + 0.1, 16.1, z + 0.1}), from_middle > 128) << x << " " << z;
    }
  for (int y = 65; y < 192; y += 6)
    for (int z = 2; z < 80; z += 5)
      EXPECT_EQ(is_solid(map, {32.1, y + 0.3, z + 0.3}), z < 16 * ((y - 64) / 32 + 1)) << y << " " << z;
  for (int x = 129; x < 192; x += 6)
    for (int z = 2; z < 80; z += 5)
      EXPECT_EQ(is_solid(map, {x + 0.1, 100.1, z + 0.5}), z < x - 128) << x << " " << z;
}

TEST(LevelScripts, PassagesClimbInSteps) {
  const formats::Map map = build_map("  passage 0,0,0 to 200,0,0 to 200,400,160 width=80 height=100\n");
  int floor = 0;
  for (int y = 0; y <= 400; y += test::effort(1, 5)) {
    int z = floor;
    while (z < 300 && is_solid(map, {200.5, y + 0.5, z + 0.5})) ++z;
    ASSERT_LE(z - floor, 16) << "a step at " << y;
    for (int up = 1; up < 84; ++up) ASSERT_FALSE(is_solid(map, {200.5, y + 0.5, z + up + 0.5})) << y;
    floor = z;
  }
  EXPECT_EQ(floor, 160);
}

TEST(LevelScripts, RockLeavesOpeningsFree) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 512,512,256\n"
      "    cave rock rough=60 seed=5\n"
      "  room b 528,0,0 to 800,512,256\n"
      "  opening a b width=96 height=96\n");
  for (int y = 209; y < 304; y += 5)
    for (int x = 440; x < 540; x += 3) EXPECT_FALSE(is_solid(map, {x + 0.5, y + 0.5, 60.5})) << x << " " << y;
  int bulging = 0;
  for (int y = 4; y < 512; y += 20)
    for (int z = 40; z < 256; z += 20) bulging += is_solid(map, {4.5, y + 0.5, z + 0.5}) ? 1 : 0;
  EXPECT_GT(bulging, 100) << "the far wall is rock";
}

// How far the rock of the west wall protrudes at a point.
int measure_rock(const formats::Map& map, int y, int z) {
  int x = 0;
  while (x < 256 && is_solid(map, {x + 0.5, y + 0.5, z + 0.5})) ++x;
  return x;
}

TEST(LevelScripts, RockHasLayers) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 512,512,256\n"
      "    cave rock rough=120 seed=5 layers=mud layer=64 sides=west\n");
  std::set<int> first_column;
  for (int layer = 0; layer < 4; ++layer) {
    for (int y = 5; y < 512; y += test::effort(7, 50)) {
      const int lowest = measure_rock(map, y, 64 * layer + 1);
      EXPECT_GE(lowest, 8);
      EXPECT_EQ(measure_rock(map, y, 64 * layer + 62), lowest) << layer << " " << y;
    }
    first_column.insert(measure_rock(map, 5, 64 * layer + 32));
  }
  EXPECT_GE(first_column.size(), 3u) << "layers protrude differently";
  std::map<std::string, int> fronts;
  for (const formats::MapBrush& brush : find_class(map, "func_detail")->brushes)
    ++fronts[brush.sides[0].texture];
  EXPECT_EQ(fronts["rock"], 16);
  EXPECT_EQ(fronts["mud"], 16);
  EXPECT_EQ(level_error("  room a 0,0,0 to 512,512,256\n"
                        "    cave rock layer=64\n"),
            "line 3: cave: unknown setting 'layer'");
}

TEST(LevelScripts, PartsOfATrainKeepItsLowerCorner) {
  EXPECT_EQ(level_error("  room a 0,0,0 to 256,256,128\n"
                        "    train 64,64,0 size 64x64x16 plate\n"
                        "      stop 64,64,0\n"
                        "      stop 64,128,0\n"
                        "      part 60,64,16 to 128,68,48 plate\n"),
            "line 6: part: it reaches farther west, south or down than the train's own box");
}

TEST(LevelScripts, BrushEntitiesHaveParts) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 256,256,128\n"
      "    brush func_wall 64,64,0 size 32x32x32 plate\n"
      "      part 32,32,32 to 48,48,64 wood\n");
  const formats::MapEntity* wall = find_class(map, "func_wall");
  ASSERT_NE(wall, nullptr);
  ASSERT_EQ(wall->brushes.size(), 2u);
  EXPECT_TRUE(is_behind_all(wall->brushes[0], {70, 70, 16}));
  EXPECT_TRUE(is_behind_all(wall->brushes[1], {40, 40, 48}));
  EXPECT_EQ(wall->brushes[1].sides[0].texture, "wood");
  EXPECT_EQ(level_error("  room a 0,0,0 to 256,256,128\n"
                        "    brush func_wall 64,64,0 size 32x32x32 plate\n"
                        "      stop 64,64,0\n"),
            "line 4: stop: only 'part' lines can be under a brush entity");
}

TEST(LevelScripts, ClipUnderALeaningCrystalStopsPlayersButNotLights) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 256,256,128\n"
      "    crystal 128,128 height=96 radius=8 lean=20,0\n"
      "    light 142,128,12\n");
  const formats::MapEntity* detail = find_class(map, "func_detail");
  ASSERT_NE(detail, nullptr);
  const auto is_clip = [](const formats::MapBrush& brush) { return brush.sides[0].texture == "clip"; };
  const auto clip = std::find_if(detail->brushes.begin(), detail->brushes.end(), is_clip);
  ASSERT_NE(clip, detail->brushes.end());
  // Below the leaning part, where a player on the floor would be.
  EXPECT_TRUE(is_behind_all(*clip, {142, 128, 20}));
}

TEST(LevelScripts, BrushEntitiesHaveTheirKeys) {
  const formats::Map map = build_map(
      "  room a 0,0,0 to 256,256,128\n"
      "  room b 0,272,0 to 256,512,128\n"
      "  opening a b width=96 height=96\n"
      "    door wood key=gold double=yes speed=80\n"
      "  room c 300,0,0 to 600,300,128\n"
      "    train 0,0,0 size 64x64x16 plate\n"
      "      stop 0,0,0 wait=2\n"
      "      stop 0,100,0\n"
      "      part 0,0,16 to 64,4,48 plate\n"
      "    button north 64,40 size 32x32 target=gate\n");
  std::vector<std::string> doors;
  for (const formats::MapEntity& entity : map.entities)
    if (entity.fields.classname() == "func_door") {
      EXPECT_EQ(entity.fields.find("spawnflags"), "8");
      EXPECT_EQ(entity.fields.find("speed"), "80");
      doors.emplace_back(*entity.fields.find("angle"));
    }
  EXPECT_EQ(doors, (std::vector<std::string>{"180", "360"}));
  const formats::MapEntity* train = find_class(map, "func_train");
  ASSERT_NE(train, nullptr);
  EXPECT_EQ(train->brushes.size(), 2u);
  // Follow the targets around the track, back to the first stop.
  std::string next(*train->fields.find("target"));
  std::vector<std::string> track;
  for (int i = 0; i < 3; ++i)
    for (const formats::MapEntity& entity : map.entities)
      if (entity.fields.find("targetname") == next && track.size() < static_cast<std::size_t>(i) + 1) {
        track.emplace_back(*entity.fields.find("origin"));
        next = *entity.fields.find("target");
        break;
      }
  EXPECT_EQ(track, (std::vector<std::string>{"300 0 0", "300 100 0", "300 0 0"}));
  const formats::MapEntity* button = find_class(map, "func_button");
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->fields.find("angle"), "90");
  EXPECT_TRUE(is_behind_all(button->brushes[0], {380, 296, 56}));
  EXPECT_FALSE(is_behind_all(button->brushes[0], {380, 288, 56}));
}

TEST(LevelScripts, ErrorsNameTheLine) {
  EXPECT_EQ(level_error("  lump 3\n"), "line 2: lump: unknown level script keyword");
  EXPECT_EQ(level_error("  room a 0,0,0 to 64,64\n"), "line 2: room: the box 0,0,0 to 64,64,0 is empty");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64\n  opening a b\n"),
            "line 3: opening: no room 'b' is defined above this line");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64\n  room a 0,0,0 size 64x64x64\n"),
            "line 3: room: room 'a' is already defined");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64\n    light 32,32,80\n"),
            "line 3: light light: at 32,32,80 is in solid rock");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64\n"
                        "    block 0,0,0 to 40,40,40 crate\n"
                        "    light 32,32,32\n"),
            "line 4: light light: at 32,32,32 is inside the solid of line 3 (crate)");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64 carpet=red\n"),
            "line 2: room: unknown setting 'carpet'");
  EXPECT_EQ(
      level_error("  room a 0,0,0 size 64x64x64\n    light mid,3.5,5\n"),
      "line 3: light: '3.5' is not a coordinate: expected a whole number, mid or end, or mid+N or end-N");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64\n    item spoon 5,5\n").substr(0, 28),
            "line 3: item: 'spoon' is not");
  EXPECT_EQ(level_error("  room a 0,0,0 size 64x64x64\n  room b 0,0,100 size 64x64x64\n  opening a b\n"),
            "line 4: opening: the two rooms have no walls that face each other");
  EXPECT_EQ(level_error("  group g\n    place g 0,0,0\n  place g 0,0,0\n"),
            "line 3: place: no group is named 'g'");
  EXPECT_EQ(level_error(""), "line 1: level: the level has no room");
}

}  // namespace
}  // namespace temblor::artgen
