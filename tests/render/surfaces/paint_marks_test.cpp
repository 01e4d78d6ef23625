// Marks: where they are on a face, that they look the same on all tiles and mip levels, and what they cost.
#include "render/surfaces/paint_marks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/edges/face_outlines.h"
#include "render/renderer.h"
#include "render/surfaces/build_surface.h"
#include "render/view/view_frame.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/picture_file.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

using render::Mark;
using render::MarkKind;
using render::PixelFormat;

constexpr std::uint8_t kGray = 200;
constexpr std::uint32_t kGrayRgb = 0xffc8c8c8u;

// A palette of grays with some reds; the last 32 are full-bright.
DrawableLevel gray_level(std::int32_t mins, std::int32_t extent, double texels_per_unit) {
  world::Level level;
  world::Texture texture{};
  texture.width = texture.height = 16;
  for (std::uint32_t mip = 0; mip < 4; ++mip) texture.mips[mip].assign((16u >> mip) * (16u >> mip), kGray);
  level.textures.push_back(texture);
  level.planes.push_back({{0, 0, 1}, 0, 2});
  const auto scale = static_cast<float>(texels_per_unit);
  level.texture_axes.push_back({{scale, 0, 0}, 0, {0, scale, 0}, 0});
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.style_count = 1;
  face.texture_mins = {mins, mins};
  face.texture_extents = {extent, extent};
  level.faces.push_back(face);
  level.light.assign(static_cast<std::size_t>(face.light_width() * face.light_height()), 128);
  DrawableLevel drawable{"gray", std::make_shared<const world::Level>(std::move(level)), {}, {}};
  for (std::size_t i = 0; i < 256; ++i) {
    const auto value = static_cast<std::uint8_t>(i);
    drawable.palette[i] = i % 4 == 1 ? formats::Rgb{value, 0, 0} : formats::Rgb{value, value, value};
  }
  for (std::size_t i = 0; i < drawable.colormap.rows.size(); ++i)
    drawable.colormap.rows[i] = static_cast<std::uint8_t>(i);
  drawable.colormap.fullbrights = 32;
  return drawable;
}

struct Block {
  render::SurfaceShape shape;
  std::vector<std::uint32_t> texels;  // 0xffRRGGBB in both formats
  std::uint32_t at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.width) +
                  static_cast<std::size_t>(x)];
  }
};

Block build(const DrawableLevel& drawable, std::span<const Mark> marks, PixelFormat format, int mip,
            int tile = 0) {
  // All of these levels have the same palette.
  static const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  static const render::MarkTables look(tables);
  const render::SurfaceShape shape = render::surface_shape(drawable.level->faces[0], tile, 0, mip);
  std::vector<std::byte> bytes(shape.texels() * 4 + render::kBlockPadding);
  render::BlockRequest request{};
  request.tile_s = static_cast<std::uint16_t>(tile);
  request.mip = mip;
  request.contents.style_values[0] = 256;
  request.marks = marks;
  request.block = {bytes.data(), shape};
  base::Arena scratch;
  render::build_surface(*drawable.level, tables, &look, request, format, true, scratch);
  Block block{shape, std::vector<std::uint32_t>(shape.texels())};
  for (std::size_t i = 0; i < shape.texels(); ++i) {
    if (format == PixelFormat::kIndexed) {
      block.texels[i] = render::to_rgb(drawable.palette[static_cast<std::size_t>(bytes[i])]);
    } else {
      std::memcpy(&block.texels[i], &bytes[i * 4], 4);
    }
  }
  return block;
}

double green(std::uint32_t color) {
  return static_cast<double>(color >> 8 & 255);
}

constexpr auto kKinds = {MarkKind::kBulletHole, MarkKind::kScorch, MarkKind::kSplatter};
constexpr auto kFormats = {PixelFormat::kIndexed, PixelFormat::kRgb};

