#include "render_gl/models/model_cache.h"

#include <gtest/gtest.h>

#include "platform/egl/offscreen_context.h"
#include "render/alias/alias_mesh.h"
#include "support/models/drawable_models.h"

namespace temblor::render_gl {
namespace {

// A context, and the cache in it.
class ModelCacheTest : public testing::Test {
 protected:
  void SetUp() override {
    auto context = platform::egl::make_offscreen_context();
    if (!context.ok()) GTEST_SKIP() << "no OpenGL: " << context.error().what;
    context_ = std::move(context).value();
    gl_ = load_functions([&](const char* name) { return context_->find_function(name); }).value();
    cache_.emplace();
  }
  void TearDown() override { cache_.reset(); }

  const CardModel* find(const render::AliasModel& model) { return cache_->find(gl_, model).value(); }

  std::unique_ptr<platform::GlContext> context_;
  Functions gl_;
  std::optional<ModelCache> cache_;  // destroyed before its context
  const std::shared_ptr<const render::AliasModel> box_ = test::small_model(test::box_mdl());
};

TEST_F(ModelCacheTest, UploadsAModelOnce) {
  const CardModel* const first = find(*box_);
  cache_->begin_frame();
  EXPECT_EQ(find(*box_), first);
  EXPECT_EQ(cache_->size(), 1u);
}

TEST_F(ModelCacheTest, DropsModelsThatTheCallerHasFreed) {
  auto sphere = test::small_model(test::sphere_mdl());
  find(*box_);
  find(*sphere);
  cache_->begin_frame();
  EXPECT_EQ(cache_->size(), 2u);
  sphere.reset();
  cache_->begin_frame();
  EXPECT_EQ(cache_->size(), 1u);
}

TEST_F(ModelCacheTest, DropsModelsThatAreNotDrawn) {
  const auto sphere = test::small_model(test::sphere_mdl());
  find(*sphere);
  for (std::uint32_t frame = 0; frame < ModelCache::kIdleFrames; ++frame) {
    cache_->begin_frame();
    find(*box_);
  }
  EXPECT_EQ(cache_->size(), 2u);
  cache_->begin_frame();
  EXPECT_EQ(cache_->size(), 1u);
}

TEST_F(ModelCacheTest, TellsModelsAtOneAddressApart) {
  render::AliasModel place = *box_;
  const CardModel* const box = find(place);
  place = *test::small_model(test::sphere_mdl());
  const CardModel* const sphere = find(place);
  EXPECT_NE(sphere, box);
  EXPECT_EQ(sphere->skin_place(0).width, 128);
  EXPECT_EQ(box->skin_place(0).width, 64);
}

}  // namespace
}  // namespace temblor::render_gl
