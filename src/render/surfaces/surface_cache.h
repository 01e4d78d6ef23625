// The surface cache: lit, textured surface blocks that are kept between frames, up to a budget in bytes. The
// least recently used block is evicted first. Blocks of the current frame are never evicted; a block that
// does not fit beside them lives only until the end of the frame.
//
// A block is identified by its slot (face, tile, mip level) and its contents. If a slot's block has other
// contents than requested, it is rebuilt in place if it has the same texture. But blocks with dynamic light
// are kept beside those without: when a light has passed, the blocks without it are still there and nothing
// has to be rebuilt. (Stock Quake has one block per slot and rebuilds it when a light comes and when it
// goes.)
//
//   slot -> entry -> entry -> ...     linked by next_in_slot: same tile and mip level, different contents
//   oldest_ <-> entry <-> ... <-> newest_     linked by older and newer, by last use
//
// The budget bounds the memory that is kept, gaps between blocks included, so a new block may evict more than
// its own size until the free ranges merge. After the budget was lowered, memory beyond it is given back as
// it becomes empty.
//
// Method: Michael Abrash, "Quake's Lighting Model: Surface Caching" (Graphics Programming Black Book, chapter
// 68).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/arena.h"
#include "render/settings.h"
#include "render/surfaces/block_pool.h"
#include "render/surfaces/surface_block.h"

namespace temblor::render {

// The contents of a block. A face may need several in one frame, for several instances of its brush model:
// with different textures, or near different lights.
struct BlockContents {
  world::TextureIndex texture{};
  std::array<std::uint16_t, 4> style_values{};  // of the face's light styles; 256: the light as stored
  bool colored = false;
  LightView light_view = LightView::kLit;
  float warp_phase = 0;            // of a liquid, in texels (warped_rows.h); 0 for other faces
  std::uint32_t caustic_step = 0;  // of the caustics on it (caustics.h); 0: none
  std::uint64_t lights = 0;        // hash of the dynamic lights on it; 0: none
  std::uint64_t marks = 0;         // revision of the marks on its face; 0: none
  bool operator==(const BlockContents&) const = default;
};

// Counts of the current frame.
struct CacheCounts {
  std::uint32_t hits = 0, misses = 0, evictions = 0, over_budget = 0;
};

// Use once per frame: begin_frame, then find for all blocks, then reserve for those that were not found.
class SurfaceCache {
 public:
  // Empties the cache if the level or the pixel format is not that of the last frame, and evicts down to the
  // budget. Disabled, it keeps nothing: every block is built for the frame.
  void begin_frame(const world::Level& level, std::size_t bytes_per_texel, std::size_t budget_bytes,
                   bool enabled);
  // Drops all blocks, but keeps their memory for new ones.
  void clear();

  // The result of find and reserve.
  struct Lookup {
    SurfaceBlock block;
    bool must_build;  // the caller must build the block
    bool first_use;   // the first use of the block in this frame
  };
  // Returns whether the block is in the cache with these contents, and marks it as used in this frame.
  bool find(std::size_t slot, const BlockContents& contents, Lookup& out_lookup);
  // Memory for a block that find() did not find. The block must be built, unless it was reserved earlier in
  // this frame. (Must not be called for a block that find() would find.)
  Lookup reserve(std::size_t slot, const BlockContents& contents, SurfaceShape shape);

  // The slot of a face's tile at a mip level.
  std::size_t slot(world::FaceIndex face, std::size_t tile, int mip) const {
    return first_slot_[base::to_size(face)] + tile * slots_per_tile_ +
           static_cast<std::size_t>(mip - finest_mip_);
  }
  std::size_t bytes_in_use() const { return pool_.bytes_in_use(); }
  const CacheCounts& counts() const { return counts_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  // A block in the cache, or a free element of entries_.
  struct Entry {
    BlockPool::Allocation allocation;
    SurfaceShape shape{};
    BlockContents contents;
    std::size_t slot = 0;
    std::uint64_t used_in_frame = 0;
    std::uint32_t next_in_slot = kNone;
    std::uint32_t older = kNone, newer = kNone;
  };

  void index_level(const world::Level& level);
  SurfaceBlock entry_block(const Entry& entry) const { return {entry.allocation.begin, entry.shape}; }
  std::uint32_t entry_with(std::size_t slot, const BlockContents& contents) const;
  std::uint32_t stale_entry(std::size_t slot, const BlockContents& contents) const;
  std::size_t block_bytes(SurfaceShape shape) const {
    return shape.texels() * bytes_per_texel_ + kBlockPadding;
  }
  BlockPool::Allocation allocate_or_evict(std::size_t bytes);
  void make_newest(std::uint32_t entry);
  void unlink(std::uint32_t entry);
  void evict_oldest();
  std::uint32_t new_entry(std::size_t slot);
  Lookup build_for_frame(SurfaceShape shape);

  std::shared_ptr<const world::LevelIdentity> level_;
  std::size_t bytes_per_texel_ = 1;
  std::size_t budget_bytes_ = 0;
  bool enabled_ = true;
  std::uint64_t frame_ = 0;
  int finest_mip_ = 0;                        // of any texture of the level
  std::size_t slots_per_tile_ = 4;            // one for each mip level, finest_mip_ to 3
  std::vector<std::size_t> first_slot_;       // by face
  std::vector<std::uint32_t> first_of_slot_;  // by slot: its first entry, or kNone
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> free_entries_;
  std::uint32_t oldest_ = kNone, newest_ = kNone;
  BlockPool pool_;
  base::Arena frame_blocks_;  // blocks that live only until the end of the frame
  CacheCounts counts_;
};

}  // namespace temblor::render
