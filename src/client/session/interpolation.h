// Interpolation between updates. Drawing runs one packet behind the server: a packet is shown from the time
// of the packet before it on, and its contents are reached at its own time.
//
//   packets      A-----------B-----------C
//   frame shows              [ A -> B )[ B -> C )      while the client already has the packet on the right
//
// Monsters (`step` movement) and animation frames change ten times a second at any packet rate, so their
// changes last as long as the server's think interval instead.
//
// All times are the server's, in seconds. Nothing here allocates.
#pragma once

#include <cstdint>
#include <optional>

#include "client/session/interpolated_entity.h"
#include "math/vec.h"

namespace temblor::client {

// The duration of a step or animation frame if the server does not send one.
constexpr double kThinkInterval_s = 0.1;

// The time during which the last packet is drawn: from begin_s (the time of the packet before, at most 0.1 s
// earlier) to end_s (its own time).
struct PacketWindow {
  double begin_s = 0, end_s = 0;
};
// Returns the window of a packet from its time and that of the one before.
PacketWindow make_packet_window(double previous_time_s, double time_s);

// The share of the interval that has passed, in [0, 1]; 1 for an empty interval.
double compute_elapsed_fraction(double begin_s, double end_s, double time_s);

// Interpolates each angle along the shorter way round. Exact at both ends.
math::Vec3 blend_angles_deg(const math::Vec3& from_deg, const math::Vec3& to_deg, double fraction);

// An entity's place and orientation.
struct Place {
  math::Vec3 origin_world{0.0f}, angles_deg{0.0f};
  bool operator==(const Place&) const = default;
};

// An entity's motion to the place of its last update.
class Motion {
 public:
  // Moves the entity there at once.
  void put(const Place& place);
  // Moves the entity there at constant speed during the packet's window.
  void fly_to(const Place& place, const PacketWindow& window);
  // Moves the entity there during the time of a monster's step: `step_s` if known (0 or more), else the time
  // since the last step, at most 0.1 s. Does nothing if it is there or already on its way there.
  void step_to(const Place& place, const PacketWindow& window, std::optional<float> step_s);

  // The place at a time; the target from the end of the motion on.
  Place at(double time_s) const;
  const Place& target() const { return to_; }

 private:
  Place from_, to_;
  double begin_s_ = 0, end_s_ = 0;
};

// Whether a change is too large for movement: more than 100 units along an axis in one update, as in the
// original.
bool is_teleport(const math::Vec3& from_world, const math::Vec3& to_world);

// Animation frames, blended from one to the next. The frames of a muzzle flash appear and vanish at once;
// blended, the flash would grow and shrink visibly.
class FrameChanges {
 public:
  // Shows a frame at once, without blending.
  void show(std::uint16_t frame);
  // Starts blending to the frame of an update, drawn from `begin_s` on.
  void update(std::uint16_t frame, double begin_s, double duration_s);
  // Marks the current update as one with a muzzle flash. May come before or after the frame of that update.
  void flash();

  // from == to if nothing is being blended.
  FrameBlend at(double time_s) const;
  std::uint16_t frame() const { return to_; }

 private:
  std::uint16_t from_ = 0, to_ = 0;
  bool flash_shown_ = false;
  double begin_s_ = 0, end_s_ = 0;
};

}  // namespace temblor::client
