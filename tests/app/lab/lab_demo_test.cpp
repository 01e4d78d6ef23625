// Exact techniques on moments of stock demos, with moving brush models, fog, and particles.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/lab/lab_scenes.h"
#include "lab/registry.h"
#include "render/renderer.h"
#include "support/game_data.h"
#include "support/pictures/frames.h"

namespace temblor::app {
namespace {

TEST(LabDemo, LooksTheSameByExactTechniques) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const demo : {"demo1_lite", "demo3_lite"}) {
    const LabScenes scenes =
        LabScenes::load_demo({.base_folder = data.string(), .games = {}}, demo, {}).value();
    render::Renderer engine(scenes.look().palette, scenes.look().colormap);
    for (const char* const text : {"leaf-faces", "portals", "portals:octagon=1,pvs=1"}) {
      render::Renderer technique(scenes.look().palette, scenes.look().colormap);
      technique.replace_stages(lab::parse_choice(text).value().make_stages());
      std::size_t brush_models = 0;
      const base::Status played = scenes.for_each_scene([&](const render::Scene& scene) {
        render::FrameBuffer wanted(320, 200, render::PixelFormat::kRgb);
        render::FrameBuffer drawn(320, 200, render::PixelFormat::kRgb);
        engine.render(scene, {}, wanted);
        technique.render(scene, {}, drawn);
        EXPECT_EQ(test::compute_hash(drawn), test::compute_hash(wanted)) << text << " in " << demo;
        brush_models += scene.brush_models.size();
      });
      EXPECT_TRUE(played.ok());
      EXPECT_GT(brush_models, 0u) << demo;
    }
  }
}

}  // namespace
}  // namespace temblor::app
