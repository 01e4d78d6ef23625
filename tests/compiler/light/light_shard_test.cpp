// Light that several processes share.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "compiler/light/light_level.h"
#include "compiler/light/lighting.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

const RoomSetup kRoom{
    "{ 'classname' 'light' 'origin' '10 0 0' '_color' '1 0.5 0.25' }"
    "{ 'classname' 'light' 'origin' '0 0 30' 'light' '80' 'delay' '4' 'targetname' 'a' }"
    "{ 'classname' 'light' 'origin' '0 30 0' 'light' '-50' }",
    "'_sunlight' '100' '_dirt' '1' '_bounce' '2'", true};

compiler::FaceKeys list_keys(const formats::Bsp& bsp) {
  return compiler::find_face_keys(bsp, formats::read_entities(bsp.entities).value());
}

// Continues from `begun`, and stops after `steps`.
compiler::LightShardBytes work_on_shard(const formats::Bsp& bsp, const compiler::LightShard& shard,
                                        const compiler::LightOptions& options, base::Bytes begun, int steps,
                                        int threads = 1) {
  base::Jobs jobs(threads, base::JobBackend::kStdThread);
  return compiler::light_shard(bsp, list_keys(bsp), options, shard, begun, jobs,
                               [&](std::size_t, std::size_t) { return --steps > 0; })
      .value();
}

base::ByteVector make_shard(const formats::Bsp& bsp, std::uint32_t index, std::uint32_t count,
                            const compiler::LightOptions& options = {}) {
  constexpr int kAllSteps = 1 << 20;
  const compiler::LightShardBytes made = work_on_shard(bsp, {index, count}, options, {}, kAllSteps);
  EXPECT_TRUE(made.is_finished);
  return made.bytes;
}

base::Result<compiler::LightSummary> merge(formats::Bsp& io_bsp, std::vector<base::Bytes> shards,
                                           const compiler::LightOptions& options = {}) {
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  compiler::Warnings warnings;
  std::vector<compiler::NamedShard> named;
  for (std::size_t i = 0; i < shards.size(); ++i) named.push_back({shards[i], fmt::format("file {}", i)});
  return compiler::merge_light(io_bsp, list_keys(io_bsp), options, named, jobs, warnings);
}

TEST(LightShards, MergeToTheSameBytes) {
  const formats::Bsp unlit = room_with(kRoom);
  const LitResult whole = light(unlit);
  for (const std::uint32_t count : {1u, 2u, 5u, 9u}) {
    std::vector<base::ByteVector> shards;
    // In reverse order.
    for (std::uint32_t i = count; i-- > 0;) shards.push_back(make_shard(unlit, i, count));
    formats::Bsp merged = unlit;
    const auto summary = merge(merged, {shards.begin(), shards.end()});
    ASSERT_TRUE(summary.ok()) << summary.error().message();
    EXPECT_EQ(merged, whole.bsp) << count << " shards";
    EXPECT_EQ(summary->lit, whole.summary.lit);
  }
}

TEST(LightShards, RejectMixedLevelsAndOptions) {
  const formats::Bsp unlit = room_with(kRoom);
  const base::ByteVector first = make_shard(unlit, 0, 2), second = make_shard(unlit, 1, 2);
  const base::ByteVector finer = make_shard(unlit, 1, 2, {.extra = 4});
  formats::Bsp other = unlit;
  other.entities += "{ \"classname\" \"light\" }";
  const base::ByteVector elsewhere = make_shard(other, 1, 2);
  formats::Bsp bsp = unlit;
  for (const std::vector<base::Bytes>& wrong :
       {std::vector<base::Bytes>{first}, {first, first}, {first, finer}, {first, elsewhere}, {}}) {
    const auto result = merge(bsp, wrong);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, base::ErrorCode::kUsage);
    EXPECT_EQ(bsp, unlit);
  }
  EXPECT_TRUE(merge(bsp, {first, second}).ok());
}

TEST(LightShards, ResumeToTheSameBytes) {
  const formats::Bsp unlit = room_with(kRoom);
  std::mt19937 random(3);
  for (int seed = 0; seed < effort(12, 3); ++seed) {
    const compiler::LightShard shard{static_cast<std::uint32_t>(random() % 2), 2};
    compiler::LightShardBytes made;
    int stops = -1;
    for (; !made.is_finished; ++stops) {
      const int steps = 1 + static_cast<int>(random() % 3), threads = 1 + static_cast<int>(random() % 2);
      formats::Bsp bsp = unlit;
      EXPECT_FALSE(merge(bsp, {made.bytes, make_shard(unlit, 1 - shard.index, 2)}).ok());
      EXPECT_EQ(bsp, unlit);
      const base::ByteVector begun = made.bytes;
      made = work_on_shard(unlit, shard, {}, begun, steps, threads);
    }
    EXPECT_GE(stops, 1);
    EXPECT_EQ(made.bytes, make_shard(unlit, shard.index, 2)) << stops << " stops";
    // A finished shard takes no further step.
    EXPECT_TRUE(work_on_shard(unlit, shard, {}, made.bytes, 0).is_finished);
  }
}

TEST(LightShards, IgnoreSavedBytesOfAnotherShard) {
  const formats::Bsp unlit = room_with(kRoom);
  formats::Bsp other = unlit;
  other.entities += "{ \"classname\" \"light\" \"origin\" \"20 20 20\" }";
  const base::ByteVector whole = make_shard(unlit, 0, 2);
  constexpr int kAllSteps = 1 << 20;
  for (const base::ByteVector& begun :
       {make_shard(other, 0, 2), make_shard(unlit, 1, 2), make_shard(unlit, 0, 3),
        make_shard(unlit, 0, 2, {.extra = 2}), base::ByteVector(40, std::byte{7})})
    EXPECT_EQ(work_on_shard(unlit, {0, 2}, {}, begun, kAllSteps).bytes, whole);
}

TEST(LightShards, RejectTruncation) {
  const formats::Bsp unlit = room_with(kRoom);
  const base::ByteVector shard = make_shard(unlit, 0, 1);
  formats::Bsp bsp = unlit;
  for (std::size_t size = 0; size < shard.size(); size += 1 + size / static_cast<std::size_t>(effort(60, 6)))
    ASSERT_FALSE(merge(bsp, {base::Bytes(shard).first(size)}).ok()) << size;
  base::ByteVector longer = shard;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(merge(bsp, {longer}).ok());
  EXPECT_EQ(bsp, unlit);
}

}  // namespace
}  // namespace temblor::test
