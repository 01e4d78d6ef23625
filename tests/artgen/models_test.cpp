// Models from scripts: closed surfaces, movements and skins, against what the scripts' words say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "artgen/art.h"
#include "artgen/models/model.h"
#include "artgen/scripts/parts.h"
#include "base/parallel_for.h"
#include "formats/models/mdl.h"
#include "support/models/mdl_places.h"

namespace temblor::artgen {
namespace {

using formats::Mdl;
using math::Vec3d;
using test::Extent;
using test::extent_of;
using test::place_of;

ScriptLine thing_of(const std::string& text) {
  const auto script = read_script(text);
  EXPECT_TRUE(script.ok()) << (script.ok() ? "" : script.error().message());
  return script.ok() && !script->empty() ? script->front() : ScriptLine{};
}

Model model_of(const std::string& lines) {
  auto model = read_model(thing_of("model progs/test.mdl\n" + lines));
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().message());
  return model.ok() ? std::move(model).value() : Model{};
}

std::string error_of(const std::string& lines) {
  const auto model = read_model(thing_of("model progs/test.mdl\n" + lines));
  return model.ok() ? "" : model.error().message();
}

Mdl mdl_of(const std::string& lines) {
  return make_mdl(model_of(lines));
}

constexpr const char* kPaintAndBone = "  paint plain gray\n  bone a 0,0,0\n";

// Every side of a triangle is another one's, the other way round; what is inside has a volume.
void expect_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  double volume = 0;
  for (const MeshTriangle& triangle : mesh.triangles) {
    std::array<Vec3d, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = mesh.points[triangle.corners[i].point].rest;
      ++sides[{triangle.corners[i].point, triangle.corners[(i + 1) % 3].point}];
    }
    volume += glm::dot(at[0], glm::cross(at[1], at[2])) / 6;
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.contains({side.second, side.first}));
  }
  EXPECT_GT(volume, 0);
}

TEST(ModelShapes, AreClosedAndFaceOutwards) {
  for (const std::string shape :
       {"tube a 0,0,0:2 0,0,9:3x1", "tube a 0,0,9:2 0,0,0:3",
        "tube a 0,0,0:2 9,0,0:1 12,0,3:0 sides=4 edges=hard", "tube a 0,0,0:2 0,9,0:1 ends=flat",
        "tube a 0,0,0:2 0,0,0:4 0,0,5:4 ends=flat edges=rings", "ball a 1,2,3 2,3,4",
        "ball a 0,0,0 2,3,4 rows=7 sides=5 edges=hard turn=30,20,10", "box a 0,0,0 2,4,6",
        "box a 1,1,1 4,4,4 bevel=0.5 taper=0.5,0.7 turn=10,20,30",
        "plate a 0,0,0 4,0,0 4,0,4 2,0,1 0,0,4 thick=1", "plate a 0,0,4 2,0,1 4,0,4 4,0,0 0,0,0",
        "spike a 0,0,0 5,0,5", "spike a 0,0,0 0,9,0 bend=0,0,2", "crystal a 0,0,0 0,0,9"}) {
    SCOPED_TRACE(shape);
    expect_closed(model_of(kPaintAndBone + fmt::format("  {}\n", shape)).mesh);
  }
}

TEST(ModelShapes, AStarMakesAMirrorImage) {
  const Model model = model_of("  paint plain gray\n  bone arm_* 1,5,2\n  box arm_* 0,1,0 2,2,2\n");
  expect_closed(model.mesh);
  const std::size_t half = model.mesh.points.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const Vec3d left = model.mesh.points[i].rest, right = model.mesh.points[i + half].rest;
    EXPECT_GT(left.y, 0);
    EXPECT_EQ(right, Vec3d(left.x, -left.y, left.z));
  }
}

TEST(ModelShapes, SizesAreThoseOfTheRecipe) {
  const Mdl mdl = mdl_of("  paint plain gray\n  bone a 0,0,10\n  bone b 0,0,5 on=a\n  box b 1,0,0 2,4,6\n");
  const Extent extent = extent_of(mdl, 0);
  EXPECT_NEAR(glm::distance(extent.low, Vec3d(0, -2, 12)), 0, 0.05);
  EXPECT_NEAR(glm::distance(extent.high, Vec3d(2, 2, 18)), 0, 0.05);
}

TEST(ModelShapes, CrispEdgesHaveANormalForEachSideAndSmoothOnesShare) {
  EXPECT_EQ(mdl_of(std::string(kPaintAndBone) + "  box a 0,0,0 4,4,4\n").texels.size(), 24u);
  // Five rings of eight, the seam twice, and the poles once a side.
  EXPECT_EQ(mdl_of(std::string(kPaintAndBone) + "  ball a 0,0,0 4,4,4 sides=8 rows=4\n").texels.size(),
            3u * 9 + 2 * 8);
}

