// Movement: values of bones at key frames, smooth between them; and gaits, which put feet on the floor and
// leave them there while the body moves on.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "artgen/models/skeleton.h"

namespace temblor::artgen {

// One number of a pose: three turns, three shifts and three scales for each bone, then plant and hold.
using Channel = std::size_t;
constexpr std::size_t kBoneChannels = 9;
Channel bone_channel(std::size_t bone, std::size_t number);
Channel plant_channel(const Skeleton& skeleton);
Channel hold_channel(const Skeleton& skeleton);
// At rest: 0, but 1 for scales, plant and hold.
double rest_value(const Skeleton& skeleton, Channel channel);

// The channel, and the factor for the value, of the same movement on the other side.
std::pair<Channel, double> mirrored(const Skeleton& skeleton, Channel channel);

using ChannelValues = std::map<Channel, double>;

struct GaitFoot {
  std::size_t bone = 0;
  double phase = 0;  // 0 to 1: when it comes down
};

struct Gait {
  std::vector<GaitFoot> feet;
  double speed = 0;   // units a frame
  double cycles = 1;  // in the animation
  double duty = 0.6;  // the part of a cycle that a foot is down
  double lift = 4;    // units
  double peel_deg = 25;
  double bob = 0;   // units that the first bone goes down and up with each step (below 0: up and down)
  double sway = 0;  // units that it goes to the side of the foot that is down
};

struct Animation {
  std::string name;
  std::int32_t frames = 1;
  bool loops = false;
  bool settles = false;      // the lowest point always touches the floor
  double group_frame_s = 0;  // not 0: one frame whose poses follow one another by themselves
  // By channel: frame numbers from 0 up to `frames`, rising, with values.
  std::map<Channel, std::vector<std::pair<double, double>>> keys;
  std::vector<Gait> gaits;
};

// At a time in frames. Channels without keys have `base`'s value, or rest.
BonePose pose_at(const Animation& animation, const Skeleton& skeleton, const ChannelValues& base,
                 double frame);

}  // namespace temblor::artgen