Mark any_mark(MarkKind kind, Random& random) {
  return {.kind = kind,
          .position_model = {static_cast<float>(random.uniform(20, 100)),
                             static_cast<float>(random.uniform(20, 100)), 3},
          .radius = static_cast<float>(random.uniform(3, 60)),
          .seed = static_cast<std::uint32_t>(random.bits())};
}

TEST(Marks, CoverAPartOfTheirCircleAndNothingElse) {
  for (const double texels_per_unit : {0.5, 1.0, 3.0})
    for (const PixelFormat format : kFormats)
      for (const MarkKind kind : kKinds)
        for (int seed = 0; seed < 20; ++seed) {
          Random random(static_cast<std::uint64_t>(seed));
          const DrawableLevel drawable = gray_level(0, 256, texels_per_unit);
          const Mark mark = any_mark(kind, random);
          const Block block = build(drawable, {&mark, 1}, format, 0);
          std::size_t inside = 0, covered = 0;
          for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
              const double away_x = (x + 0.5) / texels_per_unit - static_cast<double>(mark.position_model.x);
              const double away_y = (y + 0.5) / texels_per_unit - static_cast<double>(mark.position_model.y);
              const double away = std::sqrt(away_x * away_x + away_y * away_y);
              if (away > static_cast<double>(mark.radius) * 1.05 + 1.5 / texels_per_unit) {
                ASSERT_EQ(block.at(x, y), kGrayRgb) << x << ", " << y;
                continue;
              }
              ++inside;
              covered += block.at(x, y) != kGrayRgb;
            }
          if (inside < 30) continue;
          EXPECT_GT(covered, inside / 20);
          EXPECT_LT(covered, inside);
        }
}

// The same marks on the same texels, cut into tiles in another way.
TEST(Marks, CrossTheBordersOfTiles) {
  const DrawableLevel first = gray_level(0, 512, 1), shifted = gray_level(128, 256, 1);
  for (int seed = 0; seed < 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<Mark> marks;
    for (const MarkKind kind : kKinds) {
      marks.push_back(any_mark(kind, random));
      marks.back().position_model = {256 + static_cast<float>(random.uniform(-30, 30)), 160, 0};
    }
    for (int mip = 0; mip < 4; ++mip) {
      const Block left = build(first, marks, PixelFormat::kRgb, mip, 0);
      const Block right = build(first, marks, PixelFormat::kRgb, mip, 1);
      const Block across = build(shifted, marks, PixelFormat::kRgb, mip, 0);
      const int half = 128 >> mip;
      for (int y = 0; y < across.shape.height; ++y)
        for (int x = 0; x < across.shape.width; ++x) {
          if (y + half >= left.shape.height) break;
          const std::uint32_t there = x < half ? left.at(x + half, y + half) : right.at(x - half, y + half);
          for (const int shift : {0, 8, 16})  // positions are rounded
            ASSERT_NEAR(across.at(x, y) >> shift & 255, there >> shift & 255, 2)
                << mip << ": " << x << ", " << y;
        }
    }
  }
}

// At each mip level, a texel is nearly the mean of the texels of mip 0 under it, and the whole is as dark as
// at mip 0.
TEST(Marks, LookAlikeOnEveryMipLevel) {
  const DrawableLevel drawable = gray_level(0, 256, 2);
  for (const MarkKind kind : kKinds)
    for (int seed = 0; seed < 20; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      Mark mark = any_mark(kind, random);
      mark.radius = static_cast<float>(random.uniform(8, 50));
      const Block full = build(drawable, {&mark, 1}, PixelFormat::kRgb, 0);
      double all_full = 0;
      for (const std::uint32_t texel : full.texels) all_full += kGray - green(texel);
      for (int mip = 1; mip < 4; ++mip) {
        SCOPED_TRACE(fmt::format("kind {}, seed {}, mip {}", static_cast<int>(kind), seed, mip));
        const Block block = build(drawable, {&mark, 1}, PixelFormat::kRgb, mip);
        const int side = 1 << mip;
        double all = 0, squares = 0, dark_squares = 0;
        for (int y = 0; y < block.shape.height; ++y)
          for (int x = 0; x < block.shape.width; ++x) {
            double mean = 0;
            for (int i = 0; i < side * side; ++i)
              mean += green(full.at(x * side + i % side, y * side + i / side)) / (side * side);
            const double here = green(block.at(x, y));
            squares += (here - mean) * (here - mean);
            dark_squares += (kGray - mean) * (kGray - mean);
            all += (kGray - here) * side * side;
          }
        EXPECT_NEAR(all / all_full, 1, 0.1);
        EXPECT_LT(std::sqrt(squares / dark_squares), 0.35);
      }
    }
}

