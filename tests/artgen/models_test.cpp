// Compares models with the meaning of their scripts: closed surfaces, animations, skins, and errors.
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
using test::frame_extent;
using test::vertex_position;

ScriptLine parse_asset(const std::string& text) {
  const auto script = read_script(text);
  EXPECT_TRUE(script.ok()) << (script.ok() ? "" : script.error().message());
  return script.ok() && !script->empty() ? script->front() : ScriptLine{};
}

Model parse_model(const std::string& lines) {
  auto model = read_model(parse_asset("model progs/test.mdl\n" + lines));
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().message());
  return model.ok() ? std::move(model).value() : Model{};
}

std::string model_error(const std::string& lines) {
  const auto model = read_model(parse_asset("model progs/test.mdl\n" + lines));
  return model.ok() ? "" : model.error().message();
}

Mdl build_mdl(const std::string& lines) {
  return make_mdl(parse_model(lines));
}

constexpr const char* kPaintAndBone = "  paint plain gray\n  bone a 0,0,0\n";

// Every side of a triangle belongs to one other triangle in the opposite direction, and the enclosed volume
// is positive.
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

TEST(ModelShapes, AreClosedAndFaceOutward) {
  for (const std::string shape :
       {"tube a 0,0,0:2 0,0,9:3x1", "tube a 0,0,9:2 0,0,0:3",
        "tube a 0,0,0:2 9,0,0:1 12,0,3:0 sides=4 edges=hard", "tube a 0,0,0:2 0,9,0:1 ends=flat",
        "tube a 0,0,0:2 0,0,0:4 0,0,5:4 ends=flat edges=rings", "ball a 1,2,3 2,3,4",
        "ball a 0,0,0 2,3,4 rows=7 sides=5 edges=hard turn=30,20,10", "box a 0,0,0 2,4,6",
        "box a 1,1,1 4,4,4 bevel=0.5 taper=0.5,0.7 turn=10,20,30",
        "plate a 0,0,0 4,0,0 4,0,4 2,0,1 0,0,4 thick=1", "plate a 0,0,4 2,0,1 4,0,4 4,0,0 0,0,0",
        "spike a 0,0,0 5,0,5", "spike a 0,0,0 0,9,0 bend=0,0,2", "crystal a 0,0,0 0,0,9"}) {
    SCOPED_TRACE(shape);
    expect_closed(parse_model(kPaintAndBone + fmt::format("  {}\n", shape)).mesh);
  }
}

TEST(ModelShapes, AStarMakesAMirrorImage) {
  const Model model = parse_model("  paint plain gray\n  bone arm_* 1,5,2\n  box arm_* 0,1,0 2,2,2\n");
  expect_closed(model.mesh);
  const std::size_t half = model.mesh.points.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const Vec3d left = model.mesh.points[i].rest, right = model.mesh.points[i + half].rest;
    EXPECT_GT(left.y, 0);
    EXPECT_EQ(right, Vec3d(left.x, -left.y, left.z));
  }
}

TEST(ModelShapes, SizesMatchTheScript) {
  const Mdl mdl =
      build_mdl("  paint plain gray\n  bone a 0,0,10\n  bone b 0,0,5 on=a\n  box b 1,0,0 2,4,6\n");
  const Extent extent = frame_extent(mdl, 0);
  EXPECT_NEAR(glm::distance(extent.low, Vec3d(0, -2, 12)), 0, 0.05);
  EXPECT_NEAR(glm::distance(extent.high, Vec3d(2, 2, 18)), 0, 0.05);
}

TEST(ModelShapes, HardEdgesSplitNormalsAndSmoothOnesShareThem) {
  EXPECT_EQ(build_mdl(std::string(kPaintAndBone) + "  box a 0,0,0 4,4,4\n").texels.size(), 24u);
  // Five rings of eight, the seam twice, and the poles once a side.
  EXPECT_EQ(build_mdl(std::string(kPaintAndBone) + "  ball a 0,0,0 4,4,4 sides=8 rows=4\n").texels.size(),
            3u * 9 + 2 * 8);
}

