#include "client/debris/impacts.h"

#include <gtest/gtest.h>

namespace temblor::client {
namespace {

// Names of the shipped game and of the original.
TEST(Materials, FollowTheNamesOfTextures) {
  for (const char* name : {"metal5_2", "METAL1", "copper3", "rust2", "{grate2", "+0slip", "tech04_1",
                           "plat_top1", "door3", "+0button"})
    EXPECT_EQ(find_material(name), Material::kMetal) << name;
  for (const char* name : {"wood1_1", "beam2", "crate1", "wdr02"})
    EXPECT_EQ(find_material(name), Material::kWood) << name;
  for (const char* name : {"stone1", "brick4", "rock3_7", "city2_1", "ground1_6", "", "plaster1"})
    EXPECT_EQ(find_material(name), Material::kStone) << name;
}

struct ShownImpact {
  explicit ShownImpact(Material material) {
    pool.set_capacity(1000);
    EffectRandom random(7);
    spawn_impact({pool, random, 1}, {{0, 0, 0}, {1, 0, 0}, material}, puffs);
    pool.advance(1.05);
    puffs.advance(1.05);
  }
  ParticlePool pool;
  Puffs puffs;
};

TEST(Impacts, LookLikeTheMaterial) {
  struct Case {
    Material material;
    int first_color, last_color;
    std::size_t puffs;
  };
  for (const Case& c : {Case{Material::kMetal, 224, 239, 0}, Case{Material::kStone, 0, 15, 1},
                        Case{Material::kWood, 16, 31, 1}}) {
    const ShownImpact shown(c.material);
    const render::ParticleCloud cloud = shown.pool.cloud();
    ASSERT_GT(cloud.size(), 5u);
    float sum = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      EXPECT_GE(cloud.color[i], c.first_color);
      EXPECT_LE(cloud.color[i], c.last_color);
      sum += cloud.x[i];
    }
    EXPECT_GT(sum, 0) << "away from the wall";
    EXPECT_EQ(shown.puffs.puffs().size(), c.puffs);
  }
}

}  // namespace
}  // namespace temblor::client