// The floor of gray_level() is seen from above: x is to the right, y up.
Mark picture_on_floor(const formats::Image& image, const math::Vec3& center, float radius) {
  Mark mark{.kind = MarkKind::kPicture, .position_model = center, .radius = radius};
  mark.picture = std::make_shared<const render::MarkPicture>(image);
  mark.up_model = {0, 1, 0};
  return mark;
}

formats::Image random_image(std::uint32_t width, std::uint32_t height, Random& io_random) {
  formats::Image image{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    image.pixels.push_back(static_cast<std::uint32_t>(io_random.bits()) | 0xff000000u);
  return image;
}

std::uint32_t blended(std::uint32_t over, std::uint32_t under, double opacity, int shift) {
  const double mean = static_cast<double>(over >> shift & 255) * opacity +
                      static_cast<double>(under >> shift & 255) * (1 - opacity);
  return static_cast<std::uint32_t>(std::lround(mean));
}

// There are as many texels as pixels, so every pixel is seen exactly as it is in the file.
TEST(MarkPictures, ShowEveryPixel) {
  for (const auto& [width, height] : {std::pair{64u, 64u}, {50u, 20u}, {7u, 36u}}) {
    Random random(width);
    formats::Image image = random_image(width, height, random);
    for (std::uint32_t& pixel : image.pixels)
      pixel &= 0xffffffu | static_cast<std::uint32_t>(random.below(3) * 0x7f) << 24;
    const DrawableLevel drawable = gray_level(0, 256, 1);
    const auto longer = static_cast<float>(std::max(width, height));
    // Even sides lie around a corner of texels, odd ones around the middle of one.
    const math::Vec3 center(100 + static_cast<float>(width % 2) / 2, 90 + static_cast<float>(height % 2) / 2,
                            0);
    const Mark mark = picture_on_floor(image, center, longer / 2);
    const Block block = build(drawable, {&mark, 1}, PixelFormat::kRgb, 0);
    const int left = 100 - static_cast<int>(width) / 2, bottom = 90 - static_cast<int>(height) / 2;
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const int column = x - left, row = static_cast<int>(height) - 1 - (y - bottom);
        std::uint32_t pixel = 0;
        if (column >= 0 && row >= 0 && column < static_cast<int>(width) && row < static_cast<int>(height))
          pixel = image.pixels[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)];
        const double opacity = static_cast<double>(pixel >> 24) / 255;
        for (const int shift : {0, 8, 16})
          ASSERT_NEAR(block.at(x, y) >> shift & 255, blended(pixel, kGrayRgb, opacity, shift), 2)
              << width << " x " << height << ": " << x << ", " << y;
      }
  }
}

