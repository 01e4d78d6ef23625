// The surface cache against a list of what it should hold: least recently used out first, a budget that is
// never exceeded, blocks of the frame that stay, and contents that make a block stale.
#include "render/surfaces/surface_cache.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <list>
#include <map>
#include <optional>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::BlockContents;
using render::SurfaceBlock;
using render::SurfaceCache;
using render::SurfaceShape;

// Lit faces of one tile each: all that the cache looks at in a level.
world::Level make_level(std::size_t count, std::int32_t extent = 16) {
  world::Level level;
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.light = 0;
  face.texture_extents = {extent, extent};
  level.faces.assign(count, face);
  return level;
}

world::FaceIndex face(std::size_t number) {
  return base::to_index<world::FaceIndex>(number);
}

BlockContents contents(std::uint16_t light, std::size_t texture = 0, std::uint64_t dynamic_light = 0) {
  return {.texture = base::to_index<world::TextureIndex>(texture),
          .style_values = {light, 0, 0, 0},
          .lights = dynamic_light};
}

// Whole cache lines.
std::size_t allocated_bytes(SurfaceShape shape, std::size_t bytes_per_texel) {
  return (shape.texels() * bytes_per_texel + render::kBlockPadding + 63) / 64 * 64;
}

constexpr SurfaceShape kSmall{16, 16};
constexpr std::size_t kSmallBytes = 16 * 16 + render::kBlockPadding;
constexpr std::size_t kAmpleBytes = 1 << 20;

// One frame that looks up mip 0 of faces, each with its contents: first finds all, then reserves the rest.
struct Wanted {
  std::size_t face;
  BlockContents contents{};
  int mip = 0;
};
struct Seen {
  SurfaceBlock block;
  bool built;
};
class Frames {
 public:
  explicit Frames(const world::Level& level, std::size_t budget_bytes)
      : level_(level), budget_bytes_(budget_bytes) {}

  std::vector<Seen> draw(const std::vector<Wanted>& wanted) {
    cache_.begin_frame(level_, 1, budget_bytes_, true);
    std::vector<std::optional<Seen>> found;
    for (const Wanted& one : wanted) {
      SurfaceCache::Lookup lookup;
      const bool hit = cache_.find(slot(one), one.contents, lookup);
      found.push_back(hit ? std::optional(Seen{lookup.block, lookup.must_build}) : std::nullopt);
    }
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!found[i]) {
        const SurfaceCache::Lookup lookup = cache_.reserve(slot(wanted[i]), wanted[i].contents, kSmall);
        found[i] = Seen{lookup.block, lookup.must_build};
      }
      seen.push_back(*found[i]);
    }
    return seen;
  }
  // The requests whose blocks had to be built.
  std::vector<bool> built(const std::vector<Wanted>& wanted) {
    std::vector<bool> built;
    for (const Seen& seen : draw(wanted)) built.push_back(seen.built);
    return built;
  }
  SurfaceCache& cache() { return cache_; }

 private:
  std::size_t slot(const Wanted& wanted) const { return cache_.slot(face(wanted.face), 0, wanted.mip); }
  const world::Level& level_;
  std::size_t budget_bytes_;
  SurfaceCache cache_;
};

using Built = std::vector<bool>;

TEST(SurfaceCache, BuildsABlockOnce) {
  const world::Level level = make_level(3);
  Frames frames(level, kAmpleBytes);
  EXPECT_EQ(frames.built({{0}, {1}}), (Built{true, true}));
  EXPECT_EQ(frames.built({{0}, {1}, {2}}), (Built{false, false, true}));
  EXPECT_EQ(frames.cache().counts().hits, 2u);
  EXPECT_EQ(frames.cache().counts().misses, 1u);
  EXPECT_EQ(frames.cache().bytes_in_use(), 3 * kSmallBytes);
}

