// Memory that lives for one frame: bump allocation, freed all at once. After a frame that overflowed its
// first block the blocks become one of their total size, so a warm frame asks the heap for nothing.
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

  // Uninitialized room for `count` objects, 64-byte aligned; valid until reset().
  template <typename T>
  std::span<T> allocate(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T> && std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<T*>(allocate_bytes(count * sizeof(T))), count};
  }
  template <typename T>
  std::span<T> allocate_filled(std::size_t count, T value) {
    std::span<T> room = allocate<T>(count);
    for (T& element : room) element = value;
    return room;
  }

  void reset();
  std::size_t used_bytes() const { return used_before_ + used_; }

 private:
  struct Block {
    LargeMemory<std::byte> memory;
    std::size_t size = 0;
  };
  std::byte* allocate_bytes(std::size_t bytes);
  void add_block(std::size_t bytes);

  std::vector<Block> blocks_;
  std::size_t used_ = 0;         // of the last block
  std::size_t used_before_ = 0;  // of the blocks before it
};

// A growing array on an arena. The arena must outlive it; growth leaves the old copy behind until reset().
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
  void shrink(std::size_t size) { size_ = size; }  // size <= size()
  // New elements are uninitialized.
  void resize(std::size_t size) {
    if (size > room_.size()) [[unlikely]]
      grow(size * 2);
    size_ = size;
  }
  // Adds `count` uninitialized elements and returns the first.
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