TEST(MarkPictures, ShowTheNearestColorsOfThePalette) {
  Random random(3);
  const formats::Image image = random_image(32, 32, random);
  const DrawableLevel drawable = gray_level(0, 64, 1);
  const Mark mark = picture_on_floor(image, {32, 32, 0}, 16);
  const Block block = build(drawable, {&mark, 1}, PixelFormat::kIndexed, 0);
  const auto distance = [](std::uint32_t a, formats::Rgb b) {
    const int r = static_cast<int>(a >> 16 & 255) - b.r, g = static_cast<int>(a >> 8 & 255) - b.g,
              blue = static_cast<int>(a & 255) - b.b;
    return r * r + g * g + blue * blue;
  };
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const std::uint32_t pixel = image.pixels[static_cast<std::size_t>((31 - y) * 32 + x)];
      int least = 1 << 30;
      for (int i = 0; i < 224; ++i)
        least = std::min(least, distance(pixel, drawable.palette[static_cast<std::size_t>(i)]));
      const std::uint32_t shown = block.at(16 + x, 16 + y);
      const formats::Rgb color{static_cast<std::uint8_t>(shown >> 16 & 255),
                               static_cast<std::uint8_t>(shown >> 8 & 255),
                               static_cast<std::uint8_t>(shown & 255)};
      ASSERT_EQ(distance(pixel, color), least) << x << ", " << y;
    }
}

TEST(MarkPictures, LookAlikeOnEveryMipLevel) {
  // Smooth, so that a texel of a mip level is the mean of those under it.
  formats::Image image{128, 128, {}};
  for (std::uint32_t y = 0; y < 128; ++y)
    for (std::uint32_t x = 0; x < 128; ++x) image.pixels.push_back(0xff000000u | x << 17 | y << 9 | 40);
  const DrawableLevel drawable = gray_level(0, 256, 1);
  const Mark mark = picture_on_floor(image, {128, 128, 0}, 64);
  const Block full = build(drawable, {&mark, 1}, PixelFormat::kRgb, 0);
  for (int mip = 1; mip < 4; ++mip) {
    const Block block = build(drawable, {&mark, 1}, PixelFormat::kRgb, mip);
    const int side = 1 << mip, first = 64 / side + 1, last = 192 / side - 1;
    for (int y = first; y < last; ++y)
      for (int x = first; x < last; ++x) {
        double mean = 0;
        for (int i = 0; i < side * side; ++i)
          mean += green(full.at(x * side + i % side, y * side + i / side)) / (side * side);
        ASSERT_NEAR(green(block.at(x, y)), mean, 3) << mip << ": " << x << ", " << y;
      }
  }
}

// The face lies in the plane that the upper edge points out of.
TEST(MarkPictures, WithoutADirectionAreNone) {
  const DrawableLevel drawable = gray_level(0, 64, 1);
  Mark mark = picture_on_floor({1, 1, {0xffff0000u}}, {30, 30, 0}, 20);
  for (const math::Vec3& up : {math::Vec3(0, 0, 1), math::Vec3(0), math::Vec3(std::nanf(""))}) {
    mark.up_model = up;
    for (const std::uint32_t texel : build(drawable, {&mark, 1}, PixelFormat::kRgb, 0).texels)
      ASSERT_EQ(texel, kGrayRgb);
  }
}

// Both formats keep the holes of a grating.
TEST(Marks, LeaveHolesOpen) {
  DrawableLevel drawable = gray_level(0, 64, 1);
  world::Level level = *drawable.level;
  level.textures[0].kind = world::TextureKind::kCutout;
  for (auto& mip : level.textures[0].mips)
    for (std::size_t i = 0; i < mip.size(); i += 2) mip[i] = 255;
  drawable.level = std::make_shared<const world::Level>(level);
  const std::vector<Mark> marks = {{.position_model = {30, 30, 0}, .radius = 25},
                                   picture_on_floor({1, 1, {0xffff0000u}}, {30, 30, 0}, 20)};
  const std::uint32_t clear = render::to_rgb(drawable.palette[255]);
  for (const PixelFormat format : kFormats) {
    const Block block = build(drawable, marks, format, 0);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; x += 2) ASSERT_EQ(block.at(x, y), format == PixelFormat::kRgb ? 0 : clear);
    EXPECT_NE(block.at(31, 30), kGrayRgb);
  }
}