TEST(SurfaceCache, KeepsEachMipLevelApart) {
  const world::Level level = make_level(1);
  Frames frames(level, kAmpleBytes);
  const std::vector<Wanted> all = {{0, {}, 0}, {0, {}, 1}, {0, {}, 2}, {0, {}, 3}};
  EXPECT_EQ(frames.built(all), (Built{true, true, true, true}));
  EXPECT_EQ(frames.built(all), (Built{false, false, false, false}));
}

// Faces, tiles, and mip levels have separate slots.
TEST(SurfaceCache, HasASlotForEachTileAndMipLevel) {
  world::Level level = make_level(2, 600);        // 3 x 3 tiles
  level.faces.push_back(make_level(1).faces[0]);  // one
  level.faces.insert(level.faces.begin(), make_level(1, 256).faces[0]);
  SurfaceCache cache;
  cache.begin_frame(level, 1, kAmpleBytes, true);
  std::vector<std::size_t> slots;
  for (std::size_t number = 0; number < level.faces.size(); ++number)
    for (std::size_t tile = 0; tile < (level.faces[number].texture_extents[0] == 600 ? 9u : 1u); ++tile)
      for (int mip = 0; mip < 4; ++mip) slots.push_back(cache.slot(face(number), tile, mip));
  std::sort(slots.begin(), slots.end());
  EXPECT_EQ(std::adjacent_find(slots.begin(), slots.end()), slots.end());
}

TEST(SurfaceCache, EvictsTheLeastRecentlyUsed) {
  const world::Level level = make_level(5);
  Frames frames(level, 3 * kSmallBytes);
  frames.draw({{0}, {1}, {2}});
  frames.draw({{0}});
  frames.draw({{3}});  // in place of 1
  EXPECT_EQ(frames.cache().counts().evictions, 1u);
  EXPECT_EQ(frames.built({{0}, {2}, {3}}), (Built{false, false, false}));
  frames.draw({{4}});  // in place of 0
  EXPECT_EQ(frames.built({{2}, {3}, {4}}), (Built{false, false, false}));
  EXPECT_EQ(frames.built({{0}}), (Built{true}));
}

TEST(SurfaceCache, NeverEvictsBlocksOfTheFrame) {
  const world::Level level = make_level(4);
  Frames frames(level, 2 * kSmallBytes);
  frames.draw({{0}, {1}});
  const std::vector<Seen> seen = frames.draw({{0}, {1}, {2}, {3}});
  EXPECT_FALSE(seen[0].built || seen[1].built);
  EXPECT_EQ(frames.cache().counts().over_budget, 2u);
  EXPECT_EQ(frames.cache().counts().evictions, 0u);
  EXPECT_EQ(frames.cache().bytes_in_use(), 2 * kSmallBytes);
}

TEST(SurfaceCache, DropsBlocksOverTheBudgetAfterTheFrame) {
  const world::Level level = make_level(2);
  Frames frames(level, kSmallBytes);
  EXPECT_EQ(frames.built({{0}, {1}}), (Built{true, true}));
  EXPECT_EQ(frames.built({{0}, {1}}), (Built{false, true}));
}

TEST(SurfaceCache, WorksWithoutAnyBudget) {
  const world::Level level = make_level(3);
  Frames frames(level, 0);
  for (int frame = 0; frame < 2; ++frame) EXPECT_EQ(frames.built({{0}, {1}, {2}}), (Built{true, true, true}));
  EXPECT_EQ(frames.cache().bytes_in_use(), 0u);
  EXPECT_EQ(frames.cache().counts().over_budget, 3u);
}

