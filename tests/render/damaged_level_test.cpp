// Levels with damage that other engines ignore are drawn, with the same pixels where the damage shows
// nowhere.
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "formats/levels/bsp.h"
#include "render/renderer.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

struct LevelDamage {
  const char* name;
  void (*apply)(formats::Bsp& io_bsp);
  bool is_hidden;  // the picture stays the same
};

formats::BspFace& last_face(formats::Bsp& io_bsp) {
  return io_bsp.faces[io_bsp.models[0].face_count - 1];
}

#define APPLY(...) [](formats::Bsp& b) { __VA_ARGS__; }

const LevelDamage kDamage[] = {
    {"UnusedHull", APPLY(b.models[0].head_nodes[3] = 99999), true},
    {"ModelOrigin", APPLY(b.models.back().origin.x = kNoNumber), true},
    {"ModelBounds", APPLY(b.models.back().mins = b.models.back().maxs = math::Vec3(kNoNumber)), true},
    {"PlaneTypes",
     APPLY(for (auto& plane
                : b.planes) plane.type = 99),
     true},
    {"FaceSides",
     APPLY(for (auto& face
                : b.faces) if (face.side != 0) face.side = 7),
     true},
    {"VisibleLeaves", APPLY(b.models[0].visible_leaves = 99999), true},
    {"LightStyle",
     APPLY(for (auto& face
                : b.faces) if (face.styles[0] == 0) face.styles[0] = 200),
     true},
    {"LeafVisibility",
     APPLY(for (auto& leaf
                : b.leaves) leaf.visibility_offset = 1 << 28),
     true},
    {"LeafContents", APPLY(b.leaves.back().contents = -20), false},
    {"Texinfo", APPLY(b.texinfos[0].s_axis.x = kNoNumber), false},
    {"Vertex", APPLY(b.vertices[1].y = kNoNumber), false},
    {"TextureNumber", APPLY(b.texinfos[0].miptex = 5000), false},
    {"NoTextures", APPLY(b.miptexes.clear()), false},
    {"NodeFaces", APPLY(b.nodes.back().first_face = 60000; b.nodes.back().face_count = 9), false},
    {"PlaneNormal", APPLY(b.planes.back().normal = math::Vec3(0.0f)), false},
    {"FaceEdges", APPLY(last_face(b).surfedge_count = 0), false},
};

std::vector<FrameCopy> draw_views(const DrawableLevel& look, const world::Level& level,
                                  const world::Level& sound) {
  std::vector<FrameCopy> pictures;
  render::Renderer renderer(look.palette, look.colormap);
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Random random(seed);
    const Viewpoint viewpoint{.camera = random_camera(sound, random),
                              .brush_models = shown_brush_models(level)};
    for (const render::PixelFormat format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
      render::FrameBuffer frame(160, 100, format);
      renderer.render(viewpoint.scene(level), {}, frame);
      pictures.push_back(copy_picture(frame));
    }
  }
  return pictures;
}

void expect_drawn(const formats::Bsp& bsp, const DrawableLevel& look) {
  const auto sound = world::make_level(bsp, "sound").value();
  const std::vector<FrameCopy> expected = draw_views(look, *sound, *sound);
  for (const LevelDamage& damage : kDamage) {
    SCOPED_TRACE(damage.name);
    formats::Bsp damaged = bsp;
    damage.apply(damaged);
    auto back = formats::read_bsp(formats::write_bsp(damaged, formats::BspVersion::k29).value());
    ASSERT_TRUE(back.ok()) << back.error().message();
    const auto level = world::make_level(std::move(back).value(), "damaged");
    ASSERT_TRUE(level.ok()) << level.error().message();
    EXPECT_LE((*level)->notes.size(), 1u);
    const std::vector<FrameCopy> drawn = draw_views(look, **level, *sound);
    EXPECT_TRUE(drawn == expected || !damage.is_hidden);
  }
}

TEST(DamagedLevel, MadeInCodeIsDrawn) {
  expect_drawn(artgen::make_small_level({}), small_level());
}

TEST(DamagedLevel, OfTheStockGameIsDrawn) {
  DATA_FOLDER_OR_SKIP(data);
  expect_drawn(formats::read_bsp(read_file(data / "id1/maps/start.bsp")).value(), stock_level(data, "start"));
}

}  // namespace
}  // namespace temblor::test
