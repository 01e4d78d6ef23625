// The school's steps (src/lab/school), each against its definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "lab/lessons.h"
#include "lab/school/fixed_point.h"
#include "lab/school/scene.h"
#include "lab/school/two_processors.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using namespace lab::school;  // NOLINT: its names are the subject of every line here

constexpr int kSide = 64;

Point random_point(Random& io_random, double low = -20, double high = kSide + 20) {
  const double x = io_random.uniform(low, high);
  const double y = io_random.uniform(low, high);
  return {static_cast<float>(x), static_cast<float>(y)};
}

Corners random_corners(Random& io_random) {
  const Point a = random_point(io_random);
  const Point b = random_point(io_random);
  const Point c = random_point(io_random);
  return {a, b, c};
}

// How far a point is to the left of the line from a to b, in pixels times the line's length.
double measure_side(const Point& a, const Point& b, double x, double y) {
  return (double{b.x} - double{a.x}) * (y - double{a.y}) - (double{b.y} - double{a.y}) * (x - double{a.x});
}

TEST(School, LinesHaveBothEndsAndNoGaps) {
  Random random(1);
  const Color white{1, 1, 1};
  for (int i = 0; i < 200; ++i) {
    Picture picture(kSide, kSide);
    const Point from = random_point(random, 0, kSide - 1);
    const Point to = random_point(random, 0, kSide - 1);
    draw_line(picture, from, to, white);
    EXPECT_EQ(picture.color(static_cast<int>(from.x), static_cast<int>(from.y)).red, 1);
    const bool is_wide = std::abs(to.x - from.x) > std::abs(to.y - from.y);
    const float begin = is_wide ? from.x : from.y, end = is_wide ? to.x : to.y;
    for (int at = static_cast<int>(std::min(begin, end)) + 1; at < static_cast<int>(std::max(begin, end));
         ++at) {
      int lit = 0;
      for (int other = 0; other < kSide; ++other)
        lit += (is_wide ? picture.color(at, other) : picture.color(other, at)).red == 1;
      ASSERT_GE(lit, 1) << "a gap at " << at;
    }
  }
}

TEST(School, SpansHoldThePixelsInsideTheTriangle) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Corners c = random_corners(random);
    std::set<std::pair<int, int>> drawn;
    for (const Span& span : find_spans(c, kSide, kSide))
      for (int x = span.begin; x < span.end; ++x) drawn.insert({x, span.y});
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const double sides[] = {measure_side(c[0], c[1], x + 0.5, y + 0.5),
                                measure_side(c[1], c[2], x + 0.5, y + 0.5),
                                measure_side(c[2], c[0], x + 0.5, y + 0.5)};
        if (std::ranges::any_of(sides, [](double s) { return std::abs(s) < 0.01; })) continue;  // rounding
        const bool is_inside = std::ranges::all_of(sides, [](double s) { return s > 0; }) ||
                               std::ranges::all_of(sides, [](double s) { return s < 0; });
        ASSERT_EQ(drawn.contains({x, y}), is_inside) << x << ' ' << y;
      }
  }
}

// A fan around a point covers each pixel once.
TEST(School, TrianglesThatShareEdgesLeaveNoGapAndDrawNoPixelTwice) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Point center = random_point(random, 20, 44);
    const Point corners[] = {{-5, -5}, {kSide + 5, -5}, {kSide + 5, kSide + 5}, {-5, kSide + 5}};
    std::vector<int> count(kSide * kSide);
    for (std::size_t k = 0; k < 4; ++k)
      for (const Span& span : find_spans({center, corners[k], corners[(k + 1) % 4]}, kSide, kSide))
        for (int x = span.begin; x < span.end; ++x) ++count[static_cast<std::size_t>(span.y * kSide + x)];
    ASSERT_EQ(std::ranges::count(count, 1), kSide * kSide);
  }
}

TEST(School, GradientsMeetTheCorners) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Corners corners = random_corners(random);
    if (std::abs(measure_side(corners[0], corners[1], corners[2].x, corners[2].y)) < 50) continue;
    const Gradient gradient = find_gradient(corners, {1, -2, 5});
    EXPECT_NEAR(gradient.at(corners[0].x, corners[0].y), 1, 0.01);
    EXPECT_NEAR(gradient.at(corners[1].x, corners[1].y), -2, 0.01);
    EXPECT_NEAR(gradient.at(corners[2].x, corners[2].y), 5, 0.01);
  }
}

