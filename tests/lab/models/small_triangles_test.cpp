// Small triangles by masks and by precompiled code: the same pixels, for every triangle there is.
#include "lab/models/small/small_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <sstream>

#include "lab/model_pictures.h"
#include "lab/models/small/assembled_shapes.h"
#include "lab/models/small/small_shapes.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using lab::AssembledShapes;
using lab::PlacedShape;
using lab::SmallCorners;
using lab::SmallMasks;
using lab::SmallShapes;
using render::PixelFormat;

bool touches_box(const SmallCorners& corners) {
  const auto& [a, b, c] = corners;
  return std::min({a.x, b.x, c.x}) == 0 && std::min({a.y, b.y, c.y}) == 0;
}

// A pixel on a left or top edge comes inside if it moves a little to the right, and even less down.
// Independent of the rule of SmallMasks.
std::uint32_t find_mask_by_moved_points(const SmallCorners& corners) {
  const auto cross = [](const SmallCorners::Corner& p, const SmallCorners::Corner& q, double x, double y) {
    return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
  };
  const auto& [a, b, c] = corners;
  std::uint32_t mask = 0;
  for (int bit = 0; bit < 25; ++bit) {
    const double x = bit % 5 + 1e-4, y = bit / 5 + 1e-7;
    if (cross(a, b, x, y) > 0 && cross(b, c, x, y) > 0 && cross(c, a, x, y) > 0)
      mask |= std::uint32_t{1} << bit;
  }
  return mask;
}

TEST(SmallMasks, HaveThePixelsOfEachTriangle) {
  const SmallMasks masks;
  for (std::size_t i = 0; i < SmallMasks::kTriangles; ++i) {
    ASSERT_EQ(SmallMasks::number(SmallMasks::find_corners(i)), i);
    ASSERT_EQ(masks.find(i), find_mask_by_moved_points(SmallMasks::find_corners(i))) << i;
  }
}

TEST(SmallShapes, AreTheMasksOfAllTriangles) {
  const SmallMasks masks;
  const SmallShapes shapes(masks);
  EXPECT_EQ(shapes.masks().size(), 346u);
  for (std::size_t i = 0; i < SmallMasks::kTriangles; ++i) {
    const PlacedShape placed = shapes.find(i);
    if (placed.number == lab::kNoShape) {
      ASSERT_EQ(masks.find(i), 0u) << i;
      continue;
    }
    ASSERT_EQ(shapes.masks()[placed.number] << (placed.row * 5 + placed.column), masks.find(i)) << i;
  }
  EXPECT_TRUE(std::ranges::equal(shapes.masks(), lab::list_built_shapes().masks));
}

// A small picture, and a model with one triangle in it.
template <typename Pixel>
class OneTriangle {
 public:
  static constexpr std::int32_t kWidth = 9, kHeight = 8, kLeft = 2, kTop = 1;

  // In a target of some rows of the picture.
  OneTriangle(Random& io_random, std::size_t number, std::int32_t left = kLeft, std::int32_t row_begin = 0,
              std::int32_t row_end = kHeight)
      : left_(left), row_begin_(row_begin), row_end_(row_end) {
    const SmallCorners corners = SmallMasks::find_corners(number);
    std::size_t vertex = 0;
    for (const SmallCorners::Corner& corner : {corners.a, corners.b, corners.c}) {
      vertices_[vertex] = {(left + corner.x) * 256, (kTop + corner.y) * 256, 0, 0};
      vertices_[vertex].depth = static_cast<float>(io_random.uniform(0.1, 1));
      vertices_[vertex].light = static_cast<float>(io_random.uniform(-100, 33000));
      texels_[vertex].s = static_cast<float>(io_random.uniform(-1, 18));
      texels_[vertex++].t = static_cast<float>(io_random.uniform(-1, 12));
    }
    for (std::uint8_t& texel : skin_) texel = static_cast<std::uint8_t>(io_random.below(256));
    for (Pixel& color : colors_) color = static_cast<Pixel>(io_random.below(std::uint64_t{1} << 32));
    for (float& depth : depth_before_) depth = static_cast<float>(io_random.uniform(0, 0.8));
    job_.vertices = vertices_.data();
    job_.texels = texels_.data();
    job_.triangles = index_.data();
    job_.vertex_count = 3;
    job_.triangle_count = 1;
    job_.skin = skin_.data();
    job_.skin_width = 17;
    job_.skin_height = 11;
    job_.colors = colors_.data();
    for (std::int32_t& tint : job_.tint) tint = static_cast<std::int32_t>(io_random.below(32769));
    const auto& [a, b, c] = corners;
    triangle_ = {0,
                 left,
                 kTop,
                 static_cast<std::uint8_t>(std::max({a.x, b.x, c.x})),
                 static_cast<std::uint8_t>(std::max({a.y, b.y, c.y})),
                 static_cast<std::uint16_t>(number)};
  }

