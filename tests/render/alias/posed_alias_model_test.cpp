// Models with 16-bit positions: an MDL file converted to MD3 or MD5 has the picture of the MDL file, and
// joined skins show what each mesh's own skin does.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "render/alias/alias_mesh.h"
#include "render/alias/mesh/skin_atlas.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/pictures/frames.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using ModelPtr = std::shared_ptr<const render::AliasModel>;

formats::PosedModel add_skins(const formats::Mdl& mdl, formats::PosedModel model) {
  for (const formats::MdlSkin& skin : mdl.skins) {
    formats::PosedSkin& posed = model.skins.emplace_back();
    posed.end_times_s = skin.end_times_s;
    for (const auto& pixels : skin.pictures)
      posed.pictures.push_back({{mdl.skin_width, mdl.skin_height, pixels}});
  }
  return model;
}

ModelPtr make_md3_model(const formats::Mdl& mdl) {
  const formats::Md3 md3 = formats::read_md3(write_md3(convert_to_md3(mdl, "skin"))).value();
  return render::make_alias_model(add_skins(mdl, formats::pose_md3(md3).value()), "md3").value();
}

ModelPtr make_md5_model(const formats::Mdl& mdl) {
  const Md5Sample sample = convert_to_md5(mdl, "skin");
  auto posed = formats::pose_md5(formats::read_md5_model(sample.mesh).value(),
                                 formats::read_md5_animation(sample.animation).value());
  return render::make_alias_model(add_skins(mdl, std::move(posed).value()), "md5").value();
}

// Draws two poses of the model, blended, full-bright: the conversions keep no normals.
FrameCopy draw(render::Renderer& io_renderer, const render::AliasModel& model, render::AliasInstance instance,
               const render::Scene& empty, const render::Settings& settings, render::PixelFormat format) {
  instance.model = &model;
  instance.full_bright = true;
  instance.to_pose = render::pose_at(model, 1, 0);
  render::Scene scene = empty;
  scene.alias_models = {&instance, 1};
  render::FrameBuffer frame(320, 200, format);
  io_renderer.render(scene, settings, frame);
  return copy_picture(frame);
}

// Conversions are exact, and multiples of a power of two round like the bytes that they were, so not even a
// bit differs.
TEST(PosedAliasModel, HasThePictureOfTheMdlFile) {
  const formats::Mdl mdl = many_pose_mdl(3);
  const ModelPtr from_mdl = render::make_alias_model(mdl, "mdl");
  const ModelPtr from_md3 = make_md3_model(mdl), from_md5 = make_md5_model(mdl);
  EXPECT_FALSE(from_mdl->is_wide());
  EXPECT_TRUE(from_md3->is_wide() && from_md5->is_wide());
  const DrawableLevel drawable = small_level({.pvs = false});
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::Scene scene;
  scene.level = drawable.level.get();
  std::size_t drawn = 0;
  for (int seed = 0; seed < effort(24, 6); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    scene.camera.origin_world = math::Vec3(0, 0, 20000);
    render::AliasInstance instance;
    // Near ones are clipped, far ones are subdivided.
    const auto distance = static_cast<float>(random.log_uniform(60, 6000));
    instance.origin_world = scene.camera.origin_world + math::Vec3(distance, 0, 0);
    instance.angles_deg = random.in_cube(180);
    instance.blend = static_cast<float>(random.uniform(0, 1));
    for (const bool simd : {false, true})
      for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
        const render::Settings settings{.simd_kernels = simd};
        const FrameCopy expected = draw(renderer, *from_mdl, instance, scene, settings, format);
        EXPECT_EQ(differing_pixels(expected, draw(renderer, *from_md3, instance, scene, settings, format)),
                  0u);
        EXPECT_EQ(differing_pixels(expected, draw(renderer, *from_md5, instance, scene, settings, format)),
                  0u);
        drawn += differing_pixels(
            expected, draw(renderer, *from_mdl, {.origin_world = {0, 0, 0}}, scene, settings, format));
      }
  }
  EXPECT_GT(drawn, 10000u);
}