TEST(SurfaceCache, RebuildsBlocksWithOtherLightInPlace) {
  const world::Level level = make_level(1);
  Frames frames(level, kAmpleBytes);
  BlockContents shown = contents(1);
  const std::byte* texels = frames.draw({{0, shown}})[0].block.texels;
  const auto expect_rebuilt = [&] {
    const Seen seen = frames.draw({{0, shown}})[0];
    EXPECT_TRUE(seen.built);
    EXPECT_EQ(seen.block.texels, texels);
    EXPECT_EQ(frames.built({{0, shown}}), (Built{false}));
  };
  for (std::uint16_t& value : shown.style_values) {
    ++value;
    expect_rebuilt();
  }
  shown.colored = true;
  expect_rebuilt();
  EXPECT_EQ(frames.cache().bytes_in_use(), kSmallBytes);
}

// Two doors with the same brush model show two frames of a texture: neither may show the other's, and both
// are kept.
TEST(SurfaceCache, KeepsABlockForEachTextureOfAFace) {
  const world::Level level = make_level(1);
  Frames frames(level, kAmpleBytes);
  const std::vector<Wanted> both = {{0, contents(1, 3)}, {0, contents(1, 4)}};
  const std::vector<Seen> first = frames.draw(both);
  EXPECT_TRUE(first[0].built && first[1].built);
  EXPECT_NE(first[0].block.texels, first[1].block.texels);
  for (int frame = 0; frame < 2; ++frame) {
    const std::vector<Seen> seen = frames.draw(both);
    for (std::size_t door = 0; door < 2; ++door) {
      EXPECT_FALSE(seen[door].built);
      EXPECT_EQ(seen[door].block.texels, first[door].block.texels);
    }
  }
  EXPECT_EQ(frames.cache().bytes_in_use(), 2 * kSmallBytes);
}
TEST(SurfaceCache, EvictsOneTextureOfAFaceAndKeepsTheOthers) {
  const world::Level level = make_level(1);
  for (std::size_t evicted = 0; evicted < 3; ++evicted) {
    Frames frames(level, 3 * kSmallBytes);
    std::vector<Wanted> kept;
    for (std::size_t texture = 0; texture < 3; ++texture)
      if (texture != evicted) kept.push_back({0, contents(1, texture)});
    frames.draw({{0, contents(1, 0)}, {0, contents(1, 1)}, {0, contents(1, 2)}});
    frames.draw(kept);
    frames.draw({{0, contents(1, 3)}});
    EXPECT_EQ(frames.built(kept), (Built{false, false}));
    EXPECT_EQ(frames.built({{0, contents(1, evicted)}}), (Built{true}));
  }
}
TEST(SurfaceCache, BuildsOneBlockForEqualContentsOfOneFace) {
  const world::Level level = make_level(1);
  Frames frames(level, kAmpleBytes);
  const std::vector<Seen> seen = frames.draw({{0, contents(1)}, {0, contents(1)}});
  EXPECT_TRUE(seen[0].built);
  EXPECT_FALSE(seen[1].built);
  EXPECT_EQ(seen[0].block.texels, seen[1].block.texels);
}

TEST(SurfaceCache, DropsEverythingForAnotherLevelOrFormat) {
  const world::Level level = make_level(1), other = make_level(2);
  SurfaceCache cache;
  const auto is_built = [&](const world::Level& now, std::size_t bytes_per_texel) {
    cache.begin_frame(now, bytes_per_texel, kAmpleBytes, true);
    SurfaceCache::Lookup lookup;
    const std::size_t slot = cache.slot(face(0), 0, 0);
    if (cache.find(slot, {}, lookup)) return lookup.must_build;
    return cache.reserve(slot, {}, kSmall).must_build;
  };
  EXPECT_TRUE(is_built(level, 1));
  EXPECT_FALSE(is_built(level, 1));
  EXPECT_TRUE(is_built(level, 4));
  EXPECT_EQ(cache.bytes_in_use(), allocated_bytes(kSmall, 4));
  EXPECT_TRUE(is_built(other, 4));
  EXPECT_TRUE(is_built(level, 4));
  EXPECT_FALSE(is_built(level, 4));
  cache.clear();
  EXPECT_EQ(cache.bytes_in_use(), 0u);
  EXPECT_TRUE(is_built(level, 4));
}

