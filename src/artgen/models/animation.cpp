// Between keys: cubic curves whose slopes never overshoot (Fritsch and Butland, "A Method for Constructing
// Local Monotone Piecewise Cubic Interpolants", 1984).
#include "artgen/models/animation.h"

#include <cmath>
#include <numbers>

#include "artgen/models/reading/values.h"

namespace temblor::artgen {
namespace {

using Keys = std::vector<std::pair<double, double>>;

double slope_between(const Keys& keys, std::size_t i) {
  return (keys[i + 1].second - keys[i].second) / (keys[i + 1].first - keys[i].first);
}

// At key i, which has neighbors on both sides.
double slope_at(const Keys& keys, std::size_t i) {
  const double before = slope_between(keys, i - 1), after = slope_between(keys, i);
  if (before * after <= 0) return 0;
  const double before_length = keys[i].first - keys[i - 1].first,
               after_length = keys[i + 1].first - keys[i].first;
  const double share = (before_length + 2 * after_length) / (3 * (before_length + after_length));
  return before * after / (share * after + (1 - share) * before);
}

double cubic(double from, double from_slope, double to, double to_slope, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return from * (2 * t3 - 3 * t2 + 1) + from_slope * (t3 - 2 * t2 + t) + to * (3 * t2 - 2 * t3) +
         to_slope * (t3 - t2);
}

double value_between(const Keys& keys, double frame) {
  if (frame <= keys.front().first) return keys.front().second;
  if (frame >= keys.back().first) return keys.back().second;
  std::size_t i = 0;
  while (keys[i + 1].first < frame) ++i;
  const double length = keys[i + 1].first - keys[i].first;
  const double from_slope = i == 0 ? 0 : slope_at(keys, i);
  const double to_slope = i + 2 == keys.size() ? 0 : slope_at(keys, i + 1);
  return cubic(keys[i].second, from_slope * length, keys[i + 1].second, to_slope * length,
               (frame - keys[i].first) / length);
}

double value_at(const Animation& animation, const Keys& keys, double frame) {
  if (!animation.loops || keys.size() < 2) return value_between(keys, frame);
  // The turns before and after this one, too: the curve closes.
  Keys round;
  for (const double shift : {-1.0, 0.0, 1.0})
    for (const auto& [at, value] : keys) round.emplace_back(at + shift * animation.frames, value);
  return value_between(round, frame);
}

void add_foot(const Gait& gait, double period, double phase, BoneMotion& io_foot) {
  const double half = 0.5 * gait.speed * period * gait.duty;
  if (phase < gait.duty) {
    io_foot.at.x += half * (1 - 2 * phase / gait.duty);
    return;
  }
  // Through the air, leaving the floor and meeting it as fast as the floor goes by.
  const double air = 1 - gait.duty, t = (phase - gait.duty) / air;
  const double slope = -gait.speed * period * air;
  const double arc = std::sin(std::numbers::pi * t);
  io_foot.at.x += cubic(-half, slope, half, slope, t);
  io_foot.at.z += gait.lift * arc;
  io_foot.turn_deg.x += gait.peel_deg * arc * (1.6 - 2.2 * t);
}

void add_gait(const Gait& gait, const Animation& animation, double frame, BonePose& io_pose) {
  const double period = animation.frames / gait.cycles;
  const double turns = frame / period;
  for (const GaitFoot& foot : gait.feet) {
    const double phase = turns + foot.phase;
    add_foot(gait, period, phase - std::floor(phase), io_pose.bones[foot.bone]);
  }
  const double turn = 2 * std::numbers::pi * turns;
  io_pose.bones[0].at.z -= gait.bob * std::cos(2 * turn);
  io_pose.bones[0].at.y += gait.sway * std::cos(turn - std::numbers::pi * gait.duty);
}

void set_channel(const Skeleton& skeleton, Channel channel, double value, BonePose& io_pose) {
  if (channel == plant_channel(skeleton)) {
    io_pose.plant = value;
  } else if (channel == hold_channel(skeleton)) {
    io_pose.hold = value;
  } else {
    BoneMotion& motion = io_pose.bones[channel / kBoneChannels];
    const std::size_t number = channel % kBoneChannels;
    math::Vec3d& triple = number < 3 ? motion.turn_deg : number < 6 ? motion.at : motion.scale;
    triple[static_cast<int>(number % 3)] = value;
  }
}

}  // namespace

Channel bone_channel(std::size_t bone, std::size_t number) {
  return bone * kBoneChannels + number;
}

Channel plant_channel(const Skeleton& skeleton) {
  return skeleton.bones.size() * kBoneChannels;
}

Channel hold_channel(const Skeleton& skeleton) {
  return plant_channel(skeleton) + 1;
}

double rest_value(const Skeleton& skeleton, Channel channel) {
  return channel >= plant_channel(skeleton) || channel % kBoneChannels >= 6 ? 1 : 0;
}

std::pair<Channel, double> mirrored(const Skeleton& skeleton, Channel channel) {
  if (channel >= plant_channel(skeleton)) return {channel, 1.0};
  const std::size_t bone = channel / kBoneChannels, number = channel % kBoneChannels;
  const std::size_t other = skeleton.find(mirrored_name(skeleton.bones[bone].name)).value_or(bone);
  // Yaw, roll, and the shift to the side.
  const bool turns_round = number == 1 || number == 2 || number == 4;
  return {bone_channel(other, number), turns_round ? -1.0 : 1.0};
}

BonePose pose_at(const Animation& animation, const Skeleton& skeleton, const ChannelValues& base,
                 double frame) {
  BonePose pose{std::vector<BoneMotion>(skeleton.bones.size())};
  for (const auto& [channel, value] : base) set_channel(skeleton, channel, value, pose);
  for (const auto& [channel, keys] : animation.keys)
    set_channel(skeleton, channel, value_at(animation, keys, frame), pose);
  for (const Gait& gait : animation.gaits) add_gait(gait, animation, frame, pose);
  return pose;
}

}  // namespace temblor::artgen