// The scales of stock files are no powers of two, so rounding moves vertices by a fraction of a pixel.
TEST(PosedAliasModel, StockFilesAsMd5LookLikeTheirMdlFiles) {
  DATA_FOLDER_OR_SKIP(data);
  const DrawableLevel drawable = small_level({.pvs = false});
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::Scene scene;
  scene.level = drawable.level.get();
  scene.camera.origin_world = math::Vec3(0, 0, 20000);
  for (const char* name : {"ogre", "player", "v_rock", "armor"}) {
    SCOPED_TRACE(name);
    const formats::Mdl mdl =
        formats::read_mdl(read_file(data / "id1" / "progs" / (std::string(name) + ".mdl"))).value();
    const ModelPtr from_mdl = render::make_alias_model(mdl, name), from_md5 = make_md5_model(mdl);
    for (float yaw = 0; yaw < 360; yaw += 45) {
      render::AliasInstance instance;
      instance.origin_world = scene.camera.origin_world + math::Vec3(90, 0, 0);
      instance.angles_deg.y = yaw;
      const render::Settings settings;
      const auto format = render::PixelFormat::kIndexed;
      const FrameCopy expected = draw(renderer, *from_mdl, instance, scene, settings, format);
      const FrameCopy drawn = draw(renderer, *from_md5, instance, scene, settings, format);
      std::size_t covered = 0, different = 0;
      for (std::size_t i = 0; i < expected.indexed.size(); ++i) {
        covered += expected.depth_bits[i] != expected.depth_bits[0];
        different += expected.indexed[i] != drawn.indexed[i];
      }
      EXPECT_GT(covered, 100u);
      EXPECT_LT(static_cast<double>(different), 0.01 * static_cast<double>(covered));
    }
  }
}

TEST(PosedAliasModel, StoresPositionsWithinHalfAStep) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    formats::PosedModel posed;
    posed.pose_count = 3;
    posed.frames = {{0, 3, {0.1f, 0.2f, 0.3f}}};
    const auto size = static_cast<float>(random.log_uniform(0.1, 400000));
    const math::Vec3 middle = random.in_cube(size);
    for (int i = 0; i < 2; ++i) {
      formats::PosedMesh& mesh = posed.meshes.emplace_back();
      mesh.texels.resize(17, math::Vec2(0.5f));
      for (int vertex = 0; vertex < 3 * 17; ++vertex) mesh.positions.push_back(middle + random.in_cube(size));
      mesh.normals.resize(mesh.positions.size(), 7);
      mesh.triangles = {{0, 1, 2}};
    }
    posed.skins = {{{{{1, 1, {3}}, {1, 1, {4}}}}, {}}};
    const ModelPtr model = render::make_alias_model(posed, "random").value();
    EXPECT_EQ(model->vertex_count, 34u);
    EXPECT_EQ(model->pose_count(), 3u);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(model->scale[axis], size / 8192);
      int exponent = 0;
      EXPECT_EQ(std::frexp(model->scale[axis], &exponent), 0.5f) << "a power of two";
    }
    for (std::uint32_t number = 0; number < 3; ++number) {
      const render::WidePose pose = model->wide_pose(render::PoseIndex{number});
      for (std::size_t i = 0; i < 34; ++i) {
        const math::Vec3 stored = math::Vec3(pose.x[i], pose.y[i], pose.z[i]) * model->scale + model->origin;
        const math::Vec3 expected = posed.meshes[i / 17].positions[number * 17 + i % 17];
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_NEAR(stored[axis], expected[axis], model->scale[axis] * 0.51f);
          ASSERT_GE(stored[axis], model->bounds.mins[axis]);
          ASSERT_LE(stored[axis], model->bounds.maxs[axis]);
        }
        ASSERT_EQ(pose.normals[i], 7);
      }
    }
  }
}

