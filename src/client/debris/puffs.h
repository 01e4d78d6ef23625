// Small pictures that drift, grow, and fade: smoke, dust, rings on water, and bubbles. The place at a time is
// computed from the age, so the frame rate does not change it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "math/vec.h"

namespace temblor::client {

// The order of ModelTable's puffs.
enum class PuffPicture : std::uint8_t { kSmoke, kDust, kRing, kBubble };

// A puff at its birth, which may be later than the time at which it is added.
struct PuffSpawn {
  PuffPicture picture{};
  math::Vec3 origin_world{0.0f};
  math::Vec3 velocity{0.0f};  // units per second; the air stops it within a second
  float rise = 0;             // units per second, constant
  math::Vec3 angles_deg{0.0f};
  double born_s = 0, life_s = 1;
  float first_scale = 1, last_scale = 1;
  float opacity = 1;  // at birth; fades to 0
};

// A puff to draw. `age` is 0 at birth and 1 at the end; sprites with several frames run through them.
struct Puff {
  PuffPicture picture{};
  math::Vec3 origin_world{0.0f}, angles_deg{0.0f};
  float scale = 1, alpha = 1, age = 0;
};

class Puffs {
 public:
  // With this many, a new puff replaces the one that ends first.
  static constexpr std::size_t kMaxPuffs = 128;

  void clear() { size_ = shown_count_ = 0; }
  void add(const PuffSpawn& puff);
  // Removes old puffs and moves the others to their places at `time_s`.
  void advance(double time_s);
  // The puffs as of the last advance(). Valid until anything changes.
  std::span<const Puff> puffs() const { return {shown_.data(), shown_count_}; }

 private:
  std::size_t size_ = 0, shown_count_ = 0;
  std::array<PuffSpawn, kMaxPuffs> spawned_;
  std::array<Puff, kMaxPuffs> shown_;
};

}  // namespace temblor::client
