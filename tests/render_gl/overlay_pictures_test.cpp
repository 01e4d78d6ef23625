// The overlay on the graphics card, next to that of the CPU, and how the finished picture looks in a window.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include "platform/window.h"
#include "render/present.h"
#include "render/screen/draw_overlay.h"
#include "render_gl/gl_pictures.h"
#include "render_gl/injected_gl.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"
#include "support/pictures/frames.h"
#include "support/pictures/random_overlay.h"
#include "support/pictures/some_colors.h"

namespace temblor::render_gl {
namespace {

using render::PixelFormat;

// Pictures, and commands that draw them over all of a frame.
class RandomOverlay {
 public:
  RandomOverlay(int count, int width, int height, double detail_share, test::Random& random) {
    for (int i = 0; i < count; ++i) {
      Part& part = *parts_.emplace_back(std::make_unique<Part>());
      part.picture = test::random_picture(random);
      if (random.chance(detail_share)) test::add_detail(part.picture, random);
      part.translation = test::random_translation(random);
      part.tint = test::random_color_tint(random);
      part.tint.factor = {static_cast<std::uint8_t>(random.bits()), 255,
                          static_cast<std::uint8_t>(random.bits())};
    }
    // Something to blend with.
    for (const auto& part : parts_) {
      const formats::Picture& picture = part->picture;
      list.commands.push_back({.picture = &picture,
                               .area = {0, 0, width, height},
                               .part_width = static_cast<int>(picture.width),
                               .part_height = static_cast<int>(picture.height)});
    }
    for (int i = 0; i < 10 * count; ++i) {
      const Part& part = *parts_[random.below(parts_.size())];
      list.commands.push_back(test::random_command(part.picture, part.translation, random));
      test::decorate_command(list.commands.back(), part.tint, random);
    }
  }

  render::DrawList list;

 private:
  struct Part {
    formats::Picture picture;
    render::ColorTranslation translation;
    render::ColorTint tint;
  };
  std::vector<std::unique_ptr<Part>> parts_;
};

// The CPU's overlay over black.
render::FrameBuffer draw_on_cpu(const render::DrawList& list, const render::ColorTables& tables, int width,
                                int height, PixelFormat format) {
  render::FrameBuffer frame(width, height, format);
  std::ranges::fill(frame.rgb(), tables.rgb[0]);
  std::ranges::fill(frame.indexed(), std::uint8_t{0});
  render::draw_overlay(list, tables, nullptr, frame);
  return frame;
}

render::FrameBuffer draw_on_card(const render::DrawList& list, GlRenderer& gl, int width, int height,
                                 PixelFormat format) {
  render::FrameBuffer frame(width, height, format);
  const auto draw = [&]() -> base::Status {
    TRY_STATUS(gl.clear(frame));
    TRY_STATUS(gl.draw_overlay(list, frame));
    return gl.read(frame);
  };
  const base::Status drawn = draw();
  EXPECT_TRUE(drawn.ok()) << drawn.error().message();
  return frame;
}

double equal_pixels(const render::FrameBuffer& a, const render::FrameBuffer& b) {
  if (a.format() == PixelFormat::kRgb) return test::equal_share(a.rgb(), b.rgb(), 2);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.pixel_count(); ++i) equal += a.indexed()[i] == b.indexed()[i];
  return static_cast<double>(equal) / static_cast<double>(a.pixel_count());
}

class GlOverlay : public testing::TestWithParam<PixelFormat> {};
INSTANTIATE_TEST_SUITE_P(Formats, GlOverlay, testing::Values(PixelFormat::kIndexed, PixelFormat::kRgb));

TEST_P(GlOverlay, DrawsAnyCommandsAsTheCpuDoes) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  const render::ColorTables tables = render::make_color_tables(level.palette, level.colormap);
  for (int seed = 0; seed < test::effort(100, 8); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const int width = 1 + static_cast<int>(random.below(150)),
              height = 1 + static_cast<int>(random.below(120));
    // Indexed frames with details are the CPU's.
    const double detail_share = GetParam() == PixelFormat::kRgb ? 0.4 : seed % 4 == 0 ? 0.1 : 0.0;
    const RandomOverlay overlay(3, width, height, detail_share, random);
    const render::FrameBuffer expected = draw_on_cpu(overlay.list, tables, width, height, GetParam());
    const render::FrameBuffer got = draw_on_card(overlay.list, pair.gl(), width, height, GetParam());
    // Products double the rounding of colors that the card has blended.
    EXPECT_GE(equal_pixels(expected, got), GetParam() == PixelFormat::kRgb ? 0.998 : 1.0) << seed;
  }
}