TEST(Marks, WithSeedsOfTheirOwnLookDifferent) {
  const DrawableLevel drawable = gray_level(0, 256, 1);
  for (const MarkKind kind : kKinds) {
    const Mark first{.kind = kind, .position_model = {100, 100, 0}, .radius = 30, .seed = 1};
    Mark second = first;
    second.seed = 2;
    const Block one = build(drawable, {&first, 1}, PixelFormat::kRgb, 0);
    EXPECT_EQ(one.texels, build(drawable, {&first, 1}, PixelFormat::kRgb, 0).texels);
    EXPECT_NE(one.texels, build(drawable, {&second, 1}, PixelFormat::kRgb, 0).texels);
  }
}

TEST(Marks, NeverGlow) {
  const DrawableLevel drawable = gray_level(0, 16, 1);
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  const render::MarkTables look(tables);
  for (const MarkKind kind : kKinds)
    for (float opacity = 0; opacity <= 1; opacity += 1.0f / 64)
      for (const float shade : {0.0f, 0.4f, 1.0f})
        for (int index = 0; index < 256; ++index) {
          const auto under = static_cast<std::uint8_t>(index);
          const int out = look.over(kind, {opacity, shade}, under);
          const std::uint32_t out_rgb = look.over(kind, {opacity, shade}, tables.surface_rgb[under]);
          if (index < tables.first_fullbright || opacity > 0.54f) {
            ASSERT_LT(out, tables.first_fullbright);
            ASSERT_EQ(out_rgb >> 24, 255u);
          }
        }
}

TEST(Marks, OfNonsenseAreNone) {
  const float infinity = std::numeric_limits<float>::infinity(),
              none = std::numeric_limits<float>::quiet_NaN();
  DrawableLevel drawable = gray_level(0, 64, 1);
  for (const float number : {none, infinity, -infinity, 1e38f}) {
    const Mark mark{.position_model = {number, 20, 0}, .radius = 9};
    for (const std::uint32_t texel : build(drawable, {&mark, 1}, PixelFormat::kRgb, 0).texels)
      ASSERT_EQ(texel, kGrayRgb);
  }
  world::Level flat = *drawable.level;
  flat.texture_axes[0].t_axis = flat.texture_axes[0].s_axis;
  drawable.level = std::make_shared<const world::Level>(flat);
  const Mark mark{.position_model = {20, 20, 0}, .radius = 9};
  for (const std::uint32_t texel : build(drawable, {&mark, 1}, PixelFormat::kRgb, 0).texels)
    ASSERT_EQ(texel, kGrayRgb);
}

render::FrameStats draw(render::Renderer& io_renderer, const render::Scene& scene,
                        render::FrameBuffer& io_frame) {
  return io_renderer.render(scene, {}, io_frame);
}

// Marks at the pixels of a frame: each on the face and at the point that the pixel shows.
void add_marks_in_sight(const render::Renderer& renderer, const render::Scene& scene,
                        const render::FrameBuffer& frame, int count, float max_radius, Random& io_random,
                        render::MarkSet& io_marks) {
  const render::ViewFrame view = render::make_view_frame(scene, frame.width(), frame.height());
  std::vector<render::PixelFace> faces(frame.pixel_count());
  std::vector<std::uint8_t> writes(frame.pixel_count());
  renderer.pixel_faces(faces, writes);
  for (int i = 0; i < count; ++i) {
    const std::size_t pixel = io_random.below(frame.pixel_count());
    if (faces[pixel].instance != 0) continue;
    const auto width = static_cast<std::size_t>(frame.width());
    const double z = 1 / static_cast<double>(frame.depth()[pixel]);
    const double x = (static_cast<double>(pixel % width) - view.center_x) * z / view.pixels_per_unit;
    const double y = (view.center_y - static_cast<double>(pixel / width)) * z / view.pixels_per_unit;
    const math::Vec3d point = view.eye_world + view.axes.forward * z + view.axes.right * x + view.axes.up * y;
    const auto kind = static_cast<MarkKind>(i % 3);
    io_marks.add(world::FaceIndex{faces[pixel].face},
                 {.kind = kind,
                  .position_model = math::Vec3(point),
                  .radius = kind == MarkKind::kBulletHole ? std::min(3.0f, max_radius) : max_radius,
                  .seed = static_cast<std::uint32_t>(io_random.bits())});
  }
}

