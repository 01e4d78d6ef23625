// Compares the faces of a level with the file: texture rectangles, light, and kinds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/text.h"
#include "support/game_data.h"
#include "support/levels/bsp_faces.h"
#include "world/level.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

using test::list_vertices;

struct Range {
  double min = 1e30, max = -1e30;
};
Range texel_range(const std::vector<math::Vec3>& vertices, const math::Vec3& axis, float offset) {
  Range range;
  for (const math::Vec3& v : vertices) {
    const double texel = double{v.x} * axis.x + double{v.y} * axis.y + double{v.z} * axis.z + offset;
    range = {std::min(range.min, texel), std::max(range.max, texel)};
  }
  return range;
}

// The smallest rectangle on the 16-texel grid that covers the face, within the precision of a float.
void expect_tight(const Range& range, std::int32_t min, std::int32_t extent, const std::string& what) {
  constexpr double kFloatTexel = 0.01;
  EXPECT_GE(extent, 0) << what;
  EXPECT_EQ(min % 16, 0) << what;
  EXPECT_EQ(extent % 16, 0) << what;
  EXPECT_LE(min, range.min + kFloatTexel) << what;
  EXPECT_GT(min + 16, range.min - kFloatTexel) << what;
  EXPECT_GE(min + extent, range.max - kFloatTexel) << what;
  EXPECT_LT(min + extent - 16, range.max + kFloatTexel) << what;
}

void expect_rectangles_cover_faces(const TestLevel& test) {
  for (std::size_t i = 0; i < test.bsp.faces.size(); ++i) {
    const formats::BspTexinfo& info = test.bsp.texinfos[test.bsp.faces[i].texinfo];
    const std::vector<math::Vec3> vertices = list_vertices(test.bsp, test.bsp.faces[i]);
    const Face& face = test.level->faces[i];
    const std::string what = test.name + " face " + std::to_string(i);
    expect_tight(texel_range(vertices, info.s_axis, info.s_offset), face.texture_mins[0],
                 face.texture_extents[0], what + " s");
    expect_tight(texel_range(vertices, info.t_axis, info.t_offset), face.texture_mins[1],
                 face.texture_extents[1], what + " t");
  }
}

TEST(Faces, RectanglesOfTexelsCoverStockFacesTightly) {
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) expect_rectangles_cover_faces(test);
}

TEST(Faces, RectanglesOfTexelsCoverFacesOfTheSmallLevelTightly) {
  expect_rectangles_cover_faces(small_test_level());
  expect_rectangles_cover_faces(small_test_level({.wide_faces = true}));
}

// The light compiler packed the samples of the faces one after another, padded to multiples of 4 bytes, so
// the distance between two offsets shows how many samples a face has.
TEST(Faces, NumberOfLightSamplesIsTheCompilersOwn) {
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) {
    std::set<std::size_t> starts = {test.bsp.lighting.size()};
    for (const formats::BspFace& face : test.bsp.faces)
      if (face.light_offset >= 0) starts.insert(static_cast<std::size_t>(face.light_offset));
    for (std::size_t i = 0; i < test.bsp.faces.size(); ++i) {
      const Face& face = test.level->faces[i];
      if (face.light == kNoLight) continue;
      const std::size_t samples = static_cast<std::size_t>(face.light_width()) *
                                  static_cast<std::size_t>(face.light_height()) * face.style_count;
      const std::size_t room = *starts.upper_bound(face.light) - face.light;
      EXPECT_LE(samples, room) << test.name << " face " << i;
      EXPECT_LT(room, samples + 4) << test.name << " face " << i;
    }
  }
}

TEST(Faces, KindsAndLightFollowTextureNamesFlagsAndOffsets) {
  DATA_FOLDER_OR_SKIP(base_folder);
  std::map<FaceKind, int> seen;
  for (const TestLevel& test : stock_levels(base_folder)) {
    for (std::size_t i = 0; i < test.bsp.faces.size(); ++i) {
      const formats::BspFace& bsp_face = test.bsp.faces[i];
      const formats::BspTexinfo& info = test.bsp.texinfos[bsp_face.texinfo];
      const std::string name = base::to_lower(test.bsp.miptexes[static_cast<std::size_t>(info.miptex)].name);
      FaceKind expected = FaceKind::kLit;
      if (name.rfind("sky", 0) == 0) expected = FaceKind::kSky;
      if (name.rfind('*', 0) == 0) expected = FaceKind::kLiquid;
      const Face& face = test.level->faces[i];
      EXPECT_EQ(face.kind, expected) << test.name << " face " << i << " " << name;
      EXPECT_EQ(face.light == kNoLight, bsp_face.light_offset < 0 || expected != FaceKind::kLit);
      if (face.light != kNoLight) {
        EXPECT_EQ(face.light, static_cast<std::uint32_t>(bsp_face.light_offset));
        EXPECT_EQ(face.styles, bsp_face.styles);
      }
      EXPECT_EQ(face.style_count, std::count_if(face.styles.begin(), face.styles.end(),
                                                [](std::uint8_t style) { return style != kNoStyle; }));
      ++seen[face.kind];
    }
  }
  EXPECT_GT(seen[FaceKind::kSky], 0);
  EXPECT_GT(seen[FaceKind::kLiquid], 0);
}