// A light comes, moves, and goes: lit blocks are built for it, and the blocks without it are still there.
TEST(SurfaceCache, KeepsBlocksWithDynamicLight) {
  const world::Level level = make_level(1);
  Frames frames(level, kAmpleBytes);
  const SurfaceBlock unlit = frames.draw({{0, contents(1)}})[0].block;
  const Seen lit = frames.draw({{0, contents(1, 0, 7)}})[0];
  EXPECT_TRUE(lit.built);
  EXPECT_NE(lit.block.texels, unlit.texels);
  const Seen moved = frames.draw({{0, contents(1, 0, 8)}})[0];
  EXPECT_TRUE(moved.built);
  EXPECT_EQ(moved.block.texels, lit.block.texels) << "light that has moved on leaves nothing behind";
  const Seen gone = frames.draw({{0, contents(1)}})[0];
  EXPECT_FALSE(gone.built);
  EXPECT_EQ(gone.block.texels, unlit.texels);
}

TEST(SurfaceCache, KeepsNothingWhileItIsOff) {
  const world::Level level = make_level(1);
  SurfaceCache cache;
  const auto is_built = [&](bool enabled) {
    cache.begin_frame(level, 1, kAmpleBytes, enabled);
    SurfaceCache::Lookup lookup;
    return !cache.find(cache.slot(face(0), 0, 0), {}, lookup) &&
           cache.reserve(cache.slot(face(0), 0, 0), {}, kSmall).must_build;
  };
  EXPECT_TRUE(is_built(false));
  EXPECT_TRUE(is_built(false));
  EXPECT_EQ(cache.bytes_in_use(), 0u);
  EXPECT_TRUE(is_built(true));
  EXPECT_FALSE(is_built(true));
}

TEST(SurfaceCache, ShrinksToASmallerBudgetWithTheNextFrame) {
  const world::Level level = make_level(4);
  SurfaceCache cache;
  cache.begin_frame(level, 1, kAmpleBytes, true);
  for (std::size_t number = 0; number < 4; ++number)
    cache.reserve(cache.slot(face(number), 0, 0), {}, kSmall);
  cache.begin_frame(level, 1, 2 * kSmallBytes, true);
  EXPECT_EQ(cache.bytes_in_use(), 2 * kSmallBytes);
  SurfaceCache::Lookup lookup;
  EXPECT_FALSE(cache.find(cache.slot(face(1), 0, 0), {}, lookup));
  EXPECT_TRUE(cache.find(cache.slot(face(2), 0, 0), {}, lookup));
}

// The model of the cache: a list of blocks, from the least recently used on. How many blocks must be evicted
// before a hole is large enough depends on their addresses. So the list takes that number from the cache, and
// checks that the evicted blocks were the oldest ones, that none of them was in use, and that they were
// enough for the budget.
class Expectation {
 public:
  struct Block {
    std::size_t slot, bytes;
    BlockContents contents;
    bool in_frame;
    std::uint64_t number;  // in the order they were made
  };
  render::CacheCounts counts;
  std::list<Block> blocks;