TEST(ModelShapes, PointsBetweenTwoBonesGoHalfWay) {
  const Mdl mdl = mdl_of(
      "  paint plain gray\n  bone a 0,0,0\n  bone b 0,0,10 on=a\n"
      "  tube a 0,0,0:1 a+b@0,0,0:1 b@0,0,10:1 sides=4 ends=flat\n"
      "  animation move 2\n    key 0 b.at=0,0,0\n    key 1 b.at=0,0,8\n");
  std::map<long, long> heights;
  for (std::size_t i = 0; i < mdl.texels.size(); ++i)
    heights[std::lround(place_of(mdl, 0, i).z)] = std::lround(place_of(mdl, 1, i).z);
  EXPECT_EQ(heights, (std::map<long, long>{{0, 0}, {10, 14}, {20, 28}}));
}

TEST(ModelMotion, TurnsGoTheWaysThatTheyAreSaidTo) {
  const auto tip_after = [](const std::string& turn) {
    const Mdl mdl = mdl_of(
        "  paint plain gray\n  bone a 0,0,0\n  box a 0,0,10 0.1,0.1,0.1\n  animation one 1\n    key 0 a=" +
        turn + "\n");
    const Extent extent = extent_of(mdl, 0);
    return 0.5 * (extent.low + extent.high);
  };
  EXPECT_NEAR(glm::distance(tip_after("90"), Vec3d(10, 0, 0)), 0, 0.1);       // leans ahead
  EXPECT_NEAR(glm::distance(tip_after("0,0,90"), Vec3d(0, -10, 0)), 0, 0.1);  // leans right
  EXPECT_NEAR(glm::distance(tip_after("90,90"), Vec3d(0, 10, 0)), 0, 0.1);    // then turns left
}

TEST(ModelMotion, KeysAreMetAndValuesBetweenNeverOvershoot) {
  const Mdl mdl = mdl_of(std::string(kPaintAndBone) +
                         "  box a 0,0,0 0.2,0.2,0.2\n  animation move 11\n    key 0 a.at=0,0,0\n"
                         "    key 3 a.at=10,0,0\n    key 6 a.at=10,0,0\n    key 10 a.at=-10,0,0\n");
  const auto x = [&](std::size_t frame) { return place_of(mdl, frame, 0).x - place_of(mdl, 0, 0).x; };
  EXPECT_NEAR(x(3), 10, 0.1);
  EXPECT_NEAR(x(5), 10, 0.1);
  EXPECT_NEAR(x(10), -10, 0.1);
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_GE(x(i), x(i - 1) - 0.1);
  for (std::size_t i = 7; i <= 10; ++i) EXPECT_LE(x(i), x(i - 1) + 0.1);
}

TEST(ModelMotion, CyclesCloseAndAlternatesAreMirrored) {
  const std::string lines =
      "  paint plain gray\n  bone arm_* 0,5,0\n  box arm_* 0,0,-10 0.2,0.2,0.2\n"
      "  cycle walk 8 alternate=yes\n    key 0 arm_l=30 arm_r=-30\n";
  const Mdl mdl = mdl_of(lines);
  ASSERT_EQ(mdl.frames.size(), 8u);
  EXPECT_EQ(mdl.frames[2].poses[0].name, "walk3");
  const std::size_t half = mdl.texels.size() / 2;
  for (std::size_t frame = 0; frame < 4; ++frame)
    EXPECT_NEAR(place_of(mdl, frame, 0).x, place_of(mdl, frame + 4, half).x, 0.1);
  EXPECT_NEAR(place_of(mdl, 1, 0).x, place_of(mdl, 7, 0).x, 0.1);
  EXPECT_GT(std::abs(place_of(mdl, 0, 0).x - place_of(mdl, 4, 0).x), 9.0);
}

constexpr const char* kLegs =
    "  paint plain gray\n  bone hips 0,0,0\n  bone leg_* 0,4,0 on=hips\n  bone shin_* 0,0,-12 on=leg_*\n"
    "  bone foot_* 0,0,-12 on=shin_*\n  foot foot_*\n  box foot_* 0,0,0 0.2,0.2,0.2\n";