class MarksOnStockLevel : public testing::TestWithParam<const char*> {};
TEST_P(MarksOnStockLevel, CostOnceAndLieWhereTheyWereMade) {
  DATA_FOLDER_OR_SKIP(data);
  const DrawableLevel drawable = stock_level(data, GetParam());
  const std::vector<render::Camera> cameras = player_cameras(*drawable.level);
  for (std::size_t number = 0; number < std::min<std::size_t>(cameras.size(), 3); ++number) {
    Random random(number);
    const Viewpoint viewpoint{.camera = cameras[number], .brush_models = shown_brush_models(*drawable.level)};
    render::Scene scene = viewpoint.scene(*drawable.level);
    scene.light_styles = world::make_stored_light_styles();
    for (const PixelFormat format : kFormats) {
      render::Renderer renderer(drawable.palette, drawable.colormap);
      render::FrameBuffer frame(800, 600, format);
      draw(renderer, scene, frame);
      const FrameCopy before = copy_picture(frame);
      render::MarkSet marks;
      add_marks_in_sight(renderer, scene, frame, 60, 20, random, marks);
      scene.marks = &marks;
      EXPECT_GT(draw(renderer, scene, frame).surfaces_built, 0u);
      const FrameCopy marked = copy_picture(frame);
      EXPECT_GT(differing_pixels(before, marked), 2000u);
      show_picture(fmt::format("marks-{}-{}-{}", GetParam(), number,
                               format == PixelFormat::kIndexed ? "indexed" : "rgb"),
                   frame, drawable.palette);
      EXPECT_EQ(draw(renderer, scene, frame).surfaces_built, 0u) << "marks that stay cost nothing";
      // Dropped blocks are rebuilt identically.
      renderer.drop_surfaces();
      draw(renderer, scene, frame);
      EXPECT_TRUE(copy_picture(frame) == marked);
      scene.marks = nullptr;
      draw(renderer, scene, frame);
      EXPECT_TRUE(copy_picture(frame) == before);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Levels, MarksOnStockLevel, testing::Values("start", "lq_e0m1", "lq_e1m2"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Marks, OfAFaceBuildThatFaceOnly) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::FrameBuffer frame(320, 200, PixelFormat::kRgb);
  std::size_t with_a_mark = 0;
  for (int number = 0; number < 30; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random)};
    render::Scene scene = viewpoint.scene(*drawable.level);
    draw(renderer, scene, frame);
    render::MarkSet marks;
    add_marks_in_sight(renderer, scene, frame, 1, 10, random, marks);
    scene.marks = &marks;
    const std::uint32_t built = draw(renderer, scene, frame).surfaces_built;
    EXPECT_LE(built, marks.size());  // this level's faces are of one tile; sky and liquids have none
    with_a_mark += built;
    EXPECT_EQ(draw(renderer, scene, frame).surfaces_built, 0u);
  }
  EXPECT_GT(with_a_mark, 10u);
}

// Marks are lit like their face: in the dark they are invisible.
TEST(Marks, AreLitLikeTheirFace) {
  DrawableLevel drawable = gray_level(0, 64, 1);
  world::Level dark = *drawable.level;
  dark.light.assign(dark.light.size(), 0);
  drawable.level = std::make_shared<const world::Level>(dark);
  const Mark mark{.kind = MarkKind::kSplatter, .position_model = {30, 30, 0}, .radius = 20};
  for (const std::uint32_t texel : build(drawable, {&mark, 1}, PixelFormat::kRgb, 0).texels)
    ASSERT_EQ(texel, 0xff000000u);
}

}  // namespace
}  // namespace temblor::test
