// Failures of the driver: one clear line for each, and nothing stays on the card.
#include <gtest/gtest.h>

#include "render_gl/gl_renderer.h"
#include "render_gl/injected_gl.h"
#include "render_gl/model_scenes.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"

namespace temblor::render_gl {
namespace {

// Draws frames of a scene with models, one of them translucent, in fog, under water.
class FailingCard : public testing::TestWithParam<render::PixelFormat> {
 protected:
  void SetUp() override {
    auto made = InjectedGl::make();
    if (!made.ok()) GTEST_SKIP() << "no OpenGL: " << made.error().what;
    card_ = std::move(made).value();
    test::Random random(1);
    scene_ = random_scene(make_small_models(), *level_.level, 3, random);
    scene_.instances.front().alpha = 0.5f;
    scene_.weapon = scene_.instances.back();
  }

  base::Result<GlRenderer> make() {
    card_->calls = {};
    auto made = GlRenderer::make(card_->finder(), level_.palette, level_.colormap, {.bytes = 8 << 20});
    if (made.ok()) made->set_method(method_);
    return made;
  }
  base::Status draw(GlRenderer& io_renderer) {
    render::FrameBuffer frame(64, 48, GetParam());
    render::Scene scene = scene_.scene(*level_.level);
    scene.underwater = true;
    scene.fog = {.density = 0.1f, .color = {0.8f, 0.5f, 0.2f}};
    scene.liquid_alpha = {.water = 0.5f, .slime = 0.5f, .lava = 0.5f, .teleport = 0.5f};
    TRY_STATUS(io_renderer.render(scene, {}, frame));
    return io_renderer.draw_overlay(overlay_, frame);
  }
  // Makes a renderer, draws, and destroys the renderer. Returns the error, or nothing.
  std::string run() {
    std::string line;
    {
      base::Result<GlRenderer> renderer = make();
      if (renderer.ok()) {
        const base::Status drawn = draw(*renderer);
        if (!drawn.ok()) line = drawn.error().what;
      } else {
        line = renderer.error().what;
      }
    }
    EXPECT_EQ(card_->live_objects(), 0u) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return line;
  }

  const test::DrawableLevel level_ = test::small_level();
  const formats::Picture picture_{4, 2, {1, 2, 3, 4, 5, 6, 7, 255}};
  // Some of it is translucent, or a sum.
  const render::DrawList overlay_{
      {{.picture = &picture_, .area = {0, 0, 4, 2}},
       {.area = {1, 1, 5, 5}, .opacity = 0.5f},
       {.picture = &picture_, .area = {2, 2, 8, 4}, .scale = 2, .mode = render::DrawMode::kAdd}}};
  std::unique_ptr<InjectedGl> card_;
  ModelScene scene_;
  WorldMethod method_ = WorldMethod::kLitTextures;
};

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

TEST_P(FailingCard, DeletesAllThatItHas) {
  {
    base::Result<GlRenderer> renderer = make();
    ASSERT_TRUE(renderer.ok());
    EXPECT_GT(card_->live_objects(), 10u);
    EXPECT_TRUE(draw(*renderer).ok());
    EXPECT_GT(card_->live_bytes(), 1u << 20);
  }
  EXPECT_EQ(card_->live_objects(), 0u);
  EXPECT_EQ(run(), "");
}

TEST_P(FailingCard, NamesEachMissingFunction) {
#define TEMBLOR_GL_NAME(Type, Name) "gl" #Name,
  for (const char* name : {TEMBLOR_GL_FUNCTIONS(TEMBLOR_GL_NAME)}) {
    card_->faults.missing_function = name;
    EXPECT_EQ(run(), std::string("the OpenGL driver has no ") + name);
  }
#undef TEMBLOR_GL_NAME
}

// An old driver also lacks functions, but its age is the reason.
TEST_P(FailingCard, SaysThatADriverIsTooOld) {
  for (const GLint major : {0, 1, 2}) {
    card_->faults.integers[GL_MAJOR_VERSION] = major;
    card_->faults.missing_function = "glGenVertexArrays";
    const base::Result<GlRenderer> made = make();
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, base::ErrorCode::kUnsupported);
    EXPECT_TRUE(contains(run(), "the OpenGL driver is too old (")) << made.error().what;
  }
}

TEST_P(FailingCard, SurvivesEachShaderThatDoesNotCompileOrLink) {
  ASSERT_EQ(run(), "");
  const InjectedGl::Calls all = card_->calls;
  EXPECT_EQ(all.compile, 2 * all.link);
  for (int number = 0; number < all.compile; number += test::effort(1, 5)) {
    card_->faults.compile = number;
    EXPECT_TRUE(contains(run(), "the OpenGL driver does not compile a shader")) << number;
  }
  card_->faults.compile = -1;
  for (int number = 0; number < all.link; number += test::effort(1, 5)) {
    card_->faults.link = number;
    EXPECT_TRUE(contains(run(), "the OpenGL driver does not link a shader")) << number;
  }
}

TEST_P(FailingCard, SurvivesEachTextureAndBufferThatDoesNotFit) {
  ASSERT_EQ(run(), "");
  const InjectedGl::Calls all = card_->calls;
  for (int number = 0; number < all.texture; ++number) {
    card_->faults.texture = number;
    EXPECT_TRUE(contains(run(), "the graphics card is out of memory")) << number;
  }
  card_->faults.texture = -1;
  for (int number = 0; number < all.buffer; ++number) {
    card_->faults.buffer = number;
    EXPECT_TRUE(contains(run(), "the graphics card is out of memory")) << number;
  }
}

TEST_P(FailingCard, SaysThatItCannotDrawIntoTextures) {
  ASSERT_EQ(run(), "");
  const int all = card_->calls.framebuffer;
  EXPECT_GE(all, 3);  // the picture, another one for the warp, and a model's
  for (int number = 0; number < all; ++number) {
    card_->faults.framebuffer = number;
    EXPECT_EQ(run(), "the graphics card cannot draw into a texture") << number;
  }
}

TEST_P(FailingCard, SaysThatTheContextIsLost) {
  constexpr GLenum kContextLost = 0x0507;
  card_->faults.texture_error = kContextLost;
  card_->faults.texture = 0;
  EXPECT_TRUE(contains(run(), "the OpenGL context is lost"));
}

// The driver reports that the card was reset, without an error of OpenGL.
TEST_P(FailingCard, NoticesThatTheCardWasReset) {
  base::Result<GlRenderer> renderer = make();
  ASSERT_TRUE(renderer.ok());
  EXPECT_TRUE(draw(*renderer).ok());
  constexpr GLenum kInnocentReset = 0x8254;
  card_->faults.reset_status = kInnocentReset;
  const base::Status drawn = draw(*renderer);
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().what, "the OpenGL context is lost: the graphics card was reset");
}