TEST(ModelMotion, FeetStayWhereTheyStandWhileHipsMove) {
  const Mdl mdl =
      mdl_of(std::string(kLegs) +
             "  animation bow 5\n    key 0 hips.at=0,0,-2 hips=0\n    key 4 hips.at=2,1,-6 hips=20,10,5\n");
  for (std::size_t frame = 1; frame < 5; ++frame)
    for (std::size_t i = 0; i < mdl.texels.size(); ++i)
      EXPECT_NEAR(glm::distance(place_of(mdl, frame, i), place_of(mdl, 0, i)), 0, 0.1);
}

TEST(ModelMotion, AGaitsFeetGoWithTheFloor) {
  const Mdl mdl = mdl_of(std::string(kLegs) +
                         "  cycle walk 10\n    gait speed=2 duty=0.6 lift=4\n    key 0 hips.at=0,0,-4\n");
  std::array<int, 2> down{};
  for (std::size_t frame = 0; frame < 10; ++frame) {
    for (const std::size_t foot : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t vertex = foot * mdl.texels.size() / 2, next = (frame + 1) % 10;
      const Vec3d now = place_of(mdl, frame, vertex), then = place_of(mdl, next, vertex);
      if (std::max(now.z, then.z) > -24.0) continue;
      EXPECT_NEAR(then.x - now.x, -2, 0.25) << frame;
      ++down[foot];
    }
  }
  EXPECT_EQ(down, (std::array{6, 6}));
}

TEST(ModelMotion, AGripHoldsOnToItsBone) {
  const Mdl mdl = mdl_of(
      "  paint plain gray\n  bone chest 0,0,0\n  bone arm_l 0,4,8 on=chest\n  bone fore_l 0,0,-8 on=arm_l\n"
      "  bone hand_l 0,0,-8 on=fore_l\n  bone gun 6,0,2 on=chest\n  grip hand_l gun 2,0,0\n  box hand_l "
      "0,0,0 0.2,0.2,0.2\n"
      "  animation aim 3\n    key 0 gun=0\n    key 2 gun=0,40,0 gun.at=1,0,1\n");
  const double angle = 40 * 3.14159265 / 180;
  const Vec3d goal(7 + 2 * std::cos(angle), 2 * std::sin(angle), 3);
  const Extent extent = extent_of(mdl, 2);
  EXPECT_NEAR(glm::distance(0.5 * (extent.low + extent.high), goal), 0, 0.1);
}

TEST(ModelMotion, WhatSettlesTouchesTheFloor) {
  const Mdl mdl =
      mdl_of(std::string(kPaintAndBone) +
             "  box a 0,0,0 4,8,20\n  animation fall 4 settle=yes\n    key 0 a=0\n    key 3 a=90\n");
  for (std::size_t frame = 0; frame < 4; ++frame) EXPECT_NEAR(extent_of(mdl, frame).low.z, -24, 0.1);
}

TEST(ModelMotion, AKeyWithAPoseSaysEverything) {
  const std::string lines = std::string(kPaintAndBone) +
                            "  bone b 0,0,5 on=a\n  box b 0,0,0 0.2,0.2,0.2\n  pose stance b.at=3,0,0\n"
                            "  pose other a.at=0,2,0\n";
  const auto middle = [&](const std::string& key) {
    const Extent extent = extent_of(mdl_of(lines + "  animation one 1\n    key 0 " + key + "\n"), 0);
    return 0.5 * (extent.low + extent.high);
  };
  EXPECT_NEAR(glm::distance(middle("a.at=0,2,0"), Vec3d(3, 2, 5)), 0, 0.05);  // the stance below
  EXPECT_NEAR(glm::distance(middle("other"), Vec3d(0, 2, 5)), 0, 0.05);
  EXPECT_NEAR(glm::distance(middle("stance a.at=0,2,0"), Vec3d(3, 2, 5)), 0, 0.05);
}

TEST(ModelMotion, GroupsAreOneFrame) {
  const Mdl mdl =
      mdl_of(std::string(kPaintAndBone) +
             "  box a 0,0,0 4,4,4\n  cycle burn 3 group=0.1\n    key 0 a.scale=1\n    key 1.5 a.scale=1.5\n");
  ASSERT_EQ(mdl.frames.size(), 1u);
  EXPECT_EQ(mdl.frames[0].poses.size(), 3u);
  ASSERT_EQ(mdl.frames[0].end_times_s.size(), 3u);
  EXPECT_NEAR(mdl.frames[0].end_times_s[2], 0.3, 1e-6);
}

// Palette indices of what is painted, by ramp.
std::map<int, int> ramps_of(const Mdl& mdl, std::size_t skin) {
  std::map<int, int> ramps;
  for (const std::uint8_t texel : mdl.skins[skin].pictures.front()) ++ramps[texel / 16];
  return ramps;
}

