#include "compiler/light/surface_keys.h"

#include <gtest/gtest.h>

namespace temblor::test {
namespace {

formats::Entity entity(std::vector<std::pair<std::string, std::string>> pairs) {
  return {std::move(pairs)};
}

TEST(SurfaceKeys, AreReadWithAndWithoutUnderscore) {
  const auto keys = compiler::read_surface_keys(entity({{"classname", "func_detail"},
                                                        {"_phong", "1"},
                                                        {"_phong_angle", "45"},
                                                        {"_phong_group", "3"},
                                                        {"minlight", "20"},
                                                        {"_minlight_color", "255 127.5 0"},
                                                        {"_dirt", "-1"},
                                                        {"_bounce", "-1"},
                                                        {"_lightignore", "1"},
                                                        {"_lmscale", "0.5"},
                                                        {"alpha", "0.25"}}));
  compiler::SurfaceKeys expected;
  expected.phong_angle_deg = 45;
  expected.phong_group = 3;
  expected.min_light = 20;
  expected.min_light_color = {1, 0.5f, 0};
  expected.takes_dirt = expected.takes_bounce = false;
  expected.ignores_light = true;
  expected.light_map_scale = 0.5f;
  expected.light_alpha = 0.25f;
  EXPECT_EQ(keys, expected);
}

TEST(SurfaceKeys, PhongAloneUsesTheDefaultAngle) {
  EXPECT_EQ(compiler::read_surface_keys(entity({{"_phong", "1"}})).phong_angle_deg, 89);
  EXPECT_EQ(compiler::read_surface_keys(entity({})).phong_angle_deg, 0);
}

TEST(SurfaceKeys, WorldCastsShadowsAndDoorsOnlyOnRequest) {
  const auto casts = [](const char* classname, const char* shadow) {
    formats::Entity asking = entity({{"classname", classname}});
    if (*shadow != '\0') asking.pairs.emplace_back("_shadow", shadow);
    return compiler::read_surface_keys(asking).casts_shadow;
  };
  for (const char* name :
       {"worldspawn", "func_group", "func_detail", "func_detail_wall", "func_detail_fence"}) {
    EXPECT_TRUE(casts(name, "")) << name;
    EXPECT_FALSE(casts(name, "-1")) << name;
  }
  for (const char* name : {"func_door", "func_wall", "func_detail_illusionary"}) {
    EXPECT_FALSE(casts(name, "")) << name;
    EXPECT_TRUE(casts(name, "1")) << name;
  }
}

TEST(SurfaceKeys, ShadowsMayBeLimitedToSomeReceivers) {
  struct Shadow {
    bool cast, on_own_model_only, on_world_only;
    bool operator==(const Shadow&) const = default;
  };
  const auto shadow = [](std::vector<std::pair<std::string, std::string>> pairs) {
    pairs.insert(pairs.begin(), {"classname", "func_wall"});
    const compiler::SurfaceKeys keys = compiler::read_surface_keys(entity(std::move(pairs)));
    return Shadow{keys.casts_shadow, keys.shadows_own_model_only, keys.shadows_world_only};
  };
  EXPECT_EQ(shadow({{"_shadowself", "1"}}), (Shadow{true, true, false}));
  EXPECT_EQ(shadow({{"_shadowworldonly", "1"}}), (Shadow{true, false, true}));
  EXPECT_EQ(shadow({{"_shadowself", "1"}, {"_shadowworldonly", "1"}}), (Shadow{true, true, false}));
  EXPECT_EQ(shadow({{"_shadow", "1"}, {"_shadowself", "1"}}), (Shadow{true, false, false}));
  EXPECT_EQ(shadow({{"_shadowself", "-1"}}), (Shadow{false, false, false}));
}

TEST(SurfaceKeys, FacesHaveTheKeysOfTheirModelsEntity) {
  formats::Bsp bsp;
  bsp.faces.resize(6);
  bsp.models = {{.face_count = 4}, {.first_face = 4, .face_count = 2}};
  const std::vector<formats::Entity> entities{
      entity({{"classname", "worldspawn"}}),
      entity({{"classname", "func_wall"}, {"model", "*1"}, {"_minlight", "77"}}),
      entity({{"classname", "func_wall"}, {"model", "*9"}, {"_minlight", "1"}}),
      entity({{"classname", "func_wall"}, {"model", "*x"}, {"_minlight", "1"}})};
  const compiler::FaceKeys keys = compiler::find_face_keys(bsp, entities);
  ASSERT_EQ(keys.of_face.size(), 6u);
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_EQ(keys.keys[keys.of_face[face]].min_light, face < 4 ? 0 : 77);
}

}  // namespace
}  // namespace temblor::test
