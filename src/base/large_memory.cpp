#include "base/large_memory.h"

#include <sys/mman.h>

namespace temblor::base {

LargeMemory<std::byte> allocate_large_bytes(std::size_t bytes, FirstTouch first_touch) {
  const bool large = bytes >= kLargePageBytes;
  const std::size_t unit = large ? kLargePageBytes : kCacheLineBytes;
  const std::align_val_t alignment{unit};
  // Round up, so that no other allocation shares the last unit.
  bytes = (bytes + unit - 1) / unit * unit;
  auto* memory = static_cast<std::byte*>(::operator new(bytes, alignment, std::nothrow));
  // Only a hint: without large pages everything works, but slower.
  if (large && memory != nullptr)
    madvise(memory, bytes, first_touch == FirstTouch::kInLargePages ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
  return {memory, FreeLargeMemory{alignment}};
}

}  // namespace temblor::base