TEST(School, MatricesMoveAsOthersDo) {
  const Vector place{1, 2, 3};
  const glm::vec4 theirs = glm::translate(glm::mat4(1), {4, 5, 6}) *
                           glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0, 1, 0)) *
                           glm::rotate(glm::mat4(1), -0.4f, glm::vec3(1, 0, 0)) *
                           glm::scale(glm::mat4(1), glm::vec3(2)) * glm::vec4(1, 2, 3, 1);
  const Vector ours = move_by({4, 5, 6}) * turn_around_y(0.7f) * turn_around_x(-0.4f) * scale_by(2) * place;
  EXPECT_NEAR(ours.x, theirs.x, 1e-5f);
  EXPECT_NEAR(ours.y, theirs.y, 1e-5f);
  EXPECT_NEAR(ours.z, theirs.z, 1e-5f);
  const Vector up = cross({0, 0, 1}, {1, 0, 0});
  EXPECT_EQ(up.y, 1);
  EXPECT_EQ(dot(up, {3, 4, 5}), 4);
  EXPECT_EQ(length({2, 3, 6}), 7);
}

TEST(School, ProjectionKeepsTheFieldOfView) {
  const View view{640, 400, 90};
  const Point center = project_perspective({0, 0, 5}, view);
  EXPECT_NEAR(center.x, 320, 1e-3);
  EXPECT_NEAR(center.y, 200, 1e-3);
  EXPECT_NEAR(project_perspective({0, 7, 7}, view).y, 0, 1e-3) << "45 degrees up is the top";
  const Point right = project_perspective({1, 0, 4}, view), up = project_perspective({0, 1, 4}, view);
  EXPECT_NEAR(right.x - 320, 200 - up.y, 1e-3) << "pixels are square";
  EXPECT_NEAR(project_perspective({1, 0, 8}, view).x - 320, (right.x - 320) / 2, 1e-3);
  EXPECT_EQ(project_parallel({1, 0, 4}, view, 8).x, project_parallel({1, 0, 400}, view, 8).x);
}

TEST(School, ClippedPolygonsEndAtTheNearPlane) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vertex> triangle(3);
    for (Vertex& vertex : triangle) {
      const double z = random.uniform(-3, 3);
      vertex.place = {static_cast<float>(i % 7), static_cast<float>(i % 5), static_cast<float>(z)};
      vertex.s = vertex.place.z * 2;
    }
    const auto in_front = std::ranges::count_if(triangle, [](const Vertex& v) { return v.place.z >= 1; });
    const std::vector<Vertex> clipped = clip_to_near_plane(triangle, 1);
    EXPECT_EQ(clipped.size(), in_front == 0 ? 0u : in_front == 2 ? 4u : 3u);
    for (const Vertex& vertex : clipped) {
      EXPECT_GE(vertex.place.z, 1 - 1e-5f);
      EXPECT_NEAR(vertex.s, vertex.place.z * 2, 1e-4) << "texture coordinates are cut alike";
    }
  }
}

// A ray through each pixel meets the floor where the texture says.
TEST(School, TexturesLieStillInPerspective) {
  Picture coordinates(256, 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      coordinates.color(x, y) = {static_cast<float>(x) / 256, static_cast<float>(y) / 256, 1};
  Mesh floor;
  add_quad(floor, {{{-4, -1, 9}, {4, -1, 9}, {4, -1, 1}, {-4, -1, 1}}}, {});
  const View view{128, 96, 70};
  Picture picture(128, 96, {0, 0, 0});
  for (const ScreenTriangle& triangle : project_mesh(floor, move_by({}), view))
    fill_textured(picture, triangle, coordinates);
  const float distance = find_picture_distance(view);
  int compared = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x) {
      const Color& drawn = picture.color(x, y);
      if (drawn.blue == 0) continue;
      const float down = -(1 - (static_cast<float>(y) + 0.5f) / 48) / distance;
      const float z = 1 / down;
      const float right = ((static_cast<float>(x) + 0.5f) / 64 - 1) * (128.0f / 96) / distance * z;
      const float s = (right + 4) / 8, t = 1 - (z - 1) / 8;
      if (s < 0.02f || s > 0.98f || t < 0.02f || t > 0.98f) continue;
      ASSERT_NEAR(drawn.red, s, 1.5 / 256) << x << ' ' << y;
      ASSERT_NEAR(drawn.green, t, 1.5 / 256) << x << ' ' << y;
      ++compared;
    }
  EXPECT_GT(compared, 1000);
}

TEST(School, MipLevelsAreMeansAndGetOneStepSmaller) {
  const std::vector<Picture> levels = make_mip_levels(make_bricks());
  ASSERT_EQ(levels.size(), 7u);
  double sum = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) sum += levels[0].color(x, y).red;
  EXPECT_NEAR(levels[6].color(0, 0).red, sum / 4096, 1e-4);
  EXPECT_EQ(choose_mip_level(0.3f, 7), 0u);
  EXPECT_EQ(choose_mip_level(1.9f, 7), 0u);
  EXPECT_EQ(choose_mip_level(4.1f, 7), 2u);
  EXPECT_EQ(choose_mip_level(1e9f, 7), 6u);
}

