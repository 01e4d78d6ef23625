// Feeds arbitrary bytes to the reader of visibility patches. It must return an error or patches whose data
// are no larger than the file, and a level must accept one only if all its visibility offsets stay in range.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/levels/vis_patch.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_vis_patch(const std::uint8_t* data, std::size_t size) {
  using namespace temblor::formats;
  const auto patches = read_vis_patches(std::as_bytes(std::span(data, size)));
  if (!patches.ok()) return 0;
  std::size_t bytes = 0;
  for (const VisPatch& patch : *patches) {
    bytes += patch.visibility.size() + patch.leaf_offsets.size() * sizeof(std::int32_t);
    Bsp bsp;
    bsp.leaves.resize(patch.leaf_offsets.size());
    if (!apply_vis_patch(patch, bsp).ok()) continue;
    for (const BspLeaf& leaf : bsp.leaves)
      CHECK(leaf.visibility_offset >= -1 &&
            leaf.visibility_offset < static_cast<std::int64_t>(bsp.visibility.size()));
  }
  CHECK(bytes <= size);
  return 0;
}