TEST(ModelSkins, PaintsPatchesAndSkinsAreWhatTheRecipeSays) {
  const Mdl mdl = mdl_of(
      "  paint steel slate bright=0.2..0.9\n  paint eyes fire\n  bone a 0,0,0\n"
      "  ball a 0,0,0 8,8,8 paint=steel\n    patch eyes along=0.4..0.6 around=-30..30\n"
      "  skin\n    paint steel gold bright=0.2..0.9\n");
  ASSERT_EQ(mdl.skins.size(), 2u);
  const auto first = ramps_of(mdl, 0), second = ramps_of(mdl, 1);
  EXPECT_GT(first.at(10), 500);
  EXPECT_EQ(first.count(6), 0u);
  EXPECT_GT(second.at(6), 500);
  EXPECT_EQ(second.count(10), 0u);
  // About a twelfth of the way round and a fifth of the way up.
  const double share = static_cast<double>(first.at(14)) / (first.at(14) + first.at(10));
  EXPECT_GT(share, 0.01);
  EXPECT_LT(share, 0.05);
  EXPECT_EQ(first.at(14), second.at(14));
}

TEST(ModelSkins, CreasesAreHiddenAndOpenSidesAreNot) {
  // A wall on a floor: dark where they meet.
  const Model model =
      model_of(std::string(kPaintAndBone) + "  box a 0,0,-1 40,40,2\n  box a 0,0,10 2,40,20\n");
  const Atlas atlas = lay_out_charts(model.mesh, 1);
  double crease = 0, open = 0;
  int creases = 0, opens = 0;
  for (const SkinTexel& texel : find_skin_texels(model.mesh, atlas)) {
    if (!texel.used || texel.normal.z < 0.9 || texel.place.z > 1) continue;
    const double away = std::abs(texel.place.x);
    if (away > 1.2 && away < 2.5) crease += texel.hidden, ++creases;
    if (away > 16 && away < 19) open += texel.hidden, ++opens;
  }
  ASSERT_GT(creases, 10);
  ASSERT_GT(opens, 10);
  EXPECT_GT(crease / creases, 0.1);
  EXPECT_LT(open / opens, 0.02);
}

TEST(ModelSkins, TexelsAreEvenlyDense) {
  const Model model = model_of(std::string(kPaintAndBone) + "  box a 0,0,0 30,10,4\n  ball a 0,0,20 6,6,6\n");
  const Atlas atlas = lay_out_charts(model.mesh, 2);
  for (const MeshTriangle& triangle : model.mesh.triangles) {
    const auto& corners = triangle.corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshCorner &a = corners[i], &b = corners[(i + 1) % 3];
      const double units = glm::distance(model.mesh.points[a.point].rest, model.mesh.points[b.point].rest);
      const double texels =
          glm::distance(atlas.texel(triangle.chart, a.place), atlas.texel(triangle.chart, b.place));
      EXPECT_LT(texels, 2 * units * 1.6 + 2);
    }
  }
}

TEST(ModelScripts, WrongLinesAreToldWithWhatIsAllowed) {
  const std::string body = std::string(kPaintAndBone) + "  box a 0,0,0 1,1,1\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "line 1: model: it has no shape"},
      {"  blob a\n", "line 2: blob: models have flags, bone"},
      {"  bone a 0,0,0 on=b\n", "line 2: bone: there is no bone 'b'"},
      {body + "  foot a\n", "line 5: foot: a limb's last bone is on one that is on another"},
      {"  paint p mauve\n", "line 2: paint: 'mauve' is none of the palette's ramps: gray, brown"},
      {body + "  tube a 0,0,0\n", "line 5: tube: '0,0,0' is not X,Y,Z:RADIUS"},
      {body + "  tube a 0,0,0:1\n", "line 5: tube: a tube has at least two places"},
      {body + "  tube a 0,0,0:1 0,0,1:0 0,0,2:1\n", "line 5: tube: a tube has radii above 0, but for points"},
      {body + "  box a 0,0,0 1,1,1 paint=gold\n", "line 5: box: there is no paint 'gold'"},
      {body + "  box a 0,0,0 1,1,0\n", "line 5: box: a box has sides above 0"},
      {body + "  ball a 0,0 1,1,1\n", "line 5: ball: '0,0' is not X,Y,Z"},
      {body + "  animation walk 4\n    key 5 a=1\n", "line 6: key: its first value is a frame from 0 to 4"},
      {body + "  animation walk 4\n    key 0 b=1\n", "line 6: key: there is no bone 'b'"},
      {body + "  animation walk 4\n    key 0 a=1,2,3,4\n", "line 6: key: a=1,2,3,4 is not PITCH"},
      {body + "  animation walk 4\n    key 0 a.scale=0\n", "line 6: key: a.scale=0 is not above 0"},
      {body + "  scale a by=1,0,1\n", "line 5: scale: by=1,0,1 is neither a number nor X,Y,Z, above 0"},
      {body + "  animation a 1000\n  like b a 1000\n  like c a 1000\n  like d a 1000\n  like e a 1000\n",
       "line 1: model: 5000 frames; a model has at most 4096"},
      {body + "  animation walk 4\n    key 0 hop\n", "line 6: key: there is no pose 'hop'"},
      {body + "  animation walk 4\n    gait speed=2\n", "line 6: gait: the model has no 'foot'"},
      {body + "  like run walk 4\n", "line 5: like: there is no animation 'walk' before it"},
      {body + "  flags glow\n", "line 5: flags: 'glow' is none of rocket_trail"},
  };
  for (const auto& [lines, message] : cases)
    EXPECT_TRUE(error_of(lines).starts_with(message)) << error_of(lines);
  EXPECT_TRUE(error_of("  ball q 0,0,0 1,1,1\n").find("the model has no paint") != std::string::npos);
}