  struct Picture {
    std::array<Pixel, kWidth * kHeight> pixels{};
    std::array<std::uint32_t, kWidth * kHeight> depth_bits{};
    bool operator==(const Picture&) const = default;
  };
  // Calls draw(painter, triangle). `empty`: nothing is in front of the triangle.
  template <typename Draw>
  Picture draw(bool empty, Draw draw) const {
    Picture picture;
    std::array<float, kWidth * kHeight> depth{};
    if (!empty) depth = depth_before_;
    const render::TriangleTarget target{picture.pixels.data(), depth.data(), kWidth, 0, row_begin_, row_end_};
    lab::SmallPainter<Pixel> painter(job_, target);
    draw(painter, triangle_);
    for (std::size_t i = 0; i < depth.size(); ++i)
      picture.depth_bits[i] = std::bit_cast<std::uint32_t>(depth[i]);
    return picture;
  }
  // The pixels that are nearer than 0.
  std::uint32_t find_drawn(const Picture& picture) const {
    std::uint32_t mask = 0;
    for (std::int32_t i = 0; i < kWidth * kHeight; ++i) {
      const std::int32_t column = i % kWidth - left_, row = i / kWidth - kTop;
      if (picture.depth_bits[static_cast<std::size_t>(i)] == 0) continue;
      const bool is_in_box = column >= 0 && column < 5 && row >= 0 && row < 5;
      EXPECT_TRUE(is_in_box);
      if (is_in_box) mask |= std::uint32_t{1} << (row * 5 + column);
    }
    return mask;
  }
  // Those of a mask's pixels that are in the target.
  std::uint32_t clip(std::uint32_t mask) const {
    for (std::int32_t bit = 0; bit < 25; ++bit) {
      const std::int32_t x = left_ + bit % 5, y = kTop + bit / 5;
      if (x < 0 || x >= kWidth || y < row_begin_ || y >= row_end_) mask &= ~(std::uint32_t{1} << bit);
    }
    return mask;
  }

 private:
  std::int32_t left_, row_begin_, row_end_;
  std::array<render::ScreenVertex, 3> vertices_;
  std::array<render::TexelPoint, 3> texels_;
  std::array<std::uint32_t, 3> index_ = {0, 1, 2};
  std::array<std::uint8_t, 17 * 11> skin_;
  std::array<Pixel, 64 * 256> colors_;
  std::array<float, kWidth * kHeight> depth_before_;
  render::TriangleJob job_{};
  lab::SmallTriangle triangle_;
};

template <typename Pixel>
void check_every_triangle(std::span<const lab::DrawShape> code) {
  const SmallMasks masks;
  const SmallShapes shapes(masks);
  Random random(7);
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < SmallMasks::kTriangles; ++i) {
    const std::uint32_t mask = masks.find(i);
    if (mask == 0 || !touches_box(SmallMasks::find_corners(i))) continue;
    const OneTriangle<Pixel> one(random, i);
    const auto draw_mask = [&](auto& io_painter, const lab::SmallTriangle& triangle) {
      io_painter.draw_mask(triangle, mask);
    };
    const auto run_code = [&](auto& io_painter, const lab::SmallTriangle& triangle) {
      const PlacedShape shape = shapes.find(i);
      code[shape.number](io_painter.start(triangle, shape.column, shape.row));
    };
    for (const bool empty : {true, false}) {
      const auto right = one.draw(empty, draw_mask);
      ASSERT_EQ(one.draw(empty, run_code), right) << i;
      if (empty) {
        ASSERT_EQ(one.find_drawn(right), mask) << i;
      }
    }
    ++drawn;
  }
  EXPECT_EQ(drawn, 3477u);
}

TEST(SmallPainter, ClipsMasks) {
  const SmallMasks masks;
  Random random(8);
  for (std::size_t i = 0; i < SmallMasks::kTriangles; ++i) {
    const std::uint32_t mask = masks.find(i);
    if (mask == 0 || !touches_box(SmallMasks::find_corners(i))) continue;
    for (const std::int32_t left : {-3, OneTriangle<std::uint8_t>::kWidth - 2})
      for (const auto& [row_begin, row_end] : {std::pair(0, 4), std::pair(3, 8)}) {
        const OneTriangle<std::uint8_t> one(random, i, left, row_begin, row_end);
        const auto picture = one.draw(true, [&](auto& io_painter, const lab::SmallTriangle& triangle) {
          io_painter.draw_mask(triangle, mask);
        });
        ASSERT_EQ(one.find_drawn(picture), one.clip(mask)) << i;
      }
  }
}