TEST(ModelShapes, PointsBetweenTwoBonesMoveHalfway) {
  const Mdl mdl = build_mdl(
      "  paint plain gray\n  bone a 0,0,0\n  bone b 0,0,10 on=a\n"
      "  tube a 0,0,0:1 a+b@0,0,0:1 b@0,0,10:1 sides=4 ends=flat\n"
      "  animation move 2\n    key 0 b.at=0,0,0\n    key 1 b.at=0,0,8\n");
  std::map<long, long> heights;
  for (std::size_t i = 0; i < mdl.texels.size(); ++i)
    heights[std::lround(vertex_position(mdl, 0, i).z)] = std::lround(vertex_position(mdl, 1, i).z);
  EXPECT_EQ(heights, (std::map<long, long>{{0, 0}, {10, 14}, {20, 28}}));
}

TEST(ModelMotion, RotationsGoInTheDocumentedDirections) {
  const auto tip_after = [](const std::string& turn) {
    const Mdl mdl = build_mdl(
        "  paint plain gray\n  bone a 0,0,0\n  box a 0,0,10 0.1,0.1,0.1\n  animation one 1\n    key 0 a=" +
        turn + "\n");
    const Extent extent = frame_extent(mdl, 0);
    return 0.5 * (extent.low + extent.high);
  };
  EXPECT_NEAR(glm::distance(tip_after("90"), Vec3d(10, 0, 0)), 0, 0.1);       // leans forward
  EXPECT_NEAR(glm::distance(tip_after("0,0,90"), Vec3d(0, -10, 0)), 0, 0.1);  // leans right
  EXPECT_NEAR(glm::distance(tip_after("90,90"), Vec3d(0, 10, 0)), 0, 0.1);    // then turns left
}

TEST(ModelMotion, CurvesMeetTheirKeysAndNeverOvershoot) {
  const Mdl mdl = build_mdl(std::string(kPaintAndBone) +
                            "  box a 0,0,0 0.2,0.2,0.2\n  animation move 11\n    key 0 a.at=0,0,0\n"
                            "    key 3 a.at=10,0,0\n    key 6 a.at=10,0,0\n    key 10 a.at=-10,0,0\n");
  const auto x = [&](std::size_t frame) {
    return vertex_position(mdl, frame, 0).x - vertex_position(mdl, 0, 0).x;
  };
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
  const Mdl mdl = build_mdl(lines);
  ASSERT_EQ(mdl.frames.size(), 8u);
  EXPECT_EQ(mdl.frames[2].poses[0].name, "walk3");
  const std::size_t half = mdl.texels.size() / 2;
  for (std::size_t frame = 0; frame < 4; ++frame)
    EXPECT_NEAR(vertex_position(mdl, frame, 0).x, vertex_position(mdl, frame + 4, half).x, 0.1);
  EXPECT_NEAR(vertex_position(mdl, 1, 0).x, vertex_position(mdl, 7, 0).x, 0.1);
  EXPECT_GT(std::abs(vertex_position(mdl, 0, 0).x - vertex_position(mdl, 4, 0).x), 9.0);
}

constexpr const char* kLegs =
    "  paint plain gray\n  bone hips 0,0,0\n  bone leg_* 0,4,0 on=hips\n  bone shin_* 0,0,-12 on=leg_*\n"
    "  bone foot_* 0,0,-12 on=shin_*\n  foot foot_*\n  box foot_* 0,0,0 0.2,0.2,0.2\n";

TEST(ModelMotion, FeetStayInPlaceWhileHipsMove) {
  const Mdl mdl = build_mdl(
      std::string(kLegs) +
      "  animation bow 5\n    key 0 hips.at=0,0,-2 hips=0\n    key 4 hips.at=2,1,-6 hips=20,10,5\n");
  for (std::size_t frame = 1; frame < 5; ++frame)
    for (std::size_t i = 0; i < mdl.texels.size(); ++i)
      EXPECT_NEAR(glm::distance(vertex_position(mdl, frame, i), vertex_position(mdl, 0, i)), 0, 0.1);
}

