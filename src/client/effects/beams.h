// Lightning: straight rows of pieces, each turned about the row at random.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "math/vec.h"

namespace temblor::client {

enum class BeamModel : std::uint8_t { kBolt, kBolt2, kBolt3, kBeam };

// A piece of lightning: one model along its way.
struct BeamPiece {
  BeamModel model{};
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch is positive upwards, as alias models have it
};

struct Beam {
  std::uint32_t entity = 0;  // whose; its older beam ends. 0: nobody's
  BeamModel model{};
  math::Vec3 start_world{0.0f}, end_world{0.0f};
  double born_s = 0;
};

class Beams {
 public:
  // When that many are alive, the oldest ends for a new one.
  static constexpr std::size_t kMost = 64;
  static constexpr double kLife_s = 0.2;
  static constexpr float kPieceLength = 30;
  // Beyond it a beam is cut off: more than any level measures.
  static constexpr int kMaxPieces = 1024;

  // The beams of one entity that starts where it is, not where it was: the player whose eyes we see through.
  struct Held {
    std::uint32_t entity;
    math::Vec3 origin_world;
  };

  void clear();
  void add(const Beam& beam);
  void advance(double time_s, const std::optional<Held>& held);
  // As of the last advance(). Valid until anything changes.
  std::span<const BeamPiece> pieces() const { return pieces_; }

 private:
  std::size_t slot_for(std::uint32_t entity) const;
  void lay_out(const Beam& beam, double time_s);

  std::size_t size_ = 0;
  std::array<Beam, kMost> beams_;
  std::vector<BeamPiece> pieces_;
};

}  // namespace temblor::client
