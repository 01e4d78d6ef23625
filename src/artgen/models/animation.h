// The movement of a model: values of bones at key frames, interpolated smoothly; and gaits, which move feet
// with the floor so that they do not slide while the creature walks.
//
// An animation is a set of curves, one for each channel that has keys. A channel is one number of a pose.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "artgen/models/skeleton.h"

namespace temblor::artgen {

// Channels of bone b are 9 * b + n, with n = 0 to 2 for rotations (pitch, yaw, roll), 3 to 5 for offsets, and
// 6 to 8 for scales. Two channels for `plant` and `hold` follow after all bones.
using Channel = std::size_t;
constexpr std::size_t kBoneChannels = 9;
Channel bone_channel(std::size_t bone, std::size_t number);
Channel plant_channel(const Skeleton& skeleton);
Channel hold_channel(const Skeleton& skeleton);
// The value at rest: 1 for scales, plant, and hold, else 0.
double rest_value(const Skeleton& skeleton, Channel channel);

// The channel of the same movement on the other side of the body, and the factor for its value.
std::pair<Channel, double> mirror_channel(const Skeleton& skeleton, Channel channel);

// Values for some channels; a named pose, for example.
using ChannelValues = std::map<Channel, double>;

// A foot that steps in a gait.
struct WalkCycleFoot {
  std::size_t bone = 0;
  // When the foot comes down: 0 to 1 of the cycle.
  double phase = 0;
};

// A gait. Each foot moves backward with the floor for a part of the cycle, then swings forward through the
// air.
//
//   height  |      .--.
//           |    .'    '.         one cycle of one foot:
//           |___/        \____    `duty` of the time on the floor, moving back at `speed`,
//           '------------------   then an arc of height `lift` forward
struct WalkCycle {
  std::vector<WalkCycleFoot> feet;
  // Units per frame.
  double speed = 0;
  // The number of cycles in the animation.
  double cycles = 1;
  // The fraction of a cycle for which a foot is on the floor.
  double duty = 0.6;
  // The height of a step in units.
  double lift = 4;
  // The pitch of the foot in the air.
  double peel_deg = 25;
  // How far the first bone moves down with each step, in units; negative: up.
  double bob = 0;
  // How far it moves toward the foot that is on the floor, in units.
  double sway = 0;
};

// A named sequence of frames.
struct Animation {
  std::string name;
  std::int32_t frames = 1;
  // The last frame continues to the first.
  bool loops = false;
  // Every frame is moved vertically so that its lowest point touches the floor; for dying creatures.
  bool settles = false;
  // If above 0, all poses form one frame group, which the engine animates automatically with this time per
  // pose.
  double group_frame_s = 0;
  // For each channel: pairs of frame (0 to `frames`, ascending) and value.
  std::map<Channel, std::vector<std::pair<double, double>>> keys;
  std::vector<WalkCycle> gaits;
};

// The pose at a time in frames. Channels without keys have the value of `base`, else the rest value.
BonePose pose_at(const Animation& animation, const Skeleton& skeleton, const ChannelValues& base,
                 double frame);

}  // namespace temblor::artgen
