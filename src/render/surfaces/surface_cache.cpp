#include "render/surfaces/surface_cache.h"

#include "base/check.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

void SurfaceCache::begin_frame(const world::Level& level, std::size_t bytes_per_texel,
                               std::size_t budget_bytes, bool enabled) {
  frame_blocks_.clear();
  if (level_ != level.identity || bytes_per_texel_ != bytes_per_texel) {
    forget();
    bytes_per_texel_ = bytes_per_texel;
    index_level(level);
  }
  enabled_ = enabled;
  budget_bytes_ = budget_bytes;
  counts_ = {};
  ++frame_;
  for (; oldest_ != kNone && bytes_in_use_ > budget_bytes_; ++counts_.evictions) evict(oldest_);
}

void SurfaceCache::forget() {
  level_.reset();
  first_slot_.clear();
  entry_of_slot_.clear();
  entries_.clear();
  free_entries_.clear();
  frame_blocks_.clear();
  oldest_ = newest_ = kNone;
  bytes_in_use_ = 0;
}

void SurfaceCache::index_level(const world::Level& level) {
  level_ = level.identity;
  std::size_t slots = 0;
  for (const world::Face& face : level.faces) {
    first_slot_.push_back(slots);
    const TileGrid tiles = tile_grid(face);
    slots += std::size_t{tiles.s} * tiles.t * 4;
  }
  entry_of_slot_.assign(slots, kNone);
}

bool SurfaceCache::find(std::size_t slot, const BlockContents& contents, Lookup& out_lookup) {
  if (!enabled_) return false;
  const std::uint32_t number = entry_of_slot_[slot];
  if (number == kNone || entries_[number].contents != contents) return false;
  const bool first_use = entries_[number].used_in_frame != frame_;
  entries_[number].used_in_frame = frame_;
  make_newest(number);
  out_lookup = {block_of(entries_[number]), false, first_use};
  counts_.hits += first_use;
  return true;
}

SurfaceCache::Lookup SurfaceCache::reserve(std::size_t slot, const BlockContents& contents,
                                           SurfaceShape shape) {
  if (!enabled_) return build_for_frame(shape);
  std::uint32_t number = entry_of_slot_[slot];
  if (number != kNone && entries_[number].used_in_frame == frame_) {
    // Another instance of the same brush model shows this face with another texture.
    if (entries_[number].contents == contents) return {block_of(entries_[number]), false, false};
    return build_for_frame(shape);
  }
  if (number == kNone) {
    const std::size_t bytes = shape.texels() * bytes_per_texel_ + kBlockPadding;
    while (bytes <= budget_bytes_ && bytes_in_use_ + bytes > budget_bytes_ && oldest_ != kNone &&
           entries_[oldest_].used_in_frame != frame_) {
      evict(oldest_);
      ++counts_.evictions;
    }
    if (bytes_in_use_ + bytes > budget_bytes_) {
      ++counts_.over_budget;
      return build_for_frame(shape);
    }
    number = new_entry();
    Entry& entry = entries_[number];
    entry.texels = std::make_unique_for_overwrite<std::byte[]>(bytes);
    entry.bytes = bytes;
    entry.shape = shape;
    entry.slot = slot;
    entry_of_slot_[slot] = number;
    bytes_in_use_ += bytes;
  }
  entries_[number].contents = contents;
  entries_[number].used_in_frame = frame_;
  make_newest(number);
  ++counts_.misses;
  return {block_of(entries_[number]), true, true};
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

void SurfaceCache::evict(std::uint32_t number) {
  unlink(number);
  Entry& entry = entries_[number];
  entry_of_slot_[entry.slot] = kNone;
  bytes_in_use_ -= entry.bytes;
  entry = Entry{};
  free_entries_.push_back(number);
}

std::uint32_t SurfaceCache::new_entry() {
  if (free_entries_.empty()) {
    entries_.emplace_back();
    return static_cast<std::uint32_t>(entries_.size() - 1);
  }
  const std::uint32_t number = free_entries_.back();
  free_entries_.pop_back();
  return number;
}

SurfaceCache::Lookup SurfaceCache::build_for_frame(SurfaceShape shape) {
  ++counts_.misses;
  frame_blocks_.push_back(
      std::make_unique_for_overwrite<std::byte[]>(shape.texels() * bytes_per_texel_ + kBlockPadding));
  return {{frame_blocks_.back().get(), shape}, true, true};
}

}  // namespace temblor::render
