// The contents of compiled levels, compared with a second, simple reading of the map's text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "assets/assets.h"
#include "base/text.h"
#include "compiler/compiled_maps.h"
#include "formats/levels/entities.h"
#include "formats/levels/lit.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
using ::testing::IsSubsetOf;

struct PlainPlane {
  math::Vec3d normal{0.0};
  double distance = 0;
};

// Reads the text line by line, as TrenchBroom writes it: "{" and "}", `"key" "value"`, "( x y z ) ( ... ) (
// ... ) texture ...".
struct PlainMap {
  std::size_t entities = 0;        // in the level
  std::size_t brush_entities = 0;  // those with brushes
  std::set<std::string> textures;  // in lower case
  std::vector<PlainPlane> planes;  // of the world's brushes
};

bool is_merged_into_world(const std::string& classname) {
  return classname == "func_group" || classname.starts_with("func_detail");
}

PlainMap read_plainly(const std::string& text) {
  PlainMap map;
  std::istringstream lines(text);
  std::string classname;
  int depth = 0, brushes = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('{')) {
      if (++depth == 2) ++brushes;
      if (depth == 1) brushes = 0;
    } else if (line.starts_with('}')) {
      if (--depth > 0 || is_merged_into_world(classname)) continue;
      ++map.entities;
      if (brushes > 0 && classname != "worldspawn") ++map.brush_entities;
    } else if (line.starts_with("\"classname\" \"")) {
      classname = line.substr(13, line.find('"', 13) - 13);
    } else if (line.starts_with('(')) {
      std::istringstream words(line);
      std::string bracket, texture;
      math::Vec3d p[3];
      for (math::Vec3d& point : p) words >> bracket >> point.x >> point.y >> point.z >> bracket;
      words >> texture;
      map.textures.insert(base::to_lower(texture));
      if (classname != "worldspawn" && !is_merged_into_world(classname)) continue;
      const math::Vec3d normal = glm::normalize(glm::cross(p[0] - p[1], p[2] - p[1]));
      map.planes.push_back({normal, glm::dot(normal, p[1])});
    }
  }
  return map;
}

// In either direction: liquids are also seen from inside.
bool has_plane(const PlainMap& map, const formats::BspPlane& plane) {
  return std::any_of(map.planes.begin(), map.planes.end(), [&](const PlainPlane& known) {
    const math::Vec3d normal(plane.normal);
    const double sign = glm::dot(known.normal, normal) < 0 ? -1 : 1;
    return glm::length(known.normal * sign - normal) < 1e-4 &&
           std::abs(known.distance * sign - double{plane.distance}) < 0.02;
  });
}

// In a map, the first frame of an animation stands for all of them.
std::string without_frame(std::string texture) {
  if (texture.size() > 1 && texture.front() == '+') texture[1] = '#';
  return texture;
}

std::set<std::string> find_texture_names(const formats::Bsp& bsp) {
  std::set<std::string> names;
  for (const formats::BspMiptex& texture : bsp.miptexes)
    names.insert(without_frame(base::to_lower(texture.name)));
  return names;
}

// Item boxes: no player starts in them.
bool is_box(const std::string& name) {
  return name.starts_with("b_");
}

class LevelCounts : public ::testing::TestWithParam<const char*> {};

TEST_P(LevelCounts, MatchTheMapTextAndTheFinishedLevel) {
  DATA_FOLDER_OR_SKIP(data);
  const std::string name = GetParam();
  const base::ByteVector text = read_file(data / "mapsrc" / (name + ".map"));
  const PlainMap plain = read_plainly(std::string(base::as_text(text)));
  compiler::CompileOptions options;
  options.visibility_policy = options.light_policy = compiler::StagePolicy::kSkip;
  const CompiledMap compiled = compile_stock_map(data, name, options);
  const formats::Bsp& bsp = compiled.level.bsp;

  EXPECT_EQ(formats::read_entities(bsp.entities).value().size(), plain.entities);
  EXPECT_EQ(bsp.models.size(), plain.brush_entities + 1);
  std::set<std::string> in_map;
  for (const std::string& texture : plain.textures) in_map.insert(without_frame(texture));
  const std::set<std::string> ours = find_texture_names(bsp);
  EXPECT_THAT(ours, IsSubsetOf(in_map));
  const base::ByteVector finished = read_file(data / "id1/maps" / (name + ".bsp"));
  // The finished level also lists textures that no face shows.
  EXPECT_THAT(ours, IsSubsetOf(find_texture_names(formats::read_bsp(finished).value())));
  std::set<std::uint32_t> planes_of_faces;
  for (std::uint32_t i = 0; i < bsp.models.front().face_count; ++i)
    planes_of_faces.insert(bsp.faces[bsp.models.front().first_face + i].plane);
  for (const std::uint32_t plane : planes_of_faces)
    EXPECT_TRUE(has_plane(plain, bsp.planes[plane])) << "plane " << plane << " is no brush's";
}

TEST_P(LevelCounts, LevelLoadsWithoutAWarning) {
  DATA_FOLDER_OR_SKIP(data);
  compiler::CompileOptions options;
  options.fast_visibility = true;
  options.light.fast = true;
  // Its thousands of lights would take seconds.
  if (std::string(GetParam()) == "lqdm5") options.light_policy = compiler::StagePolicy::kSkip;
  const CompiledMap compiled = compile_stock_map(data, GetParam(), options);
  // The only mistakes in the maps: boxes are no places to start, two keys are misspelled, and some exceed
  // stock limits.
  const auto is_known = [&](const compiler::Warning& warning) {
    if (warning.kind == "unknown key")
      return warning.what.find("_nolight is ignored") != std::string::npos ||
             warning.what.find("_sun_mangle_ is ignored") != std::string::npos;
    if (warning.kind.find("exceed the original engine's limit") != std::string::npos) return true;
    return is_box(GetParam()) &&
           (warning.kind == "no info_player_start" || warning.kind == "no entity has an origin");
  };
  for (const compiler::Warning& warning : compiled.warnings)
    EXPECT_TRUE(is_known(warning)) << warning.kind << ": " << warning.what;
  const base::ByteVector bytes = formats::write_bsp(compiled.level.bsp, formats::BspVersion::k29).value();
  TemporaryFolder folder;
  folder.write("level.bsp", base::as_text(bytes));
  if (compiled.level.lit) folder.write("level.lit", base::as_text(formats::write_lit(*compiled.level.lit)));
  EXPECT_THAT(assets::load_level_file(folder.path() / "level.bsp").value().notes, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, LevelCounts, ::testing::ValuesIn(stock_maps()),
                         [](const auto& map) { return std::string(map.param); });

// From text to bytes: BSP, visibility, and colored light with bounces.
TEST(Determinism, SameBytesForAnyNumberOfThreads) {
  DATA_FOLDER_OR_SKIP(data);
  const std::string name = kQuick ? "lq_e0m9" : "start";
  compiler::CompileOptions options;
  options.light.bounces = 1;
  options.light.dirt = true;
  const auto count_bytes = [&](int threads) {
    const compiler::Build level = compile_stock_map(data, name, options, threads).level;
    EXPECT_TRUE(level.lit);
    return std::pair(formats::write_bsp(level.bsp, formats::BspVersion::k29).value(),
                     level.lit ? formats::write_lit(*level.lit) : base::ByteVector{});
  };
  const auto one = count_bytes(1);
  EXPECT_GT(one.first.size(), 10000u);
  for (const int threads : {2, 3}) EXPECT_TRUE(count_bytes(threads) == one) << threads << " threads";
}

}  // namespace
}  // namespace temblor::test
