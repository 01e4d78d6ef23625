// Compares the shipped creatures with the QuakeC that animates them, whose sequences, speeds, and hulls are
// read from its source.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "art_scripts/stock_data.h"
#include "artgen/art.h"
#include "artgen/models/model.h"
#include "artgen/scripts/parts.h"
#include "base/check.h"
#include "base/parallel_for.h"
#include "formats/models/mdl.h"
#include "support/models/mdl_places.h"

namespace temblor::artgen {
namespace {

namespace fs = std::filesystem;
using formats::Mdl;
using math::Vec3d;
using test::Extent;
using test::frame_extent;
using test::vertex_position;

const fs::path kSource = TEMBLOR_SOURCE_DIR;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> list_files(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> list_quakec_files() {
  std::vector<fs::path> files = list_files(kSource / "game/quakec", ".qc");
  std::erase_if(files, test::needs_stock_data);
  return files;
}

std::vector<ScriptFile> shipped_scripts() {
  std::vector<ScriptFile> scripts;
  for (const fs::path& path : list_files(kSource / "game/art/models", ".art")) {
    auto things = read_script(read_text(path));
    EXPECT_TRUE(things.ok()) << path << (things.ok() ? "" : things.error().message());
    if (things.ok()) scripts.push_back({path.string(), std::move(things).value()});
  }
  return scripts;
}

struct Sequence {
  std::string name;
  std::size_t first = 0, last = 0;
};

// The facts in a QuakeC file about its model. Sequences have names in lower case: "run" for KNIGHT_RUN.
struct Played {
  std::string model;
  std::vector<Sequence> sequences;
  std::optional<double> walk_speed, run_speed;  // units per frame
  bool large = false;
};

std::optional<double> find_number(const std::string& text, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(pattern + "\\((\\d+)\\)"))) return {};
  return std::stod(found[1]);
}

Played read_played(const std::string& text) {
  Played played;
  std::smatch found;
  if (!std::regex_search(text, found, std::regex("\n// (progs/\\w+\\.mdl)\n"))) return played;
  played.model = found[1];
  std::map<std::string, std::size_t> frames;
  const std::regex constant("const float [A-Z]+_([A-Z_]+) = (\\d+);");
  for (std::sregex_iterator it(text.begin(), text.end(), constant), end; it != end; ++it)
    frames[(*it)[1]] = std::stoul((*it)[2]);
  for (const auto& [name, first] : frames)
    if (const auto last = frames.find(name + "_END"); last != frames.end())
      played.sequences.push_back({name, first, last->second});
  played.walk_speed = find_number(text, "creature_walks");
  played.run_speed = find_number(text, "creature_runs");
  played.large = text.find("LARGE_HULL_MAX") != std::string::npos;
  return played;
}

// All models, with very coarse skins, which save time and are not tested here. CHECK, because tests after a
// failed assertion in SetUpTestSuite() count as skipped.
class Creatures : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    Parts parts;
    const std::vector<ScriptFile> scripts = shipped_scripts();
    for (const ScriptFile& script : scripts)
      for (const ScriptLine& line : script.assets)
        if (line.keyword == "part") {
          CHECK(add_part(line, parts).ok(), "{}", script.name);
        }
    for (const ScriptFile& script : scripts) {
      for (const ScriptLine& line : script.assets) {
        if (line.keyword != "model") continue;
        const auto whole = expand_parts(line, parts);
        CHECK(whole.ok(), "{}: {}", script.name, whole.error().message());
        auto model = read_model(*whole);
        CHECK(model.ok(), "{}: {}", script.name, model.error().message());
        model->density = 0.1;
        mdls()[model->path] = make_mdl(*model);
        models()[model->path] = std::move(model).value();
      }
    }
    for (const fs::path& path : list_quakec_files())
      if (const Played read = read_played(read_text(path)); !read.model.empty()) played().push_back(read);
    CHECK(played().size() == 15, "{}", played().size());
  }
  static std::map<std::string, Model>& models() {
    static std::map<std::string, Model> all;
    return all;
  }
  static std::map<std::string, Mdl>& mdls() {
    static std::map<std::string, Mdl> all;
    return all;
  }
  static std::vector<Played>& played() {
    static std::vector<Played> all;
    return all;
  }
  static std::vector<Played> monsters() {
    std::vector<Played> some = played();
    std::erase_if(some, [](const Played& p) { return p.model == "progs/player.mdl"; });
    return some;
  }
};

