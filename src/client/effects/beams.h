// Lightning: each beam is a straight row of model pieces, every piece rotated about the beam at random.
//
//   start [piece][piece][piece][pie end      a piece every 30 units: progs/bolt.mdl and others
//
// A beam lives for 0.2 s after its message. Game code that holds a lightning gun sends one again and again,
// and each message replaces the entity's last beam.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "math/vec.h"

namespace temblor::client {

// The order of ModelTable's beam models.
enum class BeamModel : std::uint8_t { kBolt, kBolt2, kBolt3, kBeam };

// One model of the row.
struct BeamPiece {
  BeamModel model{};
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch is positive upward, as in alias models
};

// A beam as the server sent it.
struct Beam {
  std::uint32_t entity = 0;  // the owner, whose older beam ends; 0: none
  BeamModel model{};
  math::Vec3 start_world{0.0f}, end_world{0.0f};
  double born_s = 0;
};

class Beams {
 public:
  // With this many alive, a new beam replaces the oldest.
  static constexpr std::size_t kMaxBeams = 64;
  static constexpr double kLife_s = 0.2;
  static constexpr float kPieceLength = 30;
  // Longer beams are cut off: no level is this large.
  static constexpr int kMaxPieces = 1024;

  // The player's own entity. Its beams start at this place (its current, predicted one, or its gun), not
  // where they were fired, so that lightning stays in front of the weapon.
  struct Anchor {
    std::uint32_t entity;
    math::Vec3 origin_world;
  };

  void clear();
  // Adds a beam; it lives for kLife_s.
  void add(const Beam& beam);
  // Removes expired beams and places the pieces of the others at `time_s`.
  void advance(double time_s, const std::optional<Anchor>& anchor);
  // Whether lightning of this entity is alive, as of the last advance(), or was added since.
  bool has_bolt(std::uint32_t entity) const;
  // The pieces as of the last advance(). Valid until anything changes.
  std::span<const BeamPiece> pieces() const { return pieces_; }

 private:
  std::size_t find_slot(std::uint32_t entity) const;
  void place_pieces(const Beam& beam, double time_s);

  std::size_t size_ = 0;
  std::array<Beam, kMaxBeams> beams_;
  std::vector<BeamPiece> pieces_;
};

}  // namespace temblor::client