TEST(ModelMotion, AGaitsFeetMoveWithTheFloor) {
  const Mdl mdl = build_mdl(std::string(kLegs) +
                            "  cycle walk 10\n    gait speed=2 duty=0.6 lift=4\n    key 0 hips.at=0,0,-4\n");
  std::array<int, 2> down{};
  for (std::size_t frame = 0; frame < 10; ++frame) {
    for (const std::size_t foot : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t vertex = foot * mdl.texels.size() / 2, next = (frame + 1) % 10;
      const Vec3d now = vertex_position(mdl, frame, vertex), then = vertex_position(mdl, next, vertex);
      if (std::max(now.z, then.z) > -24.0) continue;
      EXPECT_NEAR(then.x - now.x, -2, 0.25) << frame;
      ++down[foot];
    }
  }
  EXPECT_EQ(down, (std::array{6, 6}));
}

TEST(ModelMotion, AGripHoldsOnToItsBone) {
  const Mdl mdl = build_mdl(
      "  paint plain gray\n  bone chest 0,0,0\n  bone arm_l 0,4,8 on=chest\n  bone fore_l 0,0,-8 on=arm_l\n"
      "  bone hand_l 0,0,-8 on=fore_l\n  bone gun 6,0,2 on=chest\n  grip hand_l gun 2,0,0\n  box hand_l "
      "0,0,0 0.2,0.2,0.2\n"
      "  animation aim 3\n    key 0 gun=0\n    key 2 gun=0,40,0 gun.at=1,0,1\n");
  const double angle = 40 * 3.14159265 / 180;
  const Vec3d goal(7 + 2 * std::cos(angle), 2 * std::sin(angle), 3);
  const Extent extent = frame_extent(mdl, 2);
  EXPECT_NEAR(glm::distance(0.5 * (extent.low + extent.high), goal), 0, 0.1);
}

TEST(ModelMotion, SettlingModelsTouchTheFloor) {
  const Mdl mdl =
      build_mdl(std::string(kPaintAndBone) +
                "  box a 0,0,0 4,8,20\n  animation fall 4 settle=yes\n    key 0 a=0\n    key 3 a=90\n");
  for (std::size_t frame = 0; frame < 4; ++frame) EXPECT_NEAR(frame_extent(mdl, frame).low.z, -24, 0.1);
}

TEST(ModelMotion, AKeyWithAPoseResetsOtherBones) {
  const std::string lines = std::string(kPaintAndBone) +
                            "  bone b 0,0,5 on=a\n  box b 0,0,0 0.2,0.2,0.2\n  pose stance b.at=3,0,0\n"
                            "  pose other a.at=0,2,0\n";
  const auto middle = [&](const std::string& key) {
    const Extent extent = frame_extent(build_mdl(lines + "  animation one 1\n    key 0 " + key + "\n"), 0);
    return 0.5 * (extent.low + extent.high);
  };
  EXPECT_NEAR(glm::distance(middle("a.at=0,2,0"), Vec3d(3, 2, 5)), 0, 0.05);  // keeps the stance
  EXPECT_NEAR(glm::distance(middle("other"), Vec3d(0, 2, 5)), 0, 0.05);
  EXPECT_NEAR(glm::distance(middle("stance a.at=0,2,0"), Vec3d(3, 2, 5)), 0, 0.05);
}

TEST(ModelMotion, GroupsAreOneFrame) {
  const Mdl mdl = build_mdl(
      std::string(kPaintAndBone) +
      "  box a 0,0,0 4,4,4\n  cycle burn 3 group=0.1\n    key 0 a.scale=1\n    key 1.5 a.scale=1.5\n");
  ASSERT_EQ(mdl.frames.size(), 1u);
  EXPECT_EQ(mdl.frames[0].poses.size(), 3u);
  ASSERT_EQ(mdl.frames[0].end_times_s.size(), 3u);
  EXPECT_NEAR(mdl.frames[0].end_times_s[2], 0.3, 1e-6);
}

// The number of texels of a skin by ramp.
std::map<int, int> count_ramps(const Mdl& mdl, std::size_t skin) {
  std::map<int, int> ramps;
  for (const std::uint8_t texel : mdl.skins[skin].pictures.front()) ++ramps[texel / 16];
  return ramps;
}

