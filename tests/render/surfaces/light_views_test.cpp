// The views for mappers: the level without light, light without textures, no level at all, and a locked PVS.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "render/renderer.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using render::LightView;
using render::PixelFormat;

struct View {
  DrawableLevel drawable = small_level();
  render::Renderer renderer{drawable.palette, drawable.colormap};
  Viewpoint viewpoint;
  render::FrameStats stats;

  explicit View(std::uint64_t seed) {
    Random random(seed);
    viewpoint = {.camera = random_camera(*drawable.level, random),
                 .brush_models = shown_brush_models(*drawable.level)};
    viewpoint.lights = random_lights(viewpoint.camera.origin_world, 3, random);
  }
  render::Scene scene() const { return viewpoint.scene(*drawable.level); }
  FrameCopy draw(const render::Scene& shown, const render::Settings& settings,
                 PixelFormat format = PixelFormat::kRgb) {
    render::FrameBuffer frame(200, 150, format);
    stats = renderer.render(shown, settings, frame);
    return copy_picture(frame);
  }
  // The faces of the last picture's pixels.
  std::vector<render::PixelFace> faces() const {
    std::vector<render::PixelFace> all(200 * 150);
    std::vector<std::uint8_t> writes(all.size());
    renderer.pixel_faces(all, writes);
    return all;
  }
  bool is_lit(const render::PixelFace& pixel) const {
    return pixel.face != render::PixelFace::kNothing &&
           drawable.level->faces[pixel.face].kind == world::FaceKind::kLit &&
           drawable.level->faces[pixel.face].style_count > 0;
  }
};

TEST(LightViews, FullBrightShowsColorsOfThePaletteWhateverTheLight) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    View view(seed);
    std::set<std::uint32_t> palette;
    for (const formats::Rgb color : view.drawable.palette) palette.insert(render::to_rgb(color));
    const render::Settings settings{.light_view = LightView::kFullBright};
    const FrameCopy picture = view.draw(view.scene(), settings);
    const std::vector<render::PixelFace> faces = view.faces();
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (view.is_lit(faces[i])) {
        ASSERT_TRUE(palette.contains(picture.rgb[i])) << seed << ", pixel " << i;
      }
    render::Scene dark = view.scene();
    dark.lights = {};
    dark.light_styles.fill(0);
    EXPECT_EQ(view.draw(dark, settings), picture) << seed;
    EXPECT_NE(view.draw(dark, {}), picture) << seed;
    EXPECT_EQ(view.draw(view.scene(), settings), picture) << "views must not share surfaces";
  }
}

TEST(LightViews, FullBrightShowsTheTextureInIndexedPictures) {
  View view(3);
  const FrameCopy picture =
      view.draw(view.scene(), {.light_view = LightView::kFullBright}, PixelFormat::kIndexed);
  const std::vector<render::PixelFace> faces = view.faces();
  const FrameCopy in_rgb = view.draw(view.scene(), {.light_view = LightView::kFullBright});
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (view.is_lit(faces[i])) {
      ASSERT_EQ(render::to_rgb(view.drawable.palette[picture.indexed[i]]), in_rgb.rgb[i]);
    }
}

TEST(LightViews, OnlyLightIsGrayAndFollowsTheLight) {
  std::size_t seen = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    View view(seed);
    render::Scene scene = view.scene();
    scene.lights = {};  // they have colors
    const render::Settings settings{.light_view = LightView::kLightOnly, .colored_light = false};
    scene.light_styles.fill(128);  // so that no sum of light is clamped
    const FrameCopy picture = view.draw(scene, settings);
    const std::vector<render::PixelFace> faces = view.faces();
    scene.light_styles.fill(64);
    const FrameCopy darker = view.draw(scene, settings);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!view.is_lit(faces[i])) continue;
      const auto channel = [&](const FrameCopy& copy, int shift) {
        return static_cast<int>(copy.rgb[i] >> shift & 255);
      };
      ASSERT_NEAR(channel(picture, 0), channel(picture, 8), 12);
      ASSERT_NEAR(channel(picture, 0), channel(picture, 16), 12);
      ASSERT_NEAR(channel(darker, 0) * 2, channel(picture, 0), 4);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10000u);
}

TEST(LightViews, WithoutTheWorldOnlyBrushModelsAreDrawn) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    View view(seed);
    view.draw(view.scene(), {.draw_world = false});
    for (const render::PixelFace& pixel : view.faces()) ASSERT_NE(pixel.instance, 0u) << seed;
  }
}

TEST(LockedPvs, CountsTheFacesOfItsLeaf) {
  View here(1), there(2);
  const world::LeafIndex leaf = world::find_leaf(*there.drawable.level, there.viewpoint.camera.origin_world);
  there.draw(there.scene(), {});
  render::Scene locked = here.scene();
  locked.pvs_leaf = leaf;
  here.draw(locked, {});
  EXPECT_EQ(here.stats.faces_in_pvs, there.stats.faces_in_pvs);
}

}  // namespace
}  // namespace temblor::test