TEST(ModelScripts, WhatIsTooLargeIsTold) {
  const std::string far =
      std::string("model x.mdl\n") + kPaintAndBone + "  box a 0,0,0 1,1,1\n  box a 0,90000,0 2,2,2\n";
  const auto art = make_model_art(thing_of(far));
  ASSERT_FALSE(art.ok());
  EXPECT_EQ(art.error().message(),
            "line 1: model: it reaches 90001 units from its origin, the farthest is 65536");
  std::string many = kPaintAndBone;
  for (int i = 0; i < 20; ++i) many += "  ball a 0,0,0 1,1,1 sides=40 rows=20\n";
  EXPECT_EQ(error_of(many), "line 1: model: 30400 triangles; a model has at most 8192");
}

base::Result<std::vector<ArtFile>> art_of(const std::string& text) {
  const auto script = read_script(text);
  EXPECT_TRUE(script.ok());
  base::Jobs jobs(1);
  const ScriptFile file{"test.script", *script};
  return make_art({&file, 1}, jobs);
}

TEST(ScriptParts, StandWhereTheyAreUsed) {
  const std::string used =
      "part body\n  paint p gray\n  bone a 0,0,0\nmodel x.mdl\n  use body\n  box a 0,0,0 4,4,4\n";
  const std::string plain = "model x.mdl\n  paint p gray\n  bone a 0,0,0\n  box a 0,0,0 4,4,4\n";
  const auto with_part = art_of(used), without = art_of(plain);
  ASSERT_TRUE(with_part.ok() && without.ok());
  ASSERT_EQ(with_part->size(), without->size());
  for (std::size_t i = 0; i < with_part->size(); ++i) EXPECT_EQ((*with_part)[i].bytes, (*without)[i].bytes);
}

TEST(ScriptParts, WrongOnesAreTold) {
  EXPECT_EQ(art_of("model x.mdl\n  use body\n").error().message(),
            "test.script: line 2: use: there is no part 'body'");
  EXPECT_EQ(art_of("part a\n  use a\nmodel x.mdl\n  use a\n").error().message(),
            "test.script: part a, line 2: use: parts use one another in a circle");
  EXPECT_EQ(art_of("part a\n  bone b\npart a\n  bone c\n").error().message(),
            "test.script: line 3: part: there is another of this name");
  EXPECT_EQ(art_of("part a\n  bone b\nmodel x.mdl\n  use a\n").error().message(),
            "test.script: part a, line 2: bone: X,Y,Z is missing");
}

// The script in docs/art.md, as a reader copies it.
TEST(ModelScripts, TheDocumentsExampleIsAModel) {
  std::ifstream file(TEMBLOR_SOURCE_DIR "/docs/art.md");
  std::ostringstream all;
  all << file.rdbuf();
  const std::string text = all.str();
  const std::size_t first = text.find("# A mine lamp");
  ASSERT_NE(first, std::string::npos);
  const auto art = art_of(text.substr(first, text.find("```", first) - first));
  ASSERT_TRUE(art.ok()) << art.error().message();
  const auto lamp =
      std::find_if(art->begin(), art->end(), [](const ArtFile& f) { return f.path == "progs/lamp.mdl"; });
  ASSERT_NE(lamp, art->end());
  const auto mdl = formats::read_mdl(lamp->bytes);
  ASSERT_TRUE(mdl.ok());
  EXPECT_EQ(mdl->frames.size(), 10u);
}

}  // namespace
}  // namespace temblor::artgen