std::string find_animation_name(const Mdl& mdl, std::size_t frame) {
  std::string name = mdl.frames[frame].poses.front().name;
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back()))) name.pop_back();
  return name;
}

TEST_F(Creatures, EveryModelThatTheGameUsesIsMade) {
  const std::regex named("\"(progs/\\w+\\.mdl)\"");
  for (const fs::path& path : list_quakec_files()) {
    const std::string text = read_text(path);
    for (std::sregex_iterator it(text.begin(), text.end(), named), end; it != end; ++it)
      EXPECT_TRUE(mdls().contains((*it)[1])) << (*it)[1] << " in " << path.filename();
  }
}

TEST_F(Creatures, SequencesAreWholeAnimations) {
  for (const Played& creature : played()) {
    ASSERT_TRUE(mdls().contains(creature.model)) << creature.model;
    const Mdl& mdl = mdls().at(creature.model);
    EXPECT_FALSE(creature.sequences.empty()) << creature.model;
    for (const Sequence& sequence : creature.sequences) {
      SCOPED_TRACE(
          fmt::format("{} {} {} to {}", creature.model, sequence.name, sequence.first, sequence.last));
      ASSERT_LT(sequence.last, mdl.frames.size());
      const std::string name = find_animation_name(mdl, sequence.first);
      EXPECT_EQ(find_animation_name(mdl, sequence.last), name);
      if (sequence.first > 0) {
        EXPECT_NE(find_animation_name(mdl, sequence.first - 1), name);
      }
      if (sequence.last + 1 < mdl.frames.size()) {
        EXPECT_NE(find_animation_name(mdl, sequence.last + 1), name);
      }
    }
  }
  // Four kinds of swings of six frames.
  EXPECT_EQ(mdls().at("progs/player.mdl").frames.size(), 119u + 4 * 6);
}

TEST_F(Creatures, MeshesAreClosedAndWithoutFlatTriangles) {
  for (const auto& [path, model] : models()) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    std::size_t flat = 0, open = 0;
    for (const MeshTriangle& triangle : model.mesh.triangles) {
      std::array<Vec3d, 3> at;
      for (std::size_t i = 0; i < 3; ++i) {
        at[i] = model.mesh.points[triangle.corners[i].point].rest;
        ++sides[{triangle.corners[i].point, triangle.corners[(i + 1) % 3].point}];
      }
      flat += glm::length(glm::cross(at[1] - at[0], at[2] - at[0])) < 1e-4 ? 1 : 0;
    }
    for (const auto& [side, count] : sides)
      open += count != 1 || !sides.contains({side.second, side.first}) ? 1 : 0;
    EXPECT_EQ(open, 0u) << path;
    EXPECT_EQ(flat, 0u) << path;
  }
}

TEST_F(Creatures, SizesFitTheOriginalEngine) {
  for (const auto& [path, mdl] : mdls()) {
    EXPECT_LE(mdl.texels.size(), 2000u) << path;
    EXPECT_LE(mdl.frames.size(), 256u) << path;
  }
  for (const Played& creature : played()) {
    const std::size_t triangles = mdls().at(creature.model).triangles.size();
    EXPECT_GE(triangles, 250u) << creature.model;
    EXPECT_LE(triangles, 1300u) << creature.model;
  }
}

// Creatures on legs; their hulls reach down to -24.
bool has_legs(const Played& creature) {
  static const std::set<std::string> kOthers = {"progs/wizard.mdl", "progs/fish.mdl", "progs/oldone.mdl"};
  return !kOthers.contains(creature.model);
}

