#include "formats/levels/light_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using GridPlace = std::array<std::int32_t, 3>;

constexpr std::size_t kRootAt = 37, kNodeCountAt = 41, kChildrenAt = 57, kLeafCountAt = 89;

// 3 x 1 x 1 samples: one occluded, one black, and one with two styles, in two leaves under one node.
base::ByteVector small_lump() {
  base::ByteWriter writer;
  for (const float step : {32.0f, 16.0f, 8.0f}) writer.f32(step);
  for (const std::int32_t size : {3, 1, 1}) writer.i32(size);
  for (const float mins : {-10.0f, 20.0f, 30.0f}) writer.f32(mins);
  writer.u8(2);
  writer.u32(0);  // root: node 0
  writer.u32(1);  // one node
  for (const std::uint32_t middle : {2u, 0u, 0u}) writer.u32(middle);
  for (std::uint32_t child = 0; child < 8; ++child)
    writer.u32(child == 3 ? 0x80000000u : child == 7 ? 0x80000001u : 0x40000000u);
  writer.u32(2);  // two leaves
  for (const std::int32_t number : {0, 0, 0, 2, 1, 1}) writer.i32(number);
  writer.u8(255);
  writer.u8(0);
  for (const std::int32_t number : {2, 0, 0, 1, 1, 1}) writer.i32(number);
  for (const int byte : {2, 0, 10, 20, 30, 33, 40, 50, 60}) writer.u8(static_cast<std::uint8_t>(byte));
  return std::move(writer).take();
}

std::string read_error(const base::ByteVector& lump) {
  const auto grid = read_light_grid(lump);
  return grid.ok() ? "" : grid.error().what;
}

template <typename Number>
base::ByteVector with_number(std::size_t at, Number number) {
  base::ByteVector lump = small_lump();
  std::memcpy(&lump.at(at), &number, sizeof number);
  return lump;
}

TEST(LightGrid, ReadsEachSample) {
  const auto grid = read_light_grid(small_lump());
  ASSERT_TRUE(grid.ok()) << grid.error().what;
  EXPECT_EQ(grid->step, math::Vec3(32, 16, 8));
  EXPECT_EQ(grid->mins, math::Vec3(-10, 20, 30));
  EXPECT_FALSE(find_grid_lights(*grid, {0, 0, 0}).has_value());
  ASSERT_TRUE(find_grid_lights(*grid, {1, 0, 0}).has_value());
  EXPECT_TRUE(find_grid_lights(*grid, {1, 0, 0})->empty());
  const auto lights = find_grid_lights(*grid, {2, 0, 0});
  ASSERT_TRUE(lights.has_value());
  EXPECT_EQ(std::vector(lights->begin(), lights->end()),
            (std::vector<GridLight>{{0, {10, 20, 30}}, {33, {40, 50, 60}}}));
  for (const GridPlace& outside :
       {GridPlace{-1, 0, 0}, GridPlace{3, 0, 0}, GridPlace{2, 1, 0}, GridPlace{2, 0, -1}})
    EXPECT_FALSE(find_grid_lights(*grid, outside).has_value());
  EXPECT_EQ(write_light_grid(*grid), small_lump());
}

TEST(LightGrid, IsRefusedWhereverItIsTruncated) {
  const base::ByteVector lump = small_lump();
  for (std::size_t size = 0; size < lump.size(); ++size)
    EXPECT_FALSE(read_light_grid(base::Bytes(lump).first(size)).ok()) << size;
  base::ByteVector longer = lump;
  longer.resize(longer.size() + 7);
  EXPECT_TRUE(read_light_grid(longer).ok());
}

TEST(LightGrid, ErrorsSayWhatIsWrong) {
  EXPECT_EQ(read_error({}), "0 bytes are shorter than the header");
  const std::string bad_place =
      "the place of a sample is not finite, or the step between samples is not positive";
  for (const float step : {0.0f, -1.0f, std::nanf(""), std::numeric_limits<float>::infinity()})
    EXPECT_EQ(read_error(with_number(4, step)), bad_place) << step;
  EXPECT_EQ(read_error(with_number(24, std::nanf(""))), bad_place);
  EXPECT_EQ(read_error(with_number(kRootAt, 1u)), "there is no node 1");
  EXPECT_EQ(read_error(with_number(kRootAt, 0x80000002u)), "there is no leaf 2");
  EXPECT_EQ(read_error(with_number(kNodeCountAt, 0xffffffffu)),
            "4294967295 nodes are more than the lump can hold");
  EXPECT_EQ(read_error(with_number(kLeafCountAt, 0x10000000u)),
            "268435456 leaves are more than the lump can hold");
  EXPECT_EQ(read_error(with_number(kLeafCountAt + 16, 0x7fffffff)),
            "leaf 0 of 2147483647 x 1 x 1 samples is larger than the lump");
  EXPECT_EQ(read_error(with_number(kLeafCountAt + 20, 0)),
            "leaf 0 of 2 x 0 x 1 samples is larger than the lump");
  EXPECT_EQ(read_error(with_number(kChildrenAt, 0u)), "node 0 is reached twice");
}