// Large pictures at places where texels begin between pixels.
TEST_P(GlOverlay, FindsTexelsExactly) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  const render::ColorTables tables = render::make_color_tables(level.palette, level.colormap);
  for (int seed = 0; seed < test::effort(30, 5); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const auto side = [&random](std::size_t largest) { return 1 + static_cast<int>(random.below(largest)); };
    const int width = side(700), height = side(500);
    formats::Picture picture{
        static_cast<std::uint32_t>(side(900)), static_cast<std::uint32_t>(side(900)), {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height);
    for (std::uint8_t& pixel : picture.pixels) pixel = static_cast<std::uint8_t>(random.below(255));
    if (GetParam() == PixelFormat::kRgb && seed % 2 == 0) test::add_detail(picture, random);
    const render::DrawList list{{{.picture = &picture,
                                  .area = {side(200) - 100, side(200) - 100, side(9000), side(9000)},
                                  .part_width = side(picture.width),
                                  .part_height = side(picture.height)}}};
    EXPECT_EQ(equal_pixels(draw_on_cpu(list, tables, width, height, GetParam()),
                           draw_on_card(list, pair.gl(), width, height, GetParam())),
              1.0)
        << seed;
  }
}

// More sets of colors than the card's table has rows.
TEST_P(GlOverlay, HasAnyNumberOfTints) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  const render::ColorTables tables = render::make_color_tables(level.palette, level.colormap);
  test::Random random(1);
  constexpr int kSide = 55;
  std::vector<render::ColorTint> tints(kSide * kSide);
  render::DrawList list;
  for (int i = 0; i < kSide * kSide; ++i) {
    render::ColorTint& tint = tints[static_cast<std::size_t>(i)];
    tint.indices[7] = static_cast<std::uint8_t>(random.bits());
    tint.rgb[7] = static_cast<std::uint32_t>(random.bits()) | 0xff000000u;
    list.commands.push_back({.area = {i % kSide, i / kSide, 1, 1}, .fill = 7, .tint = &tint});
  }
  EXPECT_EQ(equal_pixels(draw_on_cpu(list, tables, kSide, kSide, GetParam()),
                         draw_on_card(list, pair.gl(), kSide, kSide, GetParam())),
            1.0);
}

// The pixels of a picture may change in place, and its memory may become that of another one.
TEST_P(GlOverlay, ShowsChangedPictures) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  const render::ColorTables tables = render::make_color_tables(level.palette, level.colormap);
  formats::Picture picture{8, 4, std::vector<std::uint8_t>(32, 3)};
  const auto expect_equal = [&] {
    const render::DrawList list{
        {{.picture = &picture,
          .area = {0, 0, static_cast<int>(picture.width), static_cast<int>(picture.height)}}}};
    EXPECT_EQ(equal_pixels(draw_on_cpu(list, tables, 8, 8, GetParam()),
                           draw_on_card(list, pair.gl(), 8, 8, GetParam())),
              1.0);
  };
  expect_equal();
  picture.pixels[5] = 9;
  expect_equal();
  std::swap(picture.width, picture.height);
  expect_equal();
  test::Random random(1);
  for (int i = 0; i < 3; ++i) {
    test::add_detail(picture, random);
    expect_equal();
  }
}

// Pictures of 64 MB and more are dropped when they are not drawn.
TEST(GlOverlayTextures, DropsPicturesThatAreNotDrawn) {
  INJECTED_GL_OR_SKIP(card);
  const test::DrawableLevel level = test::small_level();
  auto gl = GlRenderer::make(card.finder(), level.palette, level.colormap);
  ASSERT_TRUE(gl.ok());
  constexpr std::uint32_t kSide = 1024;
  const auto draw = [&] {
    const formats::Picture picture{kSide, kSide, std::vector<std::uint8_t>(std::size_t{kSide} * kSide, 3)};
    draw_on_card({{{.picture = &picture, .area = {0, 0, 1024, 1024}}}}, *gl, 16, 16, PixelFormat::kRgb);
  };
  draw();
  const std::uint64_t bytes = card.live_bytes();
  std::vector<std::vector<std::uint8_t>> others;  // so that pictures have different addresses
  for (int i = 0; i < 200; ++i) {
    draw();
    others.emplace_back(std::size_t{kSide} * kSide);
  }
  EXPECT_LT(card.live_bytes(), bytes + (std::uint64_t{70} << 20));
}

