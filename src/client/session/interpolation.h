// How a thing looks between two updates. Drawing runs one packet behind the server: a packet is shown from
// the time of the one before it on, and everything in it is reached at its own time. Monsters (`step`) and
// the frames of models change ten times a second whatever the rate of packets is: their changes take as long
// as they last.
//
// All times are the server's, in seconds. Nothing here allocates.
#pragma once

#include <cstdint>
#include <optional>

#include "client/session/seen_entity.h"
#include "math/vec.h"

namespace temblor::client {

// How long a step and a frame of a model last when the server does not say.
constexpr double kThinkInterval_s = 0.1;

// When the last packet is drawn: from begin_s (the time of the packet before, but at most 0.1 s earlier) to
// end_s (its own).
struct PacketWindow {
  double begin_s = 0, end_s = 0;
};
PacketWindow packet_window(double previous_time_s, double time_s);

// How much of the way from begin_s to end_s has passed, in [0, 1]; 1 when there is no way.
double fraction_passed(double begin_s, double end_s, double time_s);

// From one set of angles to another, each the short way round. Exact at both ends.
math::Vec3 blend_angles_deg(const math::Vec3& from_deg, const math::Vec3& to_deg, double fraction);

struct Place {
  math::Vec3 origin_world{0.0f}, angles_deg{0.0f};
  bool operator==(const Place&) const = default;
};

// The way of an entity to where its last update put it.
class Motion {
 public:
  // It stands there, without having come from anywhere.
  void put(const Place& place);
  // It goes there during the packet's window.
  void fly_to(const Place& place, const PacketWindow& window);
  // It goes there in the time that its steps take: `step_s` when known (0 or more), or else the time since
  // its last step, 0.1 s at most. Nothing changes when it is there or on its way there.
  void step_to(const Place& place, const PacketWindow& window, std::optional<float> step_s);

  Place at(double time_s) const;
  const Place& target() const { return to_; }

 private:
  Place from_, to_;
  double begin_s_ = 0, end_s_ = 0;
};

// Too far in one update to have been a movement: more than 100 units along an axis.
bool is_teleport(const math::Vec3& from_world, const math::Vec3& to_world);

// The frames of a model, blended from one to the next. Frames that belong to a muzzle flash are shown and
// left at once: blended, the flash would be seen growing and shrinking.
class FrameChanges {
 public:
  void show(std::uint16_t frame);
  // The frame of an update that is drawn from `begin_s` on, and how long a change takes.
  void update(std::uint16_t frame, double begin_s, double duration_s);
  // The update of this moment, whether or not its frame is known already, has a muzzle flash.
  void flash();

  // from = to when nothing is being blended.
  FrameBlend at(double time_s) const;
  std::uint16_t frame() const { return to_; }

 private:
  std::uint16_t from_ = 0, to_ = 0;
  bool flash_shown_ = false;
  double begin_s_ = 0, end_s_ = 0;
};

}  // namespace temblor::client
