// The laboratory's hidden-surface techniques on polygons made by hand: against the definition, on degenerate
// and coincident polygons, and for any number of threads and bands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/registry.h"
#include "support/effort.h"
#include "support/pictures/screen_polygons.h"
#include "support/pictures/stage_parts.h"

namespace temblor::test {
namespace {

using Draws = std::vector<std::uint32_t>;
constexpr std::uint32_t kUncovered = 0xffffffff;

lab::Choice choose(const char* text) {
  base::Result<lab::Choice> choice = lab::parse_choice(text);
  CHECK(choice.ok(), "{}", text);
  return *choice;
}

// The draw of each pixel; later draws of a band are in front.
Draws find_drawn(const lab::Choice& choice, const render::EdgeTable& table, const render::ViewFrame& view,
                 const render::Settings& settings) {
  StageParts parts(settings);
  const render::Scene scene;
  const render::SpanTable spans = choice.make_stages().scan_edges(parts.context(scene), view, table);
  Draws pixels(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), kUncovered);
  for (const render::Band& band : spans.bands)
    for (std::size_t position = 0; position < band.draws.size(); ++position)
      for (const render::Span& span : band.spans_at(position)) {
        CHECK(span.count > 0 && span.x + span.count <= view.width && span.y < view.height);
        const std::size_t first = std::size_t{span.y} * static_cast<std::size_t>(view.width) + span.x;
        std::fill_n(pixels.begin() + static_cast<std::ptrdiff_t>(first), span.count, band.draws[position]);
      }
  return pixels;
}

Draws find_drawn(const lab::Choice& choice, const render::EdgeTable& table, const render::ViewFrame& view) {
  return find_drawn(choice, table, view, {.band_rows = view.height});
}

struct Polygons {
  render::ViewFrame view;
  std::vector<ScreenPolygon> polygons;
};

// Parallel planes, so that none cross. The nearer plane has the smaller key.
Polygons make_polygons(Random& io_random) {
  Polygons made;
  made.view.width = static_cast<int>(1 + io_random.below(150));
  made.view.height = static_cast<int>(1 + io_random.below(100));
  const double dx = io_random.uniform(-0.4, 0.4) / made.view.width;
  const double dy = io_random.uniform(-0.4, 0.4) / made.view.height;
  const std::size_t count = io_random.below(io_random.chance(0.5) ? 5 : 60);
  std::vector<std::size_t> ranks(count);
  for (std::size_t i = 0; i < count; ++i) ranks[i] = i;
  for (std::size_t i = 0; i < count; ++i) std::swap(ranks[i], ranks[i + io_random.below(count - i)]);
  for (std::size_t i = 0; i < count; ++i) {
    ScreenPolygon polygon = any_polygon(made.view, io_random);
    const double nearness = std::pow(1.03, -static_cast<double>(ranks[i]));
    polygon.key = static_cast<render::SortKey>(ranks[i] + 1);
    polygon.depth = {nearness, nearness * dx, nearness * dy};
    made.polygons.push_back(std::move(polygon));
  }
  return made;
}

class HiddenSurfaces : public testing::TestWithParam<const char*> {};

TEST_P(HiddenSurfaces, ShowTheNearestPolygon) {
  const lab::Choice choice = choose(GetParam());
  for (int seed = 0; seed < effort(100, 10); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Polygons made = make_polygons(random);
    const HandMadeTable table(made.view, made.polygons);
    const Draws drawn = find_drawn(choice, table.view(), made.view);
    const auto wanted = find_shown_draws(made.view, made.polygons);
    for (std::size_t i = 0; i < drawn.size(); ++i)
      if (wanted[i]) {
        ASSERT_EQ(drawn[i], *wanted[i])
            << "seed " << seed << ", pixel " << i << " of " << made.view.width << "x" << made.view.height;
      }
  }
}

TEST_P(HiddenSurfaces, AreTheSameInAnyBandsAndThreads) {
  const lab::Choice choice = choose(GetParam());
  for (int seed = 0; seed < effort(20, 4); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Polygons made = make_polygons(random);
    const HandMadeTable table(made.view, made.polygons);
    const Draws whole = find_drawn(choice, table.view(), made.view);
    for (const int rows : {1, 7, 64})
      EXPECT_EQ(find_drawn(choice, table.view(), made.view, {.band_rows = rows}), whole) << rows;
    const render::Settings threads{.threads = 2, .job_backend = base::JobBackend::kStdThread, .band_rows = 3};
    EXPECT_EQ(find_drawn(choice, table.view(), made.view, threads), whole);
    const render::Settings scalar{.simd_kernels = false, .band_rows = made.view.height};
    EXPECT_EQ(find_drawn(choice, table.view(), made.view, scalar), whole);
  }
}

// Slivers, points, polygons in the same place, planes that cross or contain the eye: any face may be shown,
// but every pixel shows one.
TEST_P(HiddenSurfaces, CoverThePictureWhateverThePolygons) {
  const lab::Choice choice = choose(GetParam());
  for (int seed = 0; seed < effort(60, 6); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Polygons made = make_polygons(random);
    for (std::size_t i = 0; i < made.polygons.size(); ++i) {
      ScreenPolygon& polygon = made.polygons[i];
      const ScreenPolygon& other = made.polygons[random.below(made.polygons.size())];
      polygon.key = static_cast<render::SortKey>(1 + random.below(3));
      if (random.chance(0.3)) polygon = other;
      if (random.chance(0.2)) polygon.depth = {random.uniform(-1, 1), random.uniform(-1, 1), 0};
      if (random.chance(0.1)) polygon.depth = {};
      if (random.chance(0.2)) polygon.corners[1] = polygon.corners[0];
      if (random.chance(0.1))
        for (math::Vec2d& corner : polygon.corners) corner = other.corners[0];
    }
    const HandMadeTable table(made.view, made.polygons);
    for (const std::uint32_t draw : find_drawn(choice, table.view(), made.view)) {
      ASSERT_LE(draw, made.polygons.size()) << seed;
    }
  }
}

TEST_P(HiddenSurfaces, CopeWithTenThousandEdgesOnARow) {
  const lab::Choice choice = choose(GetParam());
  render::ViewFrame view;
  view.width = 200;
  view.height = 2;
  Random random(1);
  std::vector<ScreenPolygon> polygons;
  for (int i = 0; i < effort(5000, 1000); ++i) {
    const double left = random.uniform(-10, 205), right = left + random.log_uniform(0.01, 100);
    const double depth = 1.0 / (i + 1);
    polygons.push_back({{{left, -1}, {right, -1}, {right, 3}, {left, 3}},
                        static_cast<render::SortKey>(i + 1),
                        {depth, 0, 0}});
  }
  const HandMadeTable table(view, polygons);
  const auto wanted = find_shown_draws(view, polygons);
  const Draws drawn = find_drawn(choice, table.view(), view);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (wanted[i]) {
      ASSERT_EQ(drawn[i], *wanted[i]) << i;
    }
}

std::string make_name(const testing::TestParamInfo<const char*>& test) {
  std::string name(test.param);
  for (char& c : name)
    if (c == '-' || c == ':' || c == '=') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Techniques, HiddenSurfaces,
                         testing::Values("painter", "z-buffer", "z-buffer:order=1", "beam-tree",
                                         "beam-tree:bands=0", "beam-tree:nodes=300", "span-sorting",
                                         "span-sorting:depth=1", "independent-edges", "abutting-edges",
                                         "intersecting-edges", "cached-order", "unsplit-edges"),
                         make_name);

// Two planes that cross in the middle of the screen, which no order can show.
TEST(HiddenSurfaces, SplitSpansWhereSurfacesCross) {
  render::ViewFrame view;
  view.width = 64;
  view.height = 8;
  const std::vector<math::Vec2d> screen = {{-1, -1}, {70, -1}, {70, 10}, {-1, 10}};
  const std::vector<ScreenPolygon> polygons = {{screen, 1, {1, 0.01, 0}}, {screen, 1, {1.315, 0, 0}}};
  const HandMadeTable table(view, polygons);
  for (const char* name : {"intersecting-edges", "z-buffer", "span-sorting:depth=1"}) {
    const Draws drawn = find_drawn(choose(name), table.view(), view);
    if (std::string_view(name).starts_with("span")) {
      EXPECT_EQ(std::ranges::count(drawn, drawn[0]), std::ssize(drawn)) << "a span is in front as a whole";
      continue;
    }
    for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_EQ(drawn[i], i % 64 < 32 ? 2u : 1u) << name << i;
  }
}

}  // namespace
}  // namespace temblor::test
