// Bump allocator for memory that lives for one frame and is freed all at once.
//
// An arena is a list of blocks, each at least twice as large as the one before. Only the last block has free
// space:
//
//   | block 0: full | block 1: full | block 2: used_ bytes | free |
//
// After a frame that needed several blocks, reset() replaces them with one block of their total size. So
// after a few frames, a frame allocates nothing from the heap. Not thread-safe: each thread uses its own
// arena.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "base/check.h"
#include "base/large_memory.h"

namespace temblor::base {

class Arena {
 public:
  Arena() = default;
  Arena(Arena&&) noexcept = default;
  Arena& operator=(Arena&&) noexcept = default;

  // Returns memory for `count` uninitialized objects, aligned to 64 bytes, valid until reset(). No destructor
  // runs, so T must be trivial. Aborts the program if memory is exhausted.
  template <typename T>
  std::span<T> allocate(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T> && std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<T*>(allocate_bytes(count * sizeof(T))), count};
  }
  // Returns memory for `count` copies of `value`.
  template <typename T>
  std::span<T> allocate_filled(std::size_t count, T value) {
    std::span<T> room = allocate<T>(count);
    for (T& element : room) element = value;
    return room;
  }

  // Frees everything: all spans and ArenaVectors of this arena become invalid. Keeps the memory for the next
  // frame.
  void reset();
  // Bytes allocated since the last reset(), including padding, without the unused ends of full blocks.
  std::size_t used_bytes() const { return used_before_ + used_; }

 private:
  struct Block {
    LargeMemory<std::byte> memory;
    std::size_t size = 0;
  };
  std::byte* allocate_bytes(std::size_t bytes);
  void add_block(std::size_t bytes);

  std::vector<Block> blocks_;
  // Bytes used in the last block, and in all blocks before it.
  std::size_t used_ = 0;
  std::size_t used_before_ = 0;
};

// A growing array in an arena, which must outlive it. Growing leaves the old copy in the arena until reset(),
// so reserve a realistic capacity. Like Arena, only for trivial types; access is not bounds-checked. A
// default-constructed vector has no arena and must not grow.
template <typename T>
class ArenaVector {
 public:
  ArenaVector() = default;
  explicit ArenaVector(Arena& arena, std::size_t capacity = 64)
      : arena_(&arena), room_(arena.allocate<T>(capacity)) {}

  void push_back(const T& value) {
    if (size_ == room_.size()) [[unlikely]]
      grow(size_ * 2 + 16);
    room_[size_++] = value;
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  // Removes elements from the end. `size` must not exceed size().
  void shrink(std::size_t size) { size_ = size; }
  // New elements are uninitialized.
  void resize(std::size_t size) {
    if (size > room_.size()) [[unlikely]]
      grow(size * 2);
    size_ = size;
  }
  // Adds `count` uninitialized elements and returns a pointer to the first, valid until the next growth.
  T* extend(std::size_t count) {
    const std::size_t begin = size_;
    resize(begin + count);
    return room_.data() + begin;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return room_.data(); }
  const T* data() const { return room_.data(); }
  T& operator[](std::size_t i) { return room_[i]; }
  const T& operator[](std::size_t i) const { return room_[i]; }
  T& back() { return room_[size_ - 1]; }
  T* begin() { return room_.data(); }
  T* end() { return room_.data() + size_; }
  const T* begin() const { return room_.data(); }
  const T* end() const { return room_.data() + size_; }
  std::span<const T> view() const { return room_.first(size_); }
  std::span<T> view() { return room_.first(size_); }

 private:
  void grow(std::size_t capacity) {
    std::span<T> larger = arena_->allocate<T>(capacity);
    if (size_ > 0) std::memcpy(larger.data(), room_.data(), size_ * sizeof(T));
    room_ = larger;
  }

  Arena* arena_ = nullptr;
  std::span<T> room_;
  std::size_t size_ = 0;
};

}  // namespace temblor::base
