// Pictures that are larger than the card's textures: the frame is drawn, with fewer texels.
#include <gtest/gtest.h>

#include <cstdlib>

#include "render_gl/gl/texture_limits.h"
#include "render_gl/injected_gl.h"
#include "render_gl/model_scenes.h"
#include "render_gl/scene_views.h"
#include "render_gl/surfaces/block_atlas.h"
#include "render_gl/surfaces/tile_table.h"
#include "support/effort.h"
#include "support/models/drawable_models.h"
#include "support/pictures/picture_file.h"

namespace temblor::render_gl {
namespace {

// Draws with a card whose textures are small, and on the CPU.
class SmallCard : public testing::Test {
 protected:
  void SetUp() override {
    auto made = InjectedGl::make();
    if (!made.ok()) GTEST_SKIP() << "no OpenGL: " << made.error().what;
    card_ = std::move(made).value();
  }
  void TearDown() override { renderer_.reset(); }

  void limit_textures(GLint side, GLint layers = 256) {
    card_->faults.integers[GL_MAX_TEXTURE_SIZE] = side;
    card_->faults.integers[GL_MAX_ARRAY_TEXTURE_LAYERS] = layers;
    renderer_ = std::make_unique<GlRenderer>(
        GlRenderer::make(card_->finder(), level_.palette, level_.colormap).value());
  }
  // The mean difference of the channels from the CPU's picture, 0 to 255.
  double find_difference(const render::Scene& scene, const render::Settings& settings = {}) {
    render::FrameBuffer gl(320, 240, render::PixelFormat::kRgb), cpu(320, 240, render::PixelFormat::kRgb);
    const auto drawn = renderer_->render(scene, settings, gl);
    EXPECT_TRUE(drawn.ok()) << drawn.error().what;
    cpu_.render(scene, settings, cpu);
    const std::string name = "limits-" + std::to_string(picture_count_++);
    test::show_picture(name + "-cpu", cpu, level_.palette);
    test::show_picture(name + "-gl", gl, level_.palette);
    double sum = 0;
    for (std::size_t i = 0; i < gl.pixel_count(); ++i)
      for (const int shift : {0, 8, 16})
        sum += std::abs(static_cast<int>(gl.rgb()[i] >> shift & 255) -
                        static_cast<int>(cpu.rgb()[i] >> shift & 255));
    return sum / 3 / static_cast<double>(gl.pixel_count());
  }