TEST(ModelSkins, PaintsPatchesAndSkinsMatchTheScript) {
  const Mdl mdl = build_mdl(
      "  paint steel slate bright=0.2..0.9\n  paint eyes fire\n  bone a 0,0,0\n"
      "  ball a 0,0,0 8,8,8 paint=steel\n    patch eyes along=0.4..0.6 around=-30..30\n"
      "  skin\n    paint steel gold bright=0.2..0.9\n");
  ASSERT_EQ(mdl.skins.size(), 2u);
  const auto first = count_ramps(mdl, 0), second = count_ramps(mdl, 1);
  EXPECT_GT(first.at(10), 500);
  EXPECT_EQ(first.count(6), 0u);
  EXPECT_GT(second.at(6), 500);
  EXPECT_EQ(second.count(10), 0u);
  // About a twelfth of the circumference and a fifth of the height.
  const double share = static_cast<double>(first.at(14)) / (first.at(14) + first.at(10));
  EXPECT_GT(share, 0.01);
  EXPECT_LT(share, 0.05);
  EXPECT_EQ(first.at(14), second.at(14));
}

TEST(ModelSkins, CreasesAreHiddenAndOpenSidesAreNot) {
  // A wall on a floor: dark where they meet.
  const Model model =
      parse_model(std::string(kPaintAndBone) + "  box a 0,0,-1 40,40,2\n  box a 0,0,10 2,40,20\n");
  const Atlas atlas = lay_out_charts(model.mesh, 1);
  double crease = 0, open = 0;
  int creases = 0, opens = 0;
  for (const SkinTexel& texel : find_skin_texels(model.mesh, atlas)) {
    if (!texel.used || texel.normal.z < 0.9 || texel.position.z > 1) continue;
    const double away = std::abs(texel.position.x);
    if (away > 1.2 && away < 2.5) crease += texel.hidden, ++creases;
    if (away > 16 && away < 19) open += texel.hidden, ++opens;
  }
  ASSERT_GT(creases, 10);
  ASSERT_GT(opens, 10);
  EXPECT_GT(crease / creases, 0.1);
  EXPECT_LT(open / opens, 0.02);
}

TEST(ModelSkins, TexelsHaveTheRequestedDensity) {
  const Model model =
      parse_model(std::string(kPaintAndBone) + "  box a 0,0,0 30,10,4\n  ball a 0,0,20 6,6,6\n");
  const Atlas atlas = lay_out_charts(model.mesh, 2);
  for (const MeshTriangle& triangle : model.mesh.triangles) {
    const auto& corners = triangle.corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshCorner &a = corners[i], &b = corners[(i + 1) % 3];
      const double units = glm::distance(model.mesh.points[a.point].rest, model.mesh.points[b.point].rest);
      const double texels =
          glm::distance(atlas.texel(triangle.chart, a.position), atlas.texel(triangle.chart, b.position));
      EXPECT_LT(texels, 2 * units * 1.6 + 2);
    }
  }
}

TEST(ModelScripts, ErrorsNameTheLineAndTheAllowedValues) {
  const std::string body = std::string(kPaintAndBone) + "  box a 0,0,0 1,1,1\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "line 1: model: the model has no shapes"},
      {"  blob a\n", "line 2: blob: unknown keyword; models have flags, bone"},
      {"  bone a 0,0,0 on=b\n", "line 2: bone: no bone is named 'b'"},
      {body + "  foot a\n",
       "line 5: foot: a limb needs three bones: this one, its parent and its grandparent"},
      {"  paint p mauve\n", "line 2: paint: 'mauve' is not a color ramp; expected one of gray, brown"},
      {body + "  tube a 0,0,0\n", "line 5: tube: '0,0,0' is not X,Y,Z:RADIUS"},
      {body + "  tube a 0,0,0:1\n", "line 5: tube: a tube needs at least two positions"},
      {body + "  tube a 0,0,0:1 0,0,1:0 0,0,2:1\n",
       "line 5: tube: a tube's radii must be above 0, except for points"},
      {body + "  box a 0,0,0 1,1,1 paint=gold\n", "line 5: box: no paint is named 'gold'"},
      {body + "  box a 0,0,0 1,1,0\n", "line 5: box: a box's sides must be above 0"},
      {body + "  ball a 0,0 1,1,1\n", "line 5: ball: '0,0' is not X,Y,Z"},
      {body + "  animation walk 4\n    key 5 a=1\n",
       "line 6: key: the first value must be a frame from 0 to 4"},
      {body + "  animation walk 4\n    key 0 b=1\n", "line 6: key: no bone is named 'b'"},
      {body + "  animation walk 4\n    key 0 a=1,2,3,4\n", "line 6: key: a=1,2,3,4 is not PITCH"},
      {body + "  animation walk 4\n    key 0 a.scale=0\n", "line 6: key: a.scale=0 is not above 0"},
      {body + "  scale a by=1,0,1\n", "line 5: scale: by=1,0,1 is neither a number nor X,Y,Z, above 0"},
      {body + "  animation a 1000\n  like b a 1000\n  like c a 1000\n  like d a 1000\n  like e a 1000\n",
       "line 1: model: 5000 frames; a model has at most 4096"},
      {body + "  animation walk 4\n    key 0 hop\n", "line 6: key: no pose is named 'hop'"},
      {body + "  animation walk 4\n    gait speed=2\n", "line 6: gait: the model has no 'foot'"},
      {body + "  like run walk 4\n", "line 5: like: no animation 'walk' is defined above this line"},
      {body + "  flags glow\n", "line 5: flags: 'glow' is not one of rocket_trail"},
  };
  for (const auto& [lines, message] : cases)
    EXPECT_TRUE(model_error(lines).starts_with(message)) << model_error(lines);
  EXPECT_TRUE(model_error("  ball q 0,0,0 1,1,1\n").find("the model has no paint") != std::string::npos);
}