void expect_clockwise(const TestLevel& test) {
  for (std::size_t i = 0; i < test.bsp.faces.size(); ++i) {
    const std::vector<math::Vec3> vertices = list_vertices(test.bsp, test.bsp.faces[i]);
    // Newell's normal: it points toward a viewer who sees the loop run counter-clockwise.
    math::Vec3d newell(0.0);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const math::Vec3d a(vertices[k] - vertices[0]);
      const math::Vec3d b(vertices[(k + 1) % vertices.size()] - vertices[0]);
      newell += glm::cross(a, b);
    }
    const Face& face = test.level->faces[i];
    const double side = face.back_side ? -1 : 1;
    const math::Vec3d front = math::Vec3d(test.level->planes[face.plane].normal) * side;
    EXPECT_LT(glm::dot(newell, front), 0) << test.name << " face " << i;
  }
}

TEST(Faces, RunClockwiseSeenFromTheFront) {
  expect_clockwise(small_test_level());
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) expect_clockwise(test);
}

TEST(Faces, AreUnlitWhereTheLevelHasNoLight) {
  const TestLevel test = small_test_level({.light = false});
  EXPECT_FALSE(test.level->has_light);
  int unlit = 0;
  for (const Face& face : test.level->faces) {
    EXPECT_NE(face.kind, FaceKind::kLit);
    EXPECT_EQ(face.light, kNoLight);
    if (face.kind == FaceKind::kUnlit) ++unlit;
  }
  EXPECT_GT(unlit, 0);
}

// Returns a face of the tiny level that has light.
std::size_t find_lit_face(const formats::Bsp& bsp) {
  const auto lit = std::find_if(bsp.faces.begin(), bsp.faces.end(),
                                [](const formats::BspFace& face) { return face.light_offset >= 0; });
  return static_cast<std::size_t>(lit - bsp.faces.begin());
}

TEST(Faces, AreBlackWithoutSamplesInALitLevelUnlessFlagged) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  const std::size_t i = find_lit_face(bsp);
  bsp.faces[i].light_offset = -1;
  bsp.texinfos.push_back(bsp.texinfos[bsp.faces[i].texinfo]);
  const TestLevel black = test_level("black", bsp);
  EXPECT_EQ(black.level->faces[i].kind, FaceKind::kLit);
  EXPECT_EQ(black.level->faces[i].light, kNoLight);
  EXPECT_EQ(black.level->faces[i].style_count, 0);

  bsp.texinfos.back().flags = 1;
  bsp.faces[i].texinfo = static_cast<std::uint32_t>(bsp.texinfos.size() - 1);
  const TestLevel flagged = test_level("flagged", bsp);
  EXPECT_EQ(flagged.level->faces[i].kind, FaceKind::kUnlit);
}

TEST(Faces, HaveNoLightIfItWouldBePastTheEnd) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  const std::size_t i = find_lit_face(bsp);
  const Face face = test_level("whole", bsp).level->faces[i];
  const std::size_t samples = static_cast<std::size_t>(face.light_width()) *
                              static_cast<std::size_t>(face.light_height()) * face.style_count;
  bsp.faces[i].light_offset = static_cast<std::int32_t>(bsp.lighting.size() - samples);
  EXPECT_NE(test_level("last", bsp).level->faces[i].light, kNoLight);
  for (const std::int32_t offset : {bsp.faces[i].light_offset + 1, 0x7fffffff}) {
    bsp.faces[i].light_offset = offset;
    const TestLevel past = test_level("past", bsp);
    EXPECT_EQ(past.level->faces[i].light, kNoLight);
    EXPECT_EQ(past.level->faces[i].style_count, 0);
    ASSERT_EQ(past.level->notes.size(), 1u);
    EXPECT_EQ(past.level->notes[0].find("1 face with light samples outside of the level's"), 0u);
  }
}