  const test::DrawableLevel level_ = test::small_level();
  render::Renderer cpu_{level_.palette, level_.colormap};
  std::unique_ptr<InjectedGl> card_;
  std::unique_ptr<GlRenderer> renderer_;
  int picture_count_ = 0;
};

TEST(TextureLimits, HalvesSidesUntilTheyFit) {
  EXPECT_EQ(count_halvings(2048, 16, 2048), 0);
  EXPECT_EQ(count_halvings(2049, 16, 2048), 1);
  EXPECT_EQ(count_halvings(16, 8192, 1024), 3);
  const std::vector<int> picture = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
  EXPECT_EQ(halve_picture(picture.data(), 5, 3, 0), picture);
  EXPECT_EQ(halve_picture(picture.data(), 5, 3, 1), (std::vector<int>{0, 2}));
  EXPECT_EQ(halve_picture(picture.data(), 5, 3, 5), (std::vector<int>{0}));
}

TEST_F(SmallCard, DrawsLevelsFromSmallLayers) {
  for (const GLint side : {2048, 1024}) {
    limit_textures(side);
    for (int number = 0; number < test::effort(10, 2); ++number) {
      test::Random random(static_cast<std::uint64_t>(number));
      const SceneView view = any_view(*level_.level, random);
      EXPECT_LE(find_difference(view.scene), 0.2) << side << ", " << number;
    }
  }
}

// The two layers do not hold the surfaces of a frame at this level of detail.
TEST_F(SmallCard, DrawsInPortionsIfLayersAreFew) {
  limit_textures(1024, 2);
  for (int number = 0; number < test::effort(10, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const SceneView view = any_view(*level_.level, random);
    EXPECT_LE(find_difference(view.scene, {.force_mip = 0}), 0.2) << number;
  }
}

TEST_F(SmallCard, DrawsLargeSkyboxesSmaller) {
  limit_textures(1024);
  for (int number = 0; number < 2; ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    render::Skybox skybox;
    const std::uint32_t size = 1024u << number % 2;
    for (formats::Image& side : skybox.sides) {
      side = {.width = size, .height = size, .pixels = {}};
      for (std::uint32_t i = 0; i < size * size; ++i)
        side.pixels.push_back(0xff000000u | i % size * 255 / size << 8 | i / size * 255 / size);
    }
    SceneView view = any_sky_view(*level_.level, random);
    view.scene.skybox = &skybox;
    EXPECT_LE(find_difference(view.scene), 2) << number;
  }
}

TEST_F(SmallCard, DrawsLargeSkinsSmaller) {
  formats::Mdl mdl = test::box_mdl();
  constexpr std::uint32_t kScale = 64;
  for (auto& texel : mdl.texels) {
    texel.s *= static_cast<std::int32_t>(kScale);
    texel.t *= static_cast<std::int32_t>(kScale);
  }
  mdl.scale *= 40.0f / 255;
  mdl.origin *= 40.0f / 255;
  mdl.skin_width *= kScale;
  mdl.skin_height *= kScale;
  std::vector<std::uint8_t> picture(std::size_t{mdl.skin_width} * mdl.skin_height);
  for (std::size_t i = 0; i < picture.size(); ++i)
    picture[i] = static_cast<std::uint8_t>(i % mdl.skin_width / 512 * 37 + i / mdl.skin_width / 512 * 101);
  mdl.skins = {{{picture}, {}}, {{picture}, {}}, {{picture}, {}}};
  const ModelPtr model = render::make_alias_model(mdl, "large");
  for (const GLint layers : {256, 2}) {
    limit_textures(1024, layers);
    for (int number = 0; number < test::effort(6, 2); ++number) {
      test::Random random(static_cast<std::uint64_t>(number));
      const ModelScene scene = random_scene({model}, *level_.level, 4, random);
      EXPECT_LE(find_difference(scene.scene(*level_.level)), 2) << layers << ", " << number;
    }
  }
}

TEST_F(SmallCard, DrawsLargeSpritesSmaller) {
  limit_textures(1024);
  test::Random random(3);
  SceneView view = any_view(*level_.level, random);
  formats::SprPicture picture{-2048, 2048, 4096, 4000, {}};
  for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
    picture.texels.push_back(static_cast<std::uint8_t>(i % 4096 / 512 * 16 + i / 4096 / 512));
  const formats::Spr sprite{.orientation = formats::SprOrientation::kParallel, .frames = {{{picture}, {}}}};
  const render::SpriteInstance instance{.sprite = &sprite,
                                        .picture = &sprite.frames[0].pictures[0],
                                        .origin_world = point_in_view(view.scene, 60, 0.1, random),
                                        .angles_deg = {},
                                        .scale = 0.01f};
  view.scene.sprites = {&instance, 1};
  EXPECT_LE(find_difference(view.scene), 1);
}

TEST_F(SmallCard, RefusesPicturesThatAreTooLarge) {
  limit_textures(1024);
  test::Random random(3);
  const SceneView view = any_view(*level_.level, random);
  render::FrameBuffer frame(1025, 16, render::PixelFormat::kRgb);
  const auto drawn = renderer_->render(view.scene, {}, frame);
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().what, "the graphics card draws pictures of up to 1024x1024 pixels, not 1025x16");
}

TEST_F(SmallCard, KeepsImagesThatAreLargerThanALayer) {
  limit_textures(1024);
  const Functions gl = load_functions(card_->finder()).value();
  for (const auto format : {TexelFormat::k32Bit, TexelFormat::k16Bit}) {
    BlockAtlas atlas = BlockAtlas::make(gl, {.format = format}).value();
    const std::vector<std::uint32_t> texels(std::size_t{4096} * 1000);
    const auto stored = atlas.place(gl, {1, texels.data(), {4096, 1000}});
    ASSERT_TRUE(stored);
    EXPECT_EQ(stored->shape.width, 1024);
    EXPECT_TRUE(gl.check("placing").ok());
  }
}

TEST_F(SmallCard, KeepsAsManyTilesAsATextureHasRowsFor) {
  limit_textures(1024);
  const Functions gl = load_functions(card_->finder()).value();
  TileTable table;
  for (const std::uint32_t count : {100u, 600'000u, 700'000u}) {
    ASSERT_TRUE(table.reserve(gl, count).ok());
    table.set(count - 1, {.place = 1});
    table.upload(gl);
    EXPECT_TRUE(gl.check("loading tiles").ok());
  }
  EXPECT_EQ(table.capacity(), 1024u * TileTable::kRecordsPerRow);
}

}  // namespace
}  // namespace temblor::render_gl