TEST_F(Creatures, StandOnTheFloorAndFitTheirHulls) {
  for (const Played& creature : played()) {
    if (!has_legs(creature)) continue;
    SCOPED_TRACE(creature.model);
    const Mdl& mdl = mdls().at(creature.model);
    const auto stand = std::find_if(creature.sequences.begin(), creature.sequences.end(),
                                    [](const Sequence& s) { return s.name == "STAND" || s.name == "WALK"; });
    ASSERT_NE(stand, creature.sequences.end());
    for (std::size_t frame = stand->first; frame <= stand->last; ++frame)
      EXPECT_NEAR(frame_extent(mdl, frame).low.z, -24, 1) << frame;
    const Extent extent = frame_extent(mdl, stand->first);
    const double height = extent.high.z + 24, hull_height = creature.large ? 88 : 64;
    EXPECT_GT(height, 0.4 * hull_height);
    EXPECT_LT(height, 1.15 * hull_height);
    EXPECT_LT(extent.high.y - extent.low.y, creature.large ? 96 : 48);
  }
}

TEST_F(Creatures, TheDeadLieOnTheFloor) {
  int deaths = 0;
  for (const Played& creature : played()) {
    if (!has_legs(creature) && creature.model != "progs/wizard.mdl") continue;
    const Mdl& mdl = mdls().at(creature.model);
    const Extent alive = frame_extent(mdl, creature.sequences.front().first);
    for (const Sequence& sequence : creature.sequences) {
      if (sequence.name.find("DEATH") == std::string::npos) continue;
      const Extent dead = frame_extent(mdl, sequence.last);
      EXPECT_NEAR(dead.low.z, -24, 0.7) << creature.model << sequence.name;
      EXPECT_LT(dead.high.z - dead.low.z, 0.72 * (alive.high.z - alive.low.z))
          << creature.model << sequence.name;
      ++deaths;
    }
  }
  EXPECT_GE(deaths, 20);
}

// The median distance along x that vertices on the floor move from one frame to the next.
std::optional<double> measure_floor_speed(const Mdl& mdl, std::size_t first, std::size_t last) {
  std::vector<double> moves;
  for (std::size_t frame = first; frame < last; ++frame) {
    for (std::size_t i = 0; i < mdl.texels.size(); ++i) {
      const Vec3d now = vertex_position(mdl, frame, i), then = vertex_position(mdl, frame + 1, i);
      if (std::max(now.z, then.z) < -23.3) moves.push_back(then.x - now.x);
    }
  }
  if (moves.size() < 8) return {};
  std::nth_element(moves.begin(), moves.begin() + static_cast<std::ptrdiff_t>(moves.size() / 2), moves.end());
  return moves[moves.size() / 2];
}

TEST_F(Creatures, FeetDoNotSlide) {
  int measured = 0;
  for (const Played& creature : monsters()) {
    // The spawn has no feet.
    if (!has_legs(creature) || creature.model == "progs/tarbaby.mdl") continue;
    for (const Sequence& sequence : creature.sequences) {
      const bool walks = sequence.name == "WALK" || sequence.name == "PROWL";
      const auto speed = walks                    ? creature.walk_speed
                         : sequence.name == "RUN" ? creature.run_speed
                                                  : std::nullopt;
      if (!speed) continue;
      const auto moved = measure_floor_speed(mdls().at(creature.model), sequence.first, sequence.last);
      if (!moved) continue;
      EXPECT_NEAR(*moved, -*speed, std::max(0.7, 0.15 * *speed)) << creature.model << " " << sequence.name;
      ++measured;
    }
  }
  EXPECT_GE(measured, 16);
}

// 64 x 64 bits of a creature's shape, 64 bits high, seen along an axis.
using Mask = std::bitset<64 * 64>;

