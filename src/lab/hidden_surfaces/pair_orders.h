// The order of pairs of faces, cached from frame to frame.
//
// If face B lies completely in front of the plane of face A, then no eye that sees the front of A sees a part
// of B behind A:
//
//        B |            A ---------   B is in front, wherever the eye is
//          |
//      --------- A          B |       A is in front
//                             |
//
// So the order of such a pair never changes, neither within a frame nor between frames, and a cached result
// needs no check. The same applies to two faces of one brush model, wherever it moves. Other pairs are
// compared by 1/z every time: if each face crosses the other's plane, the order depends on the eye. If both
// are in front of each other, or both behind, no pixel shows one through the other, but they may touch. Then
// the order matters for the face that takes the place of one of them across a shared edge (DepthRule).
//
// Method: Michael Abrash, "Sorted Spans in Action" (Graphics Programming Black Book, chapter 67), mentions
// that the order of a pair can be cached. The article does not say how.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lab/hidden_surfaces/depth_stack.h"

namespace temblor::lab {

// Which face of a pair is nearer where both cover a pixel.
enum class PairOrder : std::uint8_t { kUnknown, kFirst, kSecond, kDepends };

// Computes the order from the planes and corners of two faces of one model.
PairOrder order_faces(const world::Level& level, world::FaceIndex first, world::FaceIndex second);

// A table with one place for each pair; pairs with the same hash replace each other. Several threads may use
// it at once: an order depends on nothing but the pair, so it does not matter which of them stores it.
class PairOrders {
 public:
  // `places` is rounded up to a power of two.
  explicit PairOrders(std::size_t places);

  // Empties the table if it has pairs of another level, or if `keeps_pairs` is false.
  void use_level(const world::Level& level, bool keeps_pairs);

  // kUnknown if the table does not have the pair. `first` < `second`.
  PairOrder find(world::FaceIndex first, world::FaceIndex second) const {
    const std::uint64_t pair = make_pair(first, second);
    const std::uint64_t found = places_[place(pair)].load(std::memory_order_relaxed);
    return found >> 2 == pair ? static_cast<PairOrder>(found & 3) : PairOrder::kUnknown;
  }
  void store(world::FaceIndex first, world::FaceIndex second, PairOrder order) {
    const std::uint64_t pair = make_pair(first, second);
    places_[place(pair)].store(pair << 2 | static_cast<std::uint64_t>(order), std::memory_order_relaxed);
  }
  std::size_t size_bytes() const { return places_.size() * sizeof(places_[0]); }

 private:
  // 31 bits for each face. A level file with more faces would have 40 GB.
  static std::uint64_t make_pair(world::FaceIndex first, world::FaceIndex second) {
    return static_cast<std::uint64_t>(first) << 31 | static_cast<std::uint64_t>(second);
  }
  // The upper bits of a product with 2^64 divided by the golden ratio (Knuth, "The Art of Computer
  // Programming", 6.4).
  std::size_t place(std::uint64_t pair) const {
    return static_cast<std::size_t>(pair * 0x9e3779b97f4a7c15u >> shift_);
  }

  std::vector<std::atomic<std::uint64_t>> places_;  // 0: empty
  int shift_;
  std::shared_ptr<const world::LevelIdentity> level_;
};

// Compares surfaces by the cached order of their faces, or else by 1/z.
class CachedOrder {
 public:
  // `level` may be null: then everything is compared by 1/z.
  CachedOrder(const DepthOrder& depths, const world::Level* level,
              std::span<const render::ScreenSurface> surfaces, PairOrders& io_pairs)
      : depths_(depths), level_(level), surfaces_(surfaces), pairs_(&io_pairs) {}

  BegunSurface begin(render::SurfaceIndex surface, double x, int row) const {
    return depths_.begin(surface, x, row);
  }
  bool is_nearer(const BegunSurface& begun, render::SurfaceIndex other);
  bool keeps_mesh() const { return depths_.keeps_mesh(); }
  // Comparisons by planes or 1/z, and those that the cache spared.
  Counts counts() const;

 private:
  DepthOrder depths_;
  const world::Level* level_;
  std::span<const render::ScreenSurface> surfaces_;
  PairOrders* pairs_;
  std::uint64_t hits_ = 0, misses_ = 0;
};

}  // namespace temblor::lab