  void begin_frame(std::size_t budget_bytes) {
    budget_bytes_ = budget_bytes;
    counts = {};
    for (Block& block : blocks) block.in_frame = false;
    for (; bytes() > budget_bytes_; ++counts.evictions) blocks.pop_front();
  }
  bool find(std::size_t slot, const BlockContents& wanted) {
    const auto block = with(slot, wanted);
    if (block == blocks.end()) return false;
    counts.hits += !block->in_frame;  // fragments of a face share a block and count once
    use(block);
    return true;
  }
  // Returns whether the block must be built.
  struct Outcome {
    std::uint32_t evicted;
    bool kept;
  };
  bool reserve(std::size_t slot, const BlockContents& wanted, std::size_t bytes_needed, Outcome outcome) {
    if (with(slot, wanted) != blocks.end()) {
      EXPECT_EQ(outcome.evicted, 0u);
      return false;
    }
    const auto block = stale(slot, wanted);
    if (block != blocks.end()) {
      EXPECT_EQ(outcome.evicted, 0u);
      ++counts.misses;
      block->contents = wanted;
      use(block);
      return true;
    }
    ++counts.misses;
    counts.evictions += outcome.evicted;
    for (; outcome.evicted > 0 && !blocks.empty(); --outcome.evicted) {
      EXPECT_FALSE(blocks.front().in_frame);
      blocks.pop_front();
    }
    if (outcome.kept) {
      blocks.push_back({slot, bytes_needed, wanted, true, ++blocks_made_});
    } else {
      ++counts.over_budget;
      EXPECT_TRUE(bytes_needed > budget_bytes_ || blocks.empty() || blocks.front().in_frame);
    }
    return true;
  }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Block& block : blocks) sum += block.bytes;
    return sum;
  }

 private:
  std::list<Block>::iterator with(std::size_t slot, const BlockContents& wanted) {
    return std::find_if(blocks.begin(), blocks.end(),
                        [&](const Block& block) { return block.slot == slot && block.contents == wanted; });
  }
  // The newest of the blocks that may be rebuilt.
  std::list<Block>::iterator stale(std::size_t slot, const BlockContents& wanted) {
    auto last = blocks.end();
    for (auto block = blocks.begin(); block != blocks.end(); ++block) {
      const bool is_stale = block->slot == slot && !block->in_frame &&
                            block->contents.texture == wanted.texture &&
                            (block->contents.lights != 0) == (wanted.lights != 0);
      if (is_stale && (last == blocks.end() || block->number > last->number)) last = block;
    }
    return last;
  }
  void use(std::list<Block>::iterator block) {
    block->in_frame = true;
    blocks.splice(blocks.end(), blocks, block);
  }
  std::size_t budget_bytes_ = 0;
  std::uint64_t blocks_made_ = 0;
};

// A lookup, and the byte that fills its block.
struct DrawnFrame {
  std::size_t slot;
  BlockContents contents;
  SurfaceShape shape;
  SurfaceBlock block;
};
std::byte fill_byte(const DrawnFrame& drawn) {
  return static_cast<std::byte>(drawn.slot * 31 + base::to_size(drawn.contents.texture) * 11 +
                                drawn.contents.style_values[0] * 7 + drawn.contents.lights * 5 + 1);
}

