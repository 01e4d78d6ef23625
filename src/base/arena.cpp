#include "base/arena.h"

#include <algorithm>

namespace temblor::base {

namespace {

// The first block has twice this size, as each new block doubles the size of the last.
constexpr std::size_t kFirstBlockBytes = 64 * 1024;

std::size_t round_up_to_line(std::size_t bytes) {
  return (bytes + kCacheLineBytes - 1) / kCacheLineBytes * kCacheLineBytes;
}

}  // namespace

void Arena::add_block(std::size_t bytes) {
  Block block{allocate_large<std::byte>(bytes), bytes};
  CHECK(block.memory != nullptr, "no memory for {} bytes", bytes);
  blocks_.push_back(std::move(block));
}

// Rounding up keeps every allocation on its own cache lines, so that threads that fill neighboring arrays do
// not slow each other down.
std::byte* Arena::allocate_bytes(std::size_t bytes) {
  bytes = round_up_to_line(bytes);
  if (blocks_.empty() || used_ + bytes > blocks_.back().size) {
    const std::size_t last = blocks_.empty() ? kFirstBlockBytes : blocks_.back().size;
    used_before_ += used_;
    used_ = 0;
    add_block(std::max(bytes, last * 2));
  }
  std::byte* begin = blocks_.back().memory.get() + used_;
  used_ += bytes;
  return begin;
}

void Arena::reset() {
  if (blocks_.size() > 1) {
    std::size_t total = 0;
    for (const Block& block : blocks_) total += block.size;
    blocks_.clear();
    add_block(total);
  }
  used_ = 0;
  used_before_ = 0;
}

}  // namespace temblor::base