TEST(BuiltShapes, DrawEveryTriangle) {
  check_every_triangle<std::uint8_t>(lab::list_built_shapes().indexed);
  check_every_triangle<std::uint32_t>(lab::list_built_shapes().rgb);
}

// Null without asmjit.
std::optional<AssembledShapes> assemble() {
  auto made = AssembledShapes::make(lab::list_built_shapes().masks);
  if (!made.ok()) {
    EXPECT_EQ(made.error().code, base::ErrorCode::kUnsupported);
  }
  return made.ok() ? std::optional(std::move(made.value())) : std::nullopt;
}

TEST(AssembledShapes, DrawEveryTriangle) {
  const std::optional<AssembledShapes> shapes = assemble();
  if (!shapes) GTEST_SKIP() << "without asmjit";
  check_every_triangle<std::uint8_t>(shapes->indexed());
  check_every_triangle<std::uint32_t>(shapes->rgb());
}

// The access rights of the memory at an address, as in "r-xp".
std::string find_rights(const void* address) {
  std::ifstream maps("/proc/self/maps");
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  for (std::string line; std::getline(maps, line);) {
    std::istringstream words(line);
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    std::string rights;
    words >> std::hex >> begin >> dash >> end >> rights;
    if (wanted >= begin && wanted < end) return rights;
  }
  return "";
}

TEST(AssembledShapes, AreInBoundedMemoryThatCannotBeWritten) {
  const std::optional<AssembledShapes> shapes = assemble();
  if (!shapes) GTEST_SKIP() << "without asmjit";
  EXPECT_LT(shapes->size_bytes(), std::size_t{1} << 20);
  for (const auto& code : {shapes->indexed(), shapes->rgb()})
    for (const lab::DrawShape function : {code.front(), code.back()})
      EXPECT_EQ(find_rights(reinterpret_cast<const void*>(function)), "r-xp");
}

TEST(AssembledShapes, NeedExecutableMemory) {
  const auto refuse = [](void*, std::size_t) { return false; };
  const auto refused = AssembledShapes::make(lab::list_built_shapes().masks, refuse);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::kUnsupported);
  EXPECT_THAT(refused.error().what, testing::HasSubstr("compiled-triangles:code=1"));
  EXPECT_THAT(refused.error().what, testing::Not(testing::HasSubstr("\n")));
}

// Near and far models, also at the screen's edges, where masks are clipped.
TEST(CompiledTriangles, DrawThePictureOfMasks) {
  const DrawableLevel drawable = small_level();
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (int seed = 0; seed < effort(8, 2); ++seed)
      for (const CrowdPlace& place : {CrowdPlace{.least = 8, .most = 60},
                                      CrowdPlace{.least = 60, .most = 600, .spread = 1.2, .count = 40}}) {
        Random random(static_cast<std::uint64_t>(seed));
        const ModelScene models(drawable, random, place);
        ModelPictures masks(drawable, "triangle-masks", format);
        const FrameCopy right = masks.copy(models.scene, {});
        for (const char* const technique : {"compiled-triangles", "compiled-triangles:code=1"}) {
          if (technique == std::string_view("compiled-triangles:code=1") && !assemble()) continue;
          ModelPictures code(drawable, technique, format);
          for (const int threads : {1, 2, 3})
            EXPECT_EQ(code.copy(models.scene, {.threads = threads, .band_rows = 16}), right)
                << technique << ", seed " << seed << ", threads " << threads;
        }
      }
}

TEST(CompiledTriangles, DrawThePictureOfMasksForEachSide) {
  const DrawableLevel drawable = small_level();
  Random random(9);
  const ModelScene models(drawable, random, {.least = 100, .most = 1000, .count = 20});
  for (const int side : {1, 2, 3, 4}) {
    const std::string masks = fmt::format("triangle-masks:side={}", side);
    const std::string code = fmt::format("compiled-triangles:side={}", side);
    ModelPictures right(drawable, masks.c_str(), PixelFormat::kIndexed);
    ModelPictures drawn(drawable, code.c_str(), PixelFormat::kIndexed);
    EXPECT_EQ(drawn.copy(models.scene, {}), right.copy(models.scene, {})) << side;
  }
}

}  // namespace
}  // namespace temblor::test
