#include "formats/levels/vis_patch.h"

#include <gtest/gtest.h>

#include "support/levels/vis_patch_bytes.h"

namespace temblor::formats {
namespace {

using test::vis_patch_bytes;

base::ByteVector joined(base::ByteVector first, const base::ByteVector& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(VisPatch, ReadsEachLevel) {
  const auto patches = read_vis_patches(
      joined(vis_patch_bytes("e1m1.bsp", {1, 2, 3}, {-1, 0, 2}), vis_patch_bytes("dm3.bsp", {}, {-1})));
  ASSERT_TRUE(patches.ok()) << patches.error().message();
  const std::vector<VisPatch> expected = {{"e1m1.bsp", {1, 2, 3}, {-1, 0, 2}}, {"dm3.bsp", {}, {-1}}};
  EXPECT_EQ(*patches, expected);
}

TEST(VisPatch, ReadsUpToADamagedOne) {
  const base::ByteVector first = vis_patch_bytes("e1m1.bsp", {1, 2, 3}, {-1, 0, 2});
  const base::ByteVector both = joined(first, vis_patch_bytes("dm3.bsp", {7}, {0}));
  for (std::size_t size = 0; size < both.size(); ++size) {
    const auto patches = read_vis_patches(base::Bytes(both).first(size));
    ASSERT_EQ(patches.ok(), size >= first.size()) << size;
    EXPECT_EQ(patches.ok() ? patches->size() : 0, size >= first.size() ? 1u : 0u) << size;
  }
}

TEST(VisPatch, ErrorsSayWhatIsWrong) {
  const auto what = [](const base::ByteVector& bytes) { return read_vis_patches(bytes).error().what; };
  const base::ByteVector good = vis_patch_bytes("e1m1.bsp", {1, 2, 3}, {0});
  const auto with_size = [&](std::size_t at, std::int32_t size) {
    base::ByteVector bytes = good;
    std::memcpy(&bytes[at], &size, sizeof size);
    return bytes;
  };
  EXPECT_EQ(what({}), "the patch at byte 0 is longer than the file");
  for (const std::int32_t size : {-1, 0x7fffffff, 40})
    EXPECT_EQ(what(with_size(32, size)), "the patch at byte 0 is longer than the file");
  for (const std::int32_t size : {-1, 0x7fffffff, 40})
    EXPECT_EQ(what(with_size(36, size)), "the patch at byte 0 is shorter than its visibility and leaves");
  EXPECT_EQ(what(with_size(43, 27)), "the patch at byte 0 has 27 bytes of leaves, not a multiple of 28");
}

TEST(VisPatch, FitsOneVersionOfALevel) {
  Bsp bsp;
  bsp.visibility = {9};
  bsp.leaves.resize(3);
  const auto apply = [&bsp](std::vector<std::int32_t> offsets) {
    return apply_vis_patch({.level = "", .visibility = {1, 2, 3}, .leaf_offsets = std::move(offsets)}, bsp);
  };
  EXPECT_EQ(apply({-1, 0}).error().what, "2 leaves, but this version of the level has 3");
  EXPECT_EQ(apply({-1, 3, 0}).error().what, "leaf 1: visibility at byte 3 of 3");
  EXPECT_EQ(apply({-1, 0, -2}).error().what, "leaf 2: visibility at byte -2 of 3");
  EXPECT_EQ(bsp.visibility, (std::vector<std::uint8_t>{9})) << "the level is as before";
  ASSERT_TRUE(apply({-1, 2, 0}).ok());
  EXPECT_EQ(bsp.visibility, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(bsp.leaves[1].visibility_offset, 2);
}

}  // namespace
}  // namespace temblor::formats
