#include "formats/levels/vis_patch.h"

#include <algorithm>
#include <optional>

namespace temblor::formats {
namespace {

constexpr std::size_t kNameBytes = 32;
constexpr std::size_t kLeafBytes = 28, kOffsetInLeaf = 4;

// Reads a size and that many bytes; nullopt if it is negative or larger than the rest.
std::optional<base::Bytes> take_sized(base::ByteReader& io_reader) {
  const std::int32_t size = io_reader.i32();
  if (!io_reader.ok() || size < 0) return std::nullopt;
  const base::Bytes bytes = io_reader.take(static_cast<std::size_t>(size));
  if (!io_reader.ok()) return std::nullopt;
  return bytes;
}

base::Result<VisPatch> read_patch(base::ByteReader& io_reader) {
  const std::size_t begin = io_reader.offset();
  VisPatch patch{.level = io_reader.fixed_text(kNameBytes), .visibility = {}, .leaf_offsets = {}};
  const auto content = take_sized(io_reader);
  if (!content) return base::malformed("the patch at byte {} is longer than the file", begin);
  base::ByteReader parts(*content);
  const auto visibility = take_sized(parts);
  const auto leaves = visibility ? take_sized(parts) : std::nullopt;
  if (!leaves)
    return base::malformed("the patch at byte {} is shorter than its visibility and leaves", begin);
  if (leaves->size() % kLeafBytes != 0)
    return base::malformed("the patch at byte {} has {} bytes of leaves, not a multiple of {}", begin,
                           leaves->size(), kLeafBytes);
  const auto rows = base::as_u8(*visibility);
  patch.visibility.assign(rows.begin(), rows.end());
  for (std::size_t at = 0; at < leaves->size(); at += kLeafBytes)
    patch.leaf_offsets.push_back(base::ByteReader(leaves->subspan(at + kOffsetInLeaf)).i32());
  return patch;
}

}  // namespace

base::Result<std::vector<VisPatch>> read_vis_patches(base::Bytes bytes) {
  std::vector<VisPatch> patches;
  base::ByteReader reader(bytes);
  do {
    base::Result<VisPatch> patch = read_patch(reader);
    if (!patch.ok()) {
      if (patches.empty()) return patch.error();
      break;
    }
    patches.push_back(std::move(patch).value());
  } while (reader.remaining() > 0);
  return patches;
}

base::Status apply_vis_patch(const VisPatch& patch, Bsp& io_bsp) {
  if (patch.leaf_offsets.size() != io_bsp.leaves.size())
    return base::malformed("{} leaves, but this version of the level has {}", patch.leaf_offsets.size(),
                           io_bsp.leaves.size());
  const auto end = static_cast<std::int64_t>(patch.visibility.size());
  const auto outside = std::ranges::find_if(
      patch.leaf_offsets, [end](std::int32_t offset) { return offset < -1 || offset >= end; });
  if (outside != patch.leaf_offsets.end())
    return base::malformed("leaf {}: visibility at byte {} of {}", outside - patch.leaf_offsets.begin(),
                           *outside, end);
  io_bsp.visibility = patch.visibility;
  for (std::size_t leaf = 0; leaf < io_bsp.leaves.size(); ++leaf)
    io_bsp.leaves[leaf].visibility_offset = patch.leaf_offsets[leaf];
  return base::Ok{};
}

}  // namespace temblor::formats