TEST(LightGrid, RefusesTreesThatAreTooDeep) {
  for (const std::size_t depth : {32u, 33u}) {
    LightGrid grid;
    grid.size = {1, 1, 1};
    grid.root.value = 0;
    grid.nodes.resize(depth);
    for (std::size_t i = 0; i + 1 < depth; ++i)
      grid.nodes[i].children[7].value = static_cast<std::uint32_t>(i + 1);
    EXPECT_EQ(read_error(write_light_grid(grid)), depth == 32 ? "" : "node 32 is deeper than 32");
  }
}

// Random trees against a plain table of the samples.
class RandomGrid {
 public:
  explicit RandomGrid(std::uint64_t seed) : random_(seed) {
    for (std::int32_t& side : grid.size) side = 1 + static_cast<std::int32_t>(random_.below(9));
    expected.resize(static_cast<std::size_t>(grid.size[0] * grid.size[1] * grid.size[2]));
    grid.root = add({0, 0, 0}, grid.size);
  }
  const std::optional<std::vector<GridLight>>& at(const GridPlace& p) const {
    return expected[static_cast<std::size_t>(p[0] + grid.size[0] * (p[1] + grid.size[1] * p[2]))];
  }

  LightGrid grid;
  std::vector<std::optional<std::vector<GridLight>>> expected;  // by sample, x first

 private:
  GridChild add(const GridPlace& mins, const GridPlace& size) {
    if (size[0] == 0 || size[1] == 0 || size[2] == 0 || random_.below(6) == 0) return {};
    if (size == GridPlace{1, 1, 1} || random_.below(3) == 0) return add_leaf(mins, size);
    GridNode node;
    std::array<GridPlace, 2> begin{mins, mins}, sides{size, size};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t lower =
          static_cast<std::int32_t>(random_.below(static_cast<std::size_t>(size[axis]) + 1));
      node.middle[axis] = static_cast<std::uint32_t>(mins[axis] + lower);
      begin[1][axis] += lower;
      sides[0][axis] = lower;
      sides[1][axis] -= lower;
    }
    if (sides[0] == GridPlace{0, 0, 0} || sides[1] == GridPlace{0, 0, 0}) return add_leaf(mins, size);
    const auto number = static_cast<std::uint32_t>(grid.nodes.size());
    grid.nodes.emplace_back();
    for (std::size_t child = 0; child < 8; ++child) {
      const std::size_t x = child >> 2, y = child >> 1 & 1, z = child & 1;
      node.children[child] =
          add({begin[x][0], begin[y][1], begin[z][2]}, {sides[x][0], sides[y][1], sides[z][2]});
    }
    grid.nodes[number] = node;
    return {number};
  }
  GridChild add_leaf(const GridPlace& mins, const GridPlace& size) {
    GridLeaf leaf{mins, size, static_cast<std::uint32_t>(grid.samples.size())};
    for (std::int32_t z = 0; z < size[2]; ++z)
      for (std::int32_t y = 0; y < size[1]; ++y)
        for (std::int32_t x = 0; x < size[0]; ++x) add_sample({mins[0] + x, mins[1] + y, mins[2] + z});
    grid.leaves.push_back(leaf);
    return {GridChild::kLeafBit | static_cast<std::uint32_t>(grid.leaves.size() - 1)};
  }
  void add_sample(const GridPlace& p) {
    GridSample sample{static_cast<std::uint32_t>(grid.lights.size()), GridSample::kOccluded};
    auto& known = expected[static_cast<std::size_t>(p[0] + grid.size[0] * (p[1] + grid.size[1] * p[2]))];
    if (random_.below(4) != 0) {
      known.emplace();
      sample.light_count = static_cast<std::uint8_t>(random_.below(4));
      for (int i = 0; i < sample.light_count; ++i) {
        const auto byte = [&] { return static_cast<std::uint8_t>(random_.below(256)); };
        known->push_back({static_cast<std::uint8_t>(random_.below(64)), {byte(), byte(), byte()}});
      }
      grid.lights.insert(grid.lights.end(), known->begin(), known->end());
    }
    grid.samples.push_back(sample);
  }

  test::Random random_;
};

TEST(LightGrid, FindsTheSamplesOfRandomTrees) {
  for (int seed = 0; seed < test::effort(300, 30); ++seed) {
    const RandomGrid random(static_cast<std::uint64_t>(seed));
    const auto grid = read_light_grid(write_light_grid(random.grid));
    ASSERT_TRUE(grid.ok()) << "seed " << seed << ": " << grid.error().what;
    ASSERT_EQ(*grid, random.grid) << "seed " << seed;
    for (std::int32_t z = 0; z < grid->size[2]; ++z)
      for (std::int32_t y = 0; y < grid->size[1]; ++y)
        for (std::int32_t x = 0; x < grid->size[0]; ++x) {
          const auto found = find_grid_lights(*grid, {x, y, z});
          const auto& expected = random.at({x, y, z});
          ASSERT_EQ(found.has_value(), expected.has_value()) << "seed " << seed;
          if (!found) continue;
          ASSERT_EQ(std::vector(found->begin(), found->end()), *expected) << "seed " << seed;
        }
  }
}

}  // namespace
}  // namespace temblor::formats