TEST(ModelScripts, TooLargeModelsAreErrors) {
  const std::string far =
      std::string("model x.mdl\n") + kPaintAndBone + "  box a 0,0,0 1,1,1\n  box a 0,90000,0 2,2,2\n";
  const auto art = make_model_art(parse_asset(far));
  ASSERT_FALSE(art.ok());
  EXPECT_EQ(art.error().message(),
            "line 1: model: it reaches 90001 units from its origin; the limit is 65536");
  std::string many = kPaintAndBone;
  for (int i = 0; i < 20; ++i) many += "  ball a 0,0,0 1,1,1 sides=40 rows=20\n";
  EXPECT_EQ(model_error(many), "line 1: model: 30400 triangles; a model has at most 8192");
}

base::Result<std::vector<ArtFile>> build_art(const std::string& text) {
  const auto script = read_script(text);
  EXPECT_TRUE(script.ok());
  base::Jobs jobs(1);
  const ScriptFile file{"test.script", *script};
  return make_art({&file, 1}, jobs);
}

TEST(ScriptParts, AreInsertedWhereTheyAreUsed) {
  const std::string used =
      "part body\n  paint p gray\n  bone a 0,0,0\nmodel x.mdl\n  use body\n  box a 0,0,0 4,4,4\n";
  const std::string plain = "model x.mdl\n  paint p gray\n  bone a 0,0,0\n  box a 0,0,0 4,4,4\n";
  const auto with_part = build_art(used), without = build_art(plain);
  ASSERT_TRUE(with_part.ok() && without.ok());
  ASSERT_EQ(with_part->size(), without->size());
  for (std::size_t i = 0; i < with_part->size(); ++i) EXPECT_EQ((*with_part)[i].bytes, (*without)[i].bytes);
}

TEST(ScriptParts, InvalidPartsAreErrors) {
  EXPECT_EQ(build_art("model x.mdl\n  use body\n").error().message(),
            "test.script: line 2: use: no part is named 'body'");
  EXPECT_EQ(build_art("part a\n  use a\nmodel x.mdl\n  use a\n").error().message(),
            "test.script: part a, line 2: use: parts use each other in a circle");
  EXPECT_EQ(build_art("part a\n  bone b\npart a\n  bone c\n").error().message(),
            "test.script: line 3: part: this name is already in use");
  EXPECT_EQ(build_art("part a\n  bone b\nmodel x.mdl\n  use a\n").error().message(),
            "test.script: part a, line 2: bone: expected X,Y,Z");
}

// The script in docs/art-scripts.md, as a reader would copy it.
TEST(ModelScripts, TheDocumentedExampleIsAModel) {
  std::ifstream file(TEMBLOR_SOURCE_DIR "/docs/art-scripts.md");
  std::ostringstream all;
  all << file.rdbuf();
  const std::string text = all.str();
  const std::size_t first = text.find("# A mine lamp");
  ASSERT_NE(first, std::string::npos);
  const auto art = build_art(text.substr(first, text.find("```", first) - first));
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