// 64 x 64 bits that show the creature's shape along an axis, scaled to a height of 64 bits.
Mask draw_silhouette(const Mdl& mdl, std::size_t frame, int across) {
  const Extent extent = frame_extent(mdl, frame);
  const double pixel = (extent.high.z - extent.low.z) / 64;
  const double middle = 0.5 * (extent.low[across] + extent.high[across]);
  Mask mask;
  for (const formats::MdlTriangle& triangle : mdl.triangles) {
    std::array<math::Vec2d, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d place = vertex_position(mdl, frame, triangle.vertices[i]);
      at[i] = {(place[across] - middle) / pixel + 32, (place.z - extent.low.z) / pixel};
    }
    const auto area = [](const math::Vec2d& a, const math::Vec2d& b, const math::Vec2d& c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double whole = area(at[0], at[1], at[2]);
    if (whole == 0) continue;
    const double turn = whole < 0 ? -1 : 1;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const math::Vec2d p(x + 0.5, y + 0.5);
        if (turn * area(at[0], at[1], p) >= 0 && turn * area(at[1], at[2], p) >= 0 &&
            turn * area(at[2], at[0], p) >= 0)
          mask.set(static_cast<std::size_t>(y * 64 + x));
      }
    }
  }
  return mask;
}

double overlap(const Mask& a, const Mask& b) {
  return static_cast<double>((a & b).count()) / static_cast<double>((a | b).count());
}

TEST_F(Creatures, SilhouettesAreDistinguishable) {
  std::map<std::string, std::array<Mask, 2>> masks;
  for (const Played& creature : played()) {
    const Mdl& mdl = mdls().at(creature.model);
    std::size_t frame = creature.sequences.front().first;
    for (const Sequence& sequence : creature.sequences)
      if (sequence.name == "STAND") frame = sequence.first;
    masks[creature.model] = {draw_silhouette(mdl, frame, 1), draw_silhouette(mdl, frame, 0)};
    EXPECT_GT(masks[creature.model][0].count(), 300u) << creature.model;
  }
  // One creature in two poses overlaps by about 0.9.
  for (auto a = masks.begin(); a != masks.end(); ++a)
    for (auto b = std::next(a); b != masks.end(); ++b) {
      const double both = 0.5 * (overlap(a->second[0], b->second[0]) + overlap(a->second[1], b->second[1]));
      EXPECT_LT(both, 0.78) << a->first << " and " << b->first;
    }
}

TEST_F(Creatures, AreTheSameBytesEveryTime) {
  const std::vector<ScriptFile> scripts = shipped_scripts();
  std::vector<ScriptFile> some;
  for (const ScriptFile& script : scripts)
    for (const ScriptLine& line : script.assets)
      if (line.keyword == "part" || line.values[0] == "progs/gib3.mdl" ||
          line.values[0] == "progs/h_knight.mdl")
        some.push_back({script.name, {line}});
  base::Jobs one(1), four(4);
  const auto first = make_art(some, one), second = make_art(some, four);
  ASSERT_TRUE(first.ok() && second.ok());
  ASSERT_EQ(first->size(), 4u);  // with the palette and the colormap
  for (std::size_t i = 0; i < first->size(); ++i)
    EXPECT_EQ((*first)[i].bytes, (*second)[i].bytes) << (*first)[i].path;
}

TEST_F(Creatures, PlayersClothesUseTheRecoloredRamps) {
  const std::vector<ScriptFile> scripts = shipped_scripts();
  std::vector<ScriptFile> some;
  for (const ScriptFile& script : scripts)
    for (const ScriptLine& line : script.assets)
      if (line.keyword == "part" || line.values[0] == "progs/player.mdl")
        some.push_back({script.name, {line}});
  base::Jobs jobs(1);
  const auto art = make_art(some, jobs);
  ASSERT_TRUE(art.ok());
  const auto file =
      std::find_if(art->begin(), art->end(), [](const ArtFile& f) { return f.path == "progs/player.mdl"; });
  ASSERT_NE(file, art->end());
  const auto mdl = formats::read_mdl(file->bytes);
  ASSERT_TRUE(mdl.ok());
  const std::vector<std::uint8_t>& skin = mdl->skins[0].pictures[0];
  const auto in_row = [&](int row) {
    return static_cast<double>(std::count_if(skin.begin(), skin.end(),
                                             [&](std::uint8_t texel) { return texel / 16 == row; })) /
           static_cast<double>(skin.size());
  };
  EXPECT_GT(in_row(1), 0.1);
  EXPECT_GT(in_row(6), 0.05);
}

}  // namespace
}  // namespace temblor::artgen
