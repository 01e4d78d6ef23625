// Lit, textured surfaces kept between frames (Abrash, "Surface Caching"): a budget in bytes, and the least
// recently used go first. Blocks of the current frame are never evicted; what does not fit beside them lives
// until the frame's end only.
//
// A block stands for what it shows. One that shows something else than is asked for is built anew in its
// place, when it has the same texture; but blocks with dynamic light on them stand beside those without, so
// that a light that has gone leaves everything as it was before it came, and nothing to be built.
//
// The budget bounds the memory of what is kept, holes between blocks included: room for a block may cost more
// of the oldest than its size, until what they leave joins. (After the budget itself has shrunk, what was
// taken before is given back as it becomes empty.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/arena.h"
#include "render/surfaces/block_pool.h"
#include "render/surfaces/surface_block.h"

namespace temblor::render {

// What a block shows. A face may show several in one frame, on several instances of its brush model: with
// other textures, or near other lights.
struct BlockContents {
  world::TextureIndex texture{};
  std::array<std::uint16_t, 4> style_values{};
  bool colored = false;
  std::uint64_t lights = 0;  // hash of the dynamic lights on it; 0: none
  std::uint64_t marks = 0;   // revision of the marks on its face; 0: none
  bool operator==(const BlockContents&) const = default;
};

struct CacheCounts {
  std::uint32_t hits = 0, misses = 0, evictions = 0, over_budget = 0;
};

class SurfaceCache {
 public:
  // Forgets everything when the level or the format is not that of the last frame.
  void begin_frame(const world::Level& level, std::size_t bytes_per_texel, std::size_t budget_bytes,
                   bool enabled);
  // Drops all blocks; their memory stays, for those to come.
  void forget();

  struct Lookup {
    SurfaceBlock block;
    bool must_build;
    bool first_use;  // in this frame
  };
  // First for all blocks of a frame: the block when it is there and fresh, marked as used.
  bool find(std::size_t slot, const BlockContents& contents, Lookup& out_lookup);
  // Then for those not found: room for one, to be built unless it was reserved in this frame already. (One
  // that is there is found, so it must not be asked for here first.)
  Lookup reserve(std::size_t slot, const BlockContents& contents, SurfaceShape shape);

  // A face's slots, one for each tile and mip level.
  std::size_t slot(world::FaceIndex face, std::size_t tile, int mip) const {
    return first_slot_[base::to_size(face)] + tile * 4 + static_cast<std::size_t>(mip);
  }
  std::size_t bytes_in_use() const { return pool_.bytes_in_use(); }
  const CacheCounts& counts() const { return counts_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Entry {
    BlockPool::Room room;
    SurfaceShape shape{};
    BlockContents contents;
    std::size_t slot = 0;
    std::uint64_t used_in_frame = 0;
    std::uint32_t next_of_slot = kNone;  // with other contents
    std::uint32_t older = kNone, newer = kNone;
  };

  void index_level(const world::Level& level);
  SurfaceBlock block_of(const Entry& entry) const { return {entry.room.begin, entry.shape}; }
  std::uint32_t entry_with(std::size_t slot, const BlockContents& contents) const;
  std::uint32_t stale_entry(std::size_t slot, const BlockContents& contents) const;
  std::size_t bytes_of(SurfaceShape shape) const { return shape.texels() * bytes_per_texel_ + kBlockPadding; }
  BlockPool::Room make_room(std::size_t bytes);
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
  std::vector<std::size_t> first_slot_;       // by face
  std::vector<std::uint32_t> first_of_slot_;  // by slot: entry, or kNone
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> free_entries_;
  std::uint32_t oldest_ = kNone, newest_ = kNone;
  BlockPool pool_;
  base::Arena frame_blocks_;
  CacheCounts counts_;
};

}  // namespace temblor::render