// The methods whose objects differ from those of kLitTextures. Indexed frames have no methods. Failures
// before the first frame are those of all methods.
TEST_P(FailingCard, SurvivesFailuresOfEachMethod) {
  using enum WorldMethod;
  if (GetParam() == render::PixelFormat::kIndexed) return;
  for (const WorldMethod method :
       {kCardBlocks, kExpandedBlocks, kLightPass, kLightPolygons, kGouraud, kStyleLayers}) {
    method_ = method;
    EXPECT_TRUE(make().ok());
    const InjectedGl::Calls before = card_->calls;
    ASSERT_EQ(run(), "");
    const InjectedGl::Calls all = card_->calls;
    const auto fail_each = [&](int begin, int end, int& io_fault, const char* line) {
      for (int number = begin; number < end; number += test::effort(1, 5)) {
        io_fault = number;
        EXPECT_TRUE(contains(run(), line)) << number;
      }
      io_fault = -1;
    };
    Faults& faults = card_->faults;
    fail_each(before.compile, all.compile, faults.compile, "the OpenGL driver does not compile a shader");
    fail_each(before.link, all.link, faults.link, "the OpenGL driver does not link a shader");
    fail_each(before.texture, all.texture, faults.texture, "the graphics card is out of memory");
    fail_each(before.buffer, all.buffer, faults.buffer, "the graphics card is out of memory");
    fail_each(before.framebuffer, all.framebuffer, faults.framebuffer,
              "the graphics card cannot draw into a texture");
  }
}

// A frame that fails leaves the renderer as it was.
TEST_P(FailingCard, DrawsTheNextFrameAfterOneThatFailed) {
  base::Result<GlRenderer> renderer = make();
  ASSERT_TRUE(renderer.ok());
  card_->faults.texture = card_->calls.texture + 1;
  EXPECT_FALSE(draw(*renderer).ok());
  EXPECT_TRUE(draw(*renderer).ok());
}

INSTANTIATE_TEST_SUITE_P(BothFormats, FailingCard,
                         testing::Values(render::PixelFormat::kRgb, render::PixelFormat::kIndexed));

}  // namespace
}  // namespace temblor::render_gl