TEST(SurfaceCache, FollowsTheListThroughAnyFrames) {
  constexpr std::size_t kFaces = 30;
  const world::Level level = make_level(kFaces);
  for (int seed = 0; seed < effort(60, 6); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const std::size_t bytes_per_texel = random.chance(0.5) ? 1 : 4;
    // Every slot has one shape, like every tile of a face at a mip level.
    std::map<std::size_t, SurfaceShape> shapes;
    SurfaceCache cache;
    Expectation expected;
    for (int frame = 0; frame < 60; ++frame) {
      SCOPED_TRACE(fmt::format("seed {}, frame {}", seed, frame));
      const std::size_t budget_bytes = random.chance(0.9) ? 40000 * bytes_per_texel : random.below(100000);
      cache.begin_frame(level, bytes_per_texel, budget_bytes, true);
      expected.begin_frame(budget_bytes);
      // Within a frame, a face has one set of style values; texture and dynamic lights depend on the
      // instance.
      std::map<std::size_t, std::uint16_t> lights;
      std::vector<DrawnFrame> wanted(random.below(25)), found, missing;
      for (DrawnFrame& drawn : wanted) {
        drawn.slot = cache.slot(face(random.below(kFaces)), 0, static_cast<int>(random.below(2)));
        const auto light = static_cast<std::uint16_t>(random.below(3) == 0);
        drawn.contents =
            contents(lights.try_emplace(drawn.slot, light).first->second, random.below(2), random.below(3));
        const auto side = [&] { return static_cast<std::int32_t>(1 + random.below(64)); };
        drawn.shape = shapes.try_emplace(drawn.slot, SurfaceShape{side(), side()}).first->second;
        SurfaceCache::Lookup lookup;
        const bool hit = cache.find(drawn.slot, drawn.contents, lookup);
        ASSERT_EQ(hit, expected.find(drawn.slot, drawn.contents));
        drawn.block = hit ? lookup.block : SurfaceBlock{};
        (hit ? found : missing).push_back(drawn);
      }
      for (DrawnFrame& drawn : missing) {
        const render::CacheCounts before = cache.counts();
        const SurfaceCache::Lookup lookup = cache.reserve(drawn.slot, drawn.contents, drawn.shape);
        const Expectation::Outcome outcome = {cache.counts().evictions - before.evictions,
                                              cache.counts().over_budget == before.over_budget};
        const std::size_t bytes = drawn.shape.texels() * bytes_per_texel + render::kBlockPadding;
        ASSERT_EQ(lookup.must_build,
                  expected.reserve(drawn.slot, drawn.contents, allocated_bytes(drawn.shape, bytes_per_texel),
                                   outcome));
        drawn.block = lookup.block;
        if (lookup.must_build) std::fill_n(drawn.block.texels, bytes, fill_byte(drawn));
        found.push_back(drawn);
      }
      // All blocks of the frame stay until its end, and none overlaps another.
      for (const DrawnFrame& drawn : found) {
        ASSERT_EQ(drawn.block.shape.width, drawn.shape.width);
        ASSERT_EQ(drawn.block.shape.height, drawn.shape.height);
        const std::size_t bytes = drawn.shape.texels() * bytes_per_texel + render::kBlockPadding;
        ASSERT_EQ(std::count(drawn.block.texels, drawn.block.texels + bytes, fill_byte(drawn)),
                  static_cast<std::ptrdiff_t>(bytes));
      }
      ASSERT_EQ(cache.bytes_in_use(), expected.bytes());
      ASSERT_LE(cache.bytes_in_use(), budget_bytes);
      ASSERT_EQ(cache.counts().hits, expected.counts.hits);
      ASSERT_EQ(cache.counts().misses, expected.counts.misses);
      ASSERT_EQ(cache.counts().evictions, expected.counts.evictions);
      ASSERT_EQ(cache.counts().over_budget, expected.counts.over_budget);
    }
  }
}

// Blocks of all sizes come and go, and the gaps between them stay a small part.
TEST(SurfaceCache, FillsMostOfItsBudget) {
  constexpr std::size_t kFaces = 2000, kBudget = std::size_t{4} << 20;
  const world::Level level = make_level(kFaces);
  for (int seed = 0; seed < effort(10, 2); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<SurfaceShape> shapes;
    for (std::size_t i = 0; i < kFaces; ++i) {
      const auto side = [&] { return static_cast<std::int32_t>(16 * (1 + random.below(16))); };
      shapes.push_back({side(), side()});
    }
    SurfaceCache cache;
    double min_filled = 1;
    for (int frame = 0; frame < 200; ++frame) {
      cache.begin_frame(level, 1, kBudget, true);
      for (int i = 0; i < 40; ++i) {
        const std::size_t number = random.below(kFaces);
        SurfaceCache::Lookup lookup;
        const std::size_t slot = cache.slot(face(number), 0, 0);
        if (!cache.find(slot, {}, lookup)) cache.reserve(slot, {}, shapes[number]);
      }
      constexpr int kUntilFull = 20;
      const double filled = static_cast<double>(cache.bytes_in_use()) / kBudget;
      if (frame >= kUntilFull) min_filled = std::min(min_filled, filled);
    }
    EXPECT_GT(min_filled, 0.7) << "seed " << seed;
  }
}

}  // namespace
}  // namespace temblor::test