// Small faces take a surface with or without light. Large ones share all samples of the level at most 64
// times.
TEST(Faces, LoseTheirLightIfManyLargeOnesShareIt) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  const std::size_t lit = find_lit_face(bsp);
  const formats::BspFace shared = bsp.faces[lit];
  constexpr std::size_t kFaces = 3000;
  const auto count_dark = [&](float scale, std::string& out_note) {
    formats::Bsp crowded = bsp;
    formats::BspTexinfo large = bsp.texinfos[shared.texinfo];
    large.s_axis *= scale;
    large.t_axis *= scale;
    crowded.texinfos.push_back(large);
    formats::BspFace face = shared;
    face.texinfo = static_cast<std::uint32_t>(bsp.texinfos.size());
    face.light_offset = 0;
    face.styles = {0, kNoStyle, kNoStyle, kNoStyle};
    crowded.lighting.assign(100'000, 200);
    for (formats::BspFace& other : crowded.faces) other.light_offset = -1;
    crowded.faces.insert(crowded.faces.end(), kFaces, face);
    for (std::size_t i = 0; i < kFaces; ++i) {
      auto& first = crowded.faces[bsp.faces.size() + i].first_surfedge;
      const std::size_t from = first;
      first = static_cast<std::uint32_t>(crowded.surfedges.size());
      for (std::size_t k = 0; k < face.surfedge_count; ++k)
        crowded.surfedges.push_back(crowded.surfedges[from + k]);
    }
    const auto level = make_level(crowded, "crowded").value();
    out_note = level->notes.empty() ? "" : level->notes[0];
    return std::ranges::count_if(std::span(level->faces).subspan(bsp.faces.size()),
                                 [](const Face& made) { return made.light == kNoLight; });
  };
  std::string note;
  EXPECT_EQ(count_dark(1, note), 0);
  EXPECT_EQ(note, "");
  const Face face = test_level("one", bsp).level->faces[lit];
  const float scale = 4096.0f / static_cast<float>(face.texture_extents[0]);
  const auto dark = count_dark(scale, note);
  EXPECT_EQ(note.find(std::to_string(dark) + " faces too large to share the level's 100000"), 0u) << note;
  EXPECT_GT(dark, 0);
}

TEST(Faces, LightStyleThatNoTableHoldsIsNormal) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  formats::BspFace& face = bsp.faces[find_lit_face(bsp)];
  for (const auto& [style, used] : {std::pair<int, int>{63, 63}, {64, 0}, {200, 0}, {254, 0}}) {
    face.styles[0] = static_cast<std::uint8_t>(style);
    const auto level = make_level(bsp, "style");
    ASSERT_TRUE(level.ok()) << level.error().message();
    EXPECT_EQ((*level)->faces[find_lit_face(bsp)].styles[0], used) << style;
  }
}

void expect_all_left_out(const base::Result<std::shared_ptr<const Level>>& level) {
  ASSERT_TRUE(level.ok()) << level.error().message();
  ASSERT_EQ((*level)->notes.size(), 1u);
  EXPECT_EQ((*level)->notes[0].find(base::counted((*level)->faces.size(), "face") + " left out: "), 0u);
  for (const Face& face : (*level)->faces) {
    EXPECT_EQ(face.kind, FaceKind::kUnlit);
    EXPECT_EQ(face.texture_extents, (std::array<std::int32_t, 2>{0, 0}));
    for (std::uint32_t i = 1; i < face.surfedge_count; ++i)
      EXPECT_EQ((*level)->surfedge_start(face.first_surfedge + i),
                (*level)->surfedge_start(face.first_surfedge));
  }
}

TEST(Faces, AbsurdTextureScaleLeavesFacesOut) {
  const formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  for (const float scale : {1e6f, 1e20f, 3e38f, -3e38f}) {
    formats::Bsp scaled = bsp;
    for (formats::BspTexinfo& info : scaled.texinfos) info.t_axis *= scale;
    expect_all_left_out(make_level(scaled, "scaled"));
  }
  formats::Bsp shifted = bsp;
  for (formats::BspTexinfo& info : shifted.texinfos) info.s_offset = 3e7f;
  expect_all_left_out(make_level(shifted, "shifted"));
}

}  // namespace
}  // namespace temblor::world
