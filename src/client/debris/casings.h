// Empty casings that guns throw out: they fly, bounce, roll to rest, and fade.
//
//   thrown  o--.                 a leg is a parabola; each bounce starts the next one,
//               \    .-.         and the last leg lies still
//                \  /   \  ,.
//   floor  -------\/-----\/--o-----
//
// All legs are computed when a casing is thrown, so the frame rate does not change them. Only the world stops
// casings; they fall through doors and lifts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "math/vec.h"
#include "world/level.h"

namespace temblor::client {

// The order of ModelTable's casings.
enum class CasingModel : std::uint8_t { kShell, kBrass };

// A casing at the time at which it is thrown. `seed` chooses how it turns.
struct CasingThrow {
  CasingModel model{};
  math::Vec3 origin_world{0.0f}, velocity{0.0f};  // units, units per second
  double born_s = 0;
  std::uint64_t seed = 0;
};

// A casing to draw.
struct CasingPiece {
  CasingModel model{};
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch is positive upward, as in alias models
  float alpha = 1;
};

// A part of a casing's way. Times are counted from the throw.
struct CasingLeg {
  double start_s = 0;
  math::Vec3 origin_world{0.0f}, velocity{0.0f};
  bool is_rest = false;
};

class Casings {
 public:
  // With this many, a new casing replaces the oldest.
  static constexpr std::size_t kMaxCasings = 64;
  static constexpr double kLife_s = 8, kFade_s = 1;

  void clear() { size_ = piece_count_ = 0; }
  // Ignores casings that start inside something solid.
  void throw_casing(const world::Level& level, const CasingThrow& thrown);
  // Removes old casings and moves the others to their places at `time_s`.
  void advance(double time_s);
  // The casings as of the last advance(). Valid until anything changes.
  std::span<const CasingPiece> pieces() const { return {pieces_.data(), piece_count_}; }

 private:
  static constexpr std::size_t kMaxLegs = 6;
  struct Casing {
    CasingThrow thrown;
    std::array<CasingLeg, kMaxLegs> legs;
    std::size_t leg_count = 0;
  };
  static void compute_legs(const world::Level& level, Casing& io_casing);
  static CasingPiece place(const Casing& casing, double age_s);

  std::size_t size_ = 0, piece_count_ = 0;
  std::array<Casing, kMaxCasings> casings_;
  std::array<CasingPiece, kMaxCasings> pieces_;
};

}  // namespace temblor::client