formats::Picture random_picture(std::uint32_t width, std::uint32_t height, Random& io_random) {
  formats::Picture picture{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    picture.pixels.push_back(static_cast<std::uint8_t>(io_random.below(256)));
  return picture;
}

// By the definition: a skin repeats in both directions.
TEST(SkinAtlas, ShowsEachMeshItsSkin) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<formats::PosedMesh> meshes(1 + random.below(4));
    std::vector<formats::Picture> pictures;
    for (formats::PosedMesh& mesh : meshes) {
      const double size = random.chance(0.5) ? 1 : 3;
      const auto width = static_cast<std::uint32_t>(1 + random.below(20));
      pictures.push_back(random_picture(width, static_cast<std::uint32_t>(1 + random.below(20)), random));
      for (int i = 0; i < 30; ++i)
        mesh.texels.emplace_back(static_cast<float>(random.uniform(size == 1 ? 0 : -size, size)),
                                 static_cast<float>(random.uniform(size == 1 ? 0 : -size, size)));
    }
    const render::SkinAtlas atlas = render::make_skin_atlas(meshes, pictures).value();
    const std::vector<std::uint8_t> joined = render::join_pictures(atlas, pictures);
    ASSERT_EQ(joined.size(), std::size_t{atlas.width} * atlas.height);
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
      const formats::Picture& picture = pictures[mesh];
      const auto placed = render::place_texels(atlas.parts[mesh], meshes[mesh].texels);
      for (std::size_t i = 0; i < placed.size(); ++i) {
        const auto wrap = [](float coordinate, std::uint32_t size) {
          const double texel =
              (static_cast<double>(coordinate) - std::floor(static_cast<double>(coordinate))) * size;
          return std::pair(std::min(static_cast<std::uint32_t>(texel), size - 1), texel - std::floor(texel));
        };
        const auto [s, s_part] = wrap(meshes[mesh].texels[i].x, picture.width);
        const auto [t, t_part] = wrap(meshes[mesh].texels[i].y, picture.height);
        // Texels at the very edge may be moved inside.
        if (std::min(s_part, t_part) < 0.1 || std::max(s_part, t_part) > 0.9) continue;
        const auto column = static_cast<std::size_t>(placed[i].s),
                   row = static_cast<std::size_t>(placed[i].t);
        ASSERT_EQ(joined[row * atlas.width + column], picture.pixels[t * picture.width + s]);
      }
    }
  }
}

TEST(SkinAtlas, TexelsStayInsideOfTheirPart) {
  std::vector<formats::PosedMesh> meshes(2);
  meshes[0].texels = {{0, 0}, {1, 1}, {1.002f, -0.002f}};
  meshes[1].texels = {{-2, 3}, {0, 0}};
  const std::vector<formats::Picture> pictures(2, {4, 4, std::vector<std::uint8_t>(16)});
  const render::SkinAtlas atlas = render::make_skin_atlas(meshes, pictures).value();
  EXPECT_EQ(atlas.parts[0].columns, 1u);
  EXPECT_EQ(atlas.parts[0].rows, 1u);
  EXPECT_EQ(atlas.parts[1].columns, 2u);
  EXPECT_EQ(atlas.parts[1].rows, 3u);
  EXPECT_EQ(atlas.height, 4u + 12u);
  for (std::size_t mesh = 0; mesh < 2; ++mesh)
    for (const render::TexelPoint& texel : render::place_texels(atlas.parts[mesh], meshes[mesh].texels)) {
      const render::AtlasPart& part = atlas.parts[mesh];
      EXPECT_GT(texel.s, 0);
      EXPECT_LT(texel.s, static_cast<float>(part.width * part.columns));
      EXPECT_GT(texel.t, static_cast<float>(part.top));
      EXPECT_LT(texel.t, static_cast<float>(part.top + part.height * part.rows));
    }
}

TEST(SkinAtlas, TooManyRepetitionsAreAnError) {
  const std::vector<formats::Picture> pictures(1, {64, 64, std::vector<std::uint8_t>(64 * 64)});
  for (const math::Vec2& last : {math::Vec2(1 << 20, 1), math::Vec2(200, 200)}) {
    std::vector<formats::PosedMesh> meshes(1);
    meshes[0].texels = {{0, 0}, last};
    const auto atlas = render::make_skin_atlas(meshes, pictures);
    ASSERT_FALSE(atlas.ok());
    EXPECT_NE(atlas.error().what.find("the limits are 16384 texels for a side and 33554432 in all"),
              std::string::npos)
        << atlas.error().what;
  }
}

// A skin of another size covers the same part of the model.
TEST(SkinAtlas, ResamplesPicturesOfOtherSizes) {
  std::vector<formats::PosedMesh> meshes(1);
  meshes[0].texels = {{0, 0}, {1, 1}};
  const render::SkinAtlas atlas = render::make_skin_atlas(meshes, {{2, 2, {1, 2, 3, 4}}}).value();
  const std::vector<std::uint8_t> large = render::join_pictures(
      atlas, {{4, 4, {10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25}}});
  EXPECT_EQ(large, (std::vector<std::uint8_t>{10, 12, 18, 20}));
  EXPECT_EQ(render::join_pictures(atlas, {{1, 1, {9}}}), (std::vector<std::uint8_t>{9, 9, 9, 9}));
}

}  // namespace
}  // namespace temblor::test