TEST(School, FixedPointDiffersByAPixelAtMost) {
  Random random(6);
  int spans = 0, different = 0;
  for (int i = 0; i < 500; ++i) {
    const Point a = random_point(random, 1, 1000);
    const Point b = random_point(random, 1, 1000);
    const Point c = random_point(random, 1, 1000);
    std::vector<std::pair<int, int>> rows(1024, {0, 0});
    for (const Span& span : find_spans({a, b, c}, 1024, 1024))
      rows[static_cast<std::size_t>(span.y)] = {span.begin, span.end};
    for (const Span& span : find_spans_in_fixed_point({a, b, c})) {
      const auto [begin, end] = rows[static_cast<std::size_t>(span.y)];
      ++spans;
      different += begin != span.begin || end != span.end;
      if (begin == end) continue;  // a span of one pixel that floating point has not
      ASSERT_LE(std::abs(begin - span.begin), 1);
      ASSERT_LE(std::abs(end - span.end), 1);
    }
  }
  EXPECT_GT(spans, 10000);
  EXPECT_LT(different, spans / 50);
  EXPECT_EQ((Fixed::from(-2.5f) * Fixed::from(1.5f)).to_float(), -3.75f);
  EXPECT_EQ((Fixed::from(7) / Fixed::from(-2)).to_float(), -3.5f);
}

TEST(School, TheDepthBufferKeepsTheNearestWhateverTheOrder) {
  Random random(7);
  std::vector<ScreenTriangle> triangles;
  for (int i = 0; i < 20; ++i) {
    ScreenTriangle triangle;
    for (ScreenCorner& corner : triangle) {
      corner.at = random_point(random);
      corner.inverse_depth = static_cast<float>(random.uniform(0.1, 1));
    }
    triangle[0].color = {static_cast<float>(i + 1) / 20, 0, 0};
    triangles.push_back(triangle);
  }
  Picture forward(kSide, kSide), backward(kSide, kSide);
  for (const ScreenTriangle& triangle : triangles)
    fill_with_depth_buffer(forward, triangle, triangle[0].color);
  std::ranges::reverse(triangles);
  for (const ScreenTriangle& triangle : triangles)
    fill_with_depth_buffer(backward, triangle, triangle[0].color);
  int different = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) different += forward.color(x, y).red != backward.color(x, y).red;
  EXPECT_LE(different, 2) << "only equal depths may depend on the order";
  sort_back_to_front(triangles);
  const auto depth = [](const ScreenTriangle& t) {
    return 1 / t[0].inverse_depth + 1 / t[1].inverse_depth + 1 / t[2].inverse_depth;
  };
  EXPECT_TRUE(std::ranges::is_sorted(triangles, std::ranges::greater{}, depth));
}

TEST(School, BlendingMixesWithThePictureBehind) {
  Picture picture(kSide, kSide, {1, 0, 0});
  const ScreenTriangle all{ScreenCorner{{-10, -10}}, ScreenCorner{{200, -10}}, ScreenCorner{{-10, 200}}};
  fill_blended(picture, all, {0, 0, 1}, 0.25f);
  EXPECT_EQ(picture.color(30, 30).red, 0.75f);
  EXPECT_EQ(picture.color(30, 30).blue, 0.25f);
}

TEST(School, TwoProcessorsDrawTheSameFrames) {
  const FrameRun in_turns = run_in_turns(3, 160, 100), overlapped = run_overlapped(3, 160, 100);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 160; ++x)
      ASSERT_EQ(in_turns.last_picture.color(x, y).green, overlapped.last_picture.color(x, y).green);
  EXPECT_EQ(in_turns.times.size(), 6u);
  EXPECT_EQ(overlapped.times.size(), 6u);
}

TEST(School, EveryLessonDrawsAtAnySize) {
  for (const Lesson& lesson : list_lessons())
    for (const auto& [width, height] : {std::pair{320, 200}, {64, 64}, {33, 90}}) {
      const Picture picture = lesson.draw(width, height);
      EXPECT_EQ(picture.width(), width) << lesson.name;
      EXPECT_EQ(picture.height(), height) << lesson.name;
      const Color background = Picture(1, 1).color(0, 0);
      int drawn = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) drawn += picture.color(x, y).red != background.red;
      EXPECT_GT(drawn, width * height / 100) << lesson.name;
    }
}

}  // namespace
}  // namespace temblor::test
