#include "render/surfaces/surface_cache.h"

#include <algorithm>

#include "base/check.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

namespace {

// Views of large rooms at 1920x1080 read from blocks of up to two million texels; this is twice that.
constexpr std::size_t kLargeViewTexels = std::size_t{4} << 20;

}  // namespace

void SurfaceCache::begin_frame(const world::Level& level, std::size_t bytes_per_texel,
                               std::size_t budget_bytes, bool enabled) {
  frame_blocks_.reset();
  const bool is_level_new = level_ != level.identity;
  if (is_level_new || bytes_per_texel_ != bytes_per_texel) clear();
  if (is_level_new) index_level(level);
  bytes_per_texel_ = bytes_per_texel;
  enabled_ = enabled;
  budget_bytes_ = budget_bytes;
  counts_ = {};
  ++frame_;
  while (bytes_in_use() > budget_bytes_) evict_oldest();
  pool_.set_capacity(budget_bytes_);
  // The first frame of a level is part of loading it, so it may spend time that later frames should not.
  if (is_level_new && enabled_) pool_.prepare(kLargeViewTexels * bytes_per_texel_);
}

void SurfaceCache::clear() {
  std::fill(first_of_slot_.begin(), first_of_slot_.end(), kNone);
  entries_.clear();
  free_entries_.clear();
  oldest_ = newest_ = kNone;
  pool_.clear();
}

void SurfaceCache::index_level(const world::Level& level) {
  level_ = level.identity;
  finest_mip_ = 0;
  for (const world::Texture& texture : level.textures)
    finest_mip_ = std::min(finest_mip_, texture.finest_mip());
  slots_per_tile_ = static_cast<std::size_t>(4 - finest_mip_);
  first_slot_.clear();
  std::size_t slots = 0;
  for (const world::Face& face : level.faces) {
    first_slot_.push_back(slots);
    const TileGrid tiles = tile_grid(face);
    slots += std::size_t{tiles.s} * tiles.t * slots_per_tile_;
  }
  first_of_slot_.assign(slots, kNone);
}

std::uint32_t SurfaceCache::entry_with(std::size_t slot, const BlockContents& contents) const {
  std::uint32_t number = first_of_slot_[slot];
  while (number != kNone && entries_[number].contents != contents) number = entries_[number].next_in_slot;
  return number;
}

// An entry that may be rebuilt with new contents: not used in this frame, and probably out of date forever,
// because its texture is the same and it also has (or also lacks) dynamic light.
std::uint32_t SurfaceCache::stale_entry(std::size_t slot, const BlockContents& contents) const {
  const auto is_stale = [&](const Entry& entry) {
    return entry.used_in_frame != frame_ && entry.contents.texture == contents.texture &&
           (entry.contents.lights == 0) == (contents.lights == 0);
  };
  std::uint32_t number = first_of_slot_[slot];
  while (number != kNone && !is_stale(entries_[number])) number = entries_[number].next_in_slot;
  return number;
}

bool SurfaceCache::find(std::size_t slot, const BlockContents& contents, Lookup& out_lookup) {
  if (!enabled_) return false;
  const std::uint32_t number = entry_with(slot, contents);
  if (number == kNone) return false;
  const bool first_use = entries_[number].used_in_frame != frame_;
  entries_[number].used_in_frame = frame_;
  make_newest(number);
  out_lookup = {entry_block(entries_[number]), false, first_use};
  counts_.hits += first_use;
  return true;
}

SurfaceCache::Lookup SurfaceCache::reserve(std::size_t slot, const BlockContents& contents,
                                           SurfaceShape shape) {
  if (!enabled_) return build_for_frame(shape);
  std::uint32_t number = entry_with(slot, contents);
  if (number != kNone) {
    DCHECK(entries_[number].used_in_frame == frame_);
    return {entry_block(entries_[number]), false, false};
  }
  number = stale_entry(slot, contents);
  if (number == kNone) {
    const BlockPool::Allocation allocation = allocate_or_evict(block_bytes(shape));
    if (allocation.begin == nullptr) {
      ++counts_.over_budget;
      return build_for_frame(shape);
    }
    number = new_entry(slot);
    entries_[number].allocation = allocation;
    entries_[number].shape = shape;
  }
  entries_[number].contents = contents;
  entries_[number].used_in_frame = frame_;
  make_newest(number);
  ++counts_.misses;
  return {entry_block(entries_[number]), true, true};
}

// Evicts the least recently used blocks until the allocation succeeds. Fails when only blocks of this frame
// are left, or at once if the block exceeds the whole budget.
BlockPool::Allocation SurfaceCache::allocate_or_evict(std::size_t bytes) {
  BlockPool::Allocation allocation = pool_.allocate(bytes);
  if (BlockPool::rounded_up(bytes) > budget_bytes_) return allocation;
  while (allocation.begin == nullptr && oldest_ != kNone && entries_[oldest_].used_in_frame != frame_) {
    evict_oldest();
    allocation = pool_.allocate(bytes);
  }
  return allocation;
}

void SurfaceCache::unlink(std::uint32_t number) {
  Entry& entry = entries_[number];
  if (entry.older != kNone) entries_[entry.older].newer = entry.newer;
  if (entry.newer != kNone) entries_[entry.newer].older = entry.older;
  if (oldest_ == number) oldest_ = entry.newer;
  if (newest_ == number) newest_ = entry.older;
  entry.older = entry.newer = kNone;
}

void SurfaceCache::make_newest(std::uint32_t number) {
  if (newest_ == number) return;
  unlink(number);
  entries_[number].older = newest_;
  if (newest_ != kNone) entries_[newest_].newer = number;
  newest_ = number;
  if (oldest_ == kNone) oldest_ = number;
}

void SurfaceCache::evict_oldest() {
  const std::uint32_t number = oldest_;
  unlink(number);
  Entry& entry = entries_[number];
  std::uint32_t* link = &first_of_slot_[entry.slot];
  while (*link != number) link = &entries_[*link].next_in_slot;
  *link = entry.next_in_slot;
  pool_.free(entry.allocation);
  entry = Entry{};
  free_entries_.push_back(number);
  ++counts_.evictions;
}

std::uint32_t SurfaceCache::new_entry(std::size_t slot) {
  std::uint32_t number = static_cast<std::uint32_t>(entries_.size());
  if (free_entries_.empty()) {
    entries_.emplace_back();
  } else {
    number = free_entries_.back();
    free_entries_.pop_back();
  }
  entries_[number].slot = slot;
  entries_[number].next_in_slot = first_of_slot_[slot];
  first_of_slot_[slot] = number;
  return number;
}

// A block outside the cache, in an arena that is reset when the next frame begins.
SurfaceCache::Lookup SurfaceCache::build_for_frame(SurfaceShape shape) {
  ++counts_.misses;
  return {{frame_blocks_.allocate<std::byte>(block_bytes(shape)).data(), shape}, true, true};
}

}  // namespace temblor::render