// Lets the card show a picture in a "window" that can be read: a framebuffer.
class ShownPicture {
 public:
  ShownPicture(const FunctionFinder& find, int width, int height)
      : gl_(load_functions(find).value()), width_(width), height_(height) {
    color_ = std::move(make_texture(gl_, GL_RGBA8, {width, height})).value();
    framebuffer_ = make_framebuffer(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
  }
  GLuint framebuffer() const { return framebuffer_.name(); }

  // 0xffRRGGBB, from the top row on, as the window shows it.
  std::vector<std::uint32_t> read() const {
    std::vector<std::array<std::uint8_t, 4>> pixels(static_cast<std::size_t>(width_) *
                                                    static_cast<std::size_t>(height_));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    std::vector<std::uint32_t> out;
    for (int y = height_ - 1; y >= 0; --y)
      for (int x = 0; x < width_; ++x) {
        const auto& [r, g, b, a] = pixels[static_cast<std::size_t>(y * width_ + x)];
        out.push_back(render::to_rgb({r, g, b}));
      }
    return out;
  }

 private:
  const Functions gl_;
  int width_, height_;
  Texture color_;
  Framebuffer framebuffer_;
};

// Where a pixel's color comes from, in doubles.
std::uint32_t stretch_at(const std::vector<std::uint32_t>& picture, int width, int height, double x,
                         double y) {
  const auto at = [&](double column, double row) {
    const int i = std::clamp(static_cast<int>(column), 0, width - 1),
              j = std::clamp(static_cast<int>(row), 0, height - 1);
    return picture[static_cast<std::size_t>(j * width + i)];
  };
  const double left = std::floor(x), top = std::floor(y);
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8) {
    const auto channel = [&](double column, double row) {
      return static_cast<double>(at(column, row) >> shift & 255);
    };
    const double above = std::lerp(channel(left, top), channel(left + 1, top), x - left);
    const double below = std::lerp(channel(left, top + 1), channel(left + 1, top + 1), x - left);
    out |= static_cast<std::uint32_t>(std::lround(std::lerp(above, below, y - top))) << shift;
  }
  return out;
}

// With and without a tone; in windows of the picture's size, and of others.
TEST_P(GlOverlay, ShowsThePictureInAWindow) {
  INJECTED_GL_OR_SKIP(card);
  const test::DrawableLevel level = test::small_level();
  auto gl = GlRenderer::make(card.finder(), level.palette, level.colormap);
  ASSERT_TRUE(gl.ok());
  const render::ColorTables tables = render::make_color_tables(level.palette, level.colormap);
  constexpr platform::PixelSize kPicture{40, 30};
  test::Random random(1);
  const RandomOverlay overlay(3, kPicture.width, kPicture.height, 0, random);
  const render::FrameBuffer frame =
      draw_on_card(overlay.list, *gl, kPicture.width, kPicture.height, GetParam());
  for (const auto& [width, height] :
       {std::pair{kPicture.width, kPicture.height}, {80, 60}, {33, 71}, {1, 1}, {120, 30}})
    for (const bool has_tone : {false, true}) {
      std::array<std::uint8_t, 256> tone;
      for (std::size_t i = 0; i < 256; ++i)
        tone[i] = has_tone ? static_cast<std::uint8_t>(255 - i) : static_cast<std::uint8_t>(i);
      formats::Palette palette = level.palette;
      for (formats::Rgb& color : palette) color = {tone[color.r], tone[color.g], tone[color.b]};
      const ShownPicture shown(card.finder(), width, height);
      ASSERT_TRUE(gl->show({.framebuffer = shown.framebuffer(),
                            .width = width,
                            .height = height,
                            .palette = palette,
                            .tone = has_tone ? &tone : nullptr})
                      .ok());
      std::vector<std::uint32_t> toned(frame.rgb().begin(), frame.rgb().end());
      for (std::uint32_t& pixel : toned)
        pixel = render::to_rgb({tone[pixel >> 16 & 255], tone[pixel >> 8 & 255], tone[pixel & 255]});
      for (const std::uint8_t index : frame.indexed()) toned.push_back(render::to_rgb(palette[index]));
      std::vector<std::uint32_t> expected;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          expected.push_back(stretch_at(toned, kPicture.width, kPicture.height,
                                        (x + 0.5) * kPicture.width / width - 0.5,
                                        (y + 0.5) * kPicture.height / height - 0.5));
      EXPECT_EQ(test::equal_share(shown.read(), expected, 1), 1.0)
          << width << "x" << height << ", " << has_tone;
    }
}

}  // namespace
}  // namespace temblor::render_gl
