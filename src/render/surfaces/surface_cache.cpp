#include "render/surfaces/surface_cache.h"

#include <algorithm>

#include "base/check.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

namespace {

// Views of wide places at 1920x1080 read from blocks of up to two million texels.
constexpr std::size_t kTexelsOfALargeView = std::size_t{4} << 20;

}  // namespace

void SurfaceCache::begin_frame(const world::Level& level, std::size_t bytes_per_texel,
                               std::size_t budget_bytes, bool enabled) {
  frame_blocks_.reset();
  const bool is_level_new = level_ != level.identity;
  if (is_level_new || bytes_per_texel_ != bytes_per_texel) forget();
  if (is_level_new) index_level(level);
  bytes_per_texel_ = bytes_per_texel;
  enabled_ = enabled;
  budget_bytes_ = budget_bytes;
  counts_ = {};
  ++frame_;
  while (bytes_in_use() > budget_bytes_) evict_oldest();
  pool_.set_capacity(budget_bytes_);
  // A level's first frame is part of loading it, and may take the time that later ones should not.
  if (is_level_new && enabled_) pool_.prepare(kTexelsOfALargeView * bytes_per_texel_);
}

void SurfaceCache::forget() {
  std::fill(first_of_slot_.begin(), first_of_slot_.end(), kNone);
  entries_.clear();
  free_entries_.clear();
  oldest_ = newest_ = kNone;
  pool_.clear();
}

void SurfaceCache::index_level(const world::Level& level) {
  level_ = level.identity;
  first_slot_.clear();
  std::size_t slots = 0;
  for (const world::Face& face : level.faces) {
    first_slot_.push_back(slots);
    const TileGrid tiles = tile_grid(face);
    slots += std::size_t{tiles.s} * tiles.t * 4;
  }
  first_of_slot_.assign(slots, kNone);
}

std::uint32_t SurfaceCache::entry_with(std::size_t slot, const BlockContents& contents) const {
  std::uint32_t number = first_of_slot_[slot];
  while (number != kNone && entries_[number].contents != contents) number = entries_[number].next_of_slot;
  return number;
}

// One that may be built anew: not of this frame, and most likely out of date for good.
std::uint32_t SurfaceCache::stale_entry(std::size_t slot, const BlockContents& contents) const {
  const auto is_stale = [&](const Entry& entry) {
    return entry.used_in_frame != frame_ && entry.contents.texture == contents.texture &&
           (entry.contents.lights == 0) == (contents.lights == 0);
  };
  std::uint32_t number = first_of_slot_[slot];
  while (number != kNone && !is_stale(entries_[number])) number = entries_[number].next_of_slot;
  return number;
}

bool SurfaceCache::find(std::size_t slot, const BlockContents& contents, Lookup& out_lookup) {
  if (!enabled_) return false;
  const std::uint32_t number = entry_with(slot, contents);
  if (number == kNone) return false;
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
  std::uint32_t number = entry_with(slot, contents);
  if (number != kNone) {
    DCHECK(entries_[number].used_in_frame == frame_);
    return {block_of(entries_[number]), false, false};
  }
  number = stale_entry(slot, contents);
  if (number == kNone) {
    const BlockPool::Room room = make_room(bytes_of(shape));
    if (room.begin == nullptr) {
      ++counts_.over_budget;
      return build_for_frame(shape);
    }
    number = new_entry(slot);
    entries_[number].room = room;
    entries_[number].shape = shape;
  }
  entries_[number].contents = contents;
  entries_[number].used_in_frame = frame_;
  make_newest(number);
  ++counts_.misses;
  return {block_of(entries_[number]), true, true};
}

// None when the blocks of this frame leave none.
BlockPool::Room SurfaceCache::make_room(std::size_t bytes) {
  BlockPool::Room room = pool_.allocate(bytes);
  if (BlockPool::rounded_up(bytes) > budget_bytes_) return room;
  while (room.begin == nullptr && oldest_ != kNone && entries_[oldest_].used_in_frame != frame_) {
    evict_oldest();
    room = pool_.allocate(bytes);
  }
  return room;
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
  while (*link != number) link = &entries_[*link].next_of_slot;
  *link = entry.next_of_slot;
  pool_.free(entry.room);
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
  entries_[number].next_of_slot = first_of_slot_[slot];
  first_of_slot_[slot] = number;
  return number;
}

SurfaceCache::Lookup SurfaceCache::build_for_frame(SurfaceShape shape) {
  ++counts_.misses;
  return {{frame_blocks_.allocate<std::byte>(bytes_of(shape)).data(), shape}, true, true};
}

}  // namespace temblor::render
