// Between keys, values follow monotone cubic curves, which never overshoot (F. Fritsch and J. Butland, "A
// Method for Constructing Local Monotone Piecewise Cubic Interpolants", 1984).
#include "artgen/models/animation.h"

#include <cmath>
#include <numbers>

#include "artgen/models/reading/values.h"

namespace temblor::artgen {
namespace {

// Pairs of frame and value, ascending.
using Keys = std::vector<std::pair<double, double>>;

// From key i to the next one.
double slope_between(const Keys& keys, std::size_t i) {
  return (keys[i + 1].second - keys[i].second) / (keys[i + 1].first - keys[i].first);
}

// The tangent at key i, which needs neighbors on both sides: a weighted harmonic mean of the slopes, or 0 at
// an extremum.
double slope_at(const Keys& keys, std::size_t i) {
  const double before = slope_between(keys, i - 1), after = slope_between(keys, i);
  if (before * after <= 0) return 0;
  const double before_length = keys[i].first - keys[i - 1].first,
               after_length = keys[i + 1].first - keys[i].first;
  const double share = (before_length + 2 * after_length) / (3 * (before_length + after_length));
  return before * after / (share * after + (1 - share) * before);
}

// Hermite interpolation; slopes are per unit of t.
double cubic(double from, double from_slope, double to, double to_slope, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return from * (2 * t3 - 3 * t2 + 1) + from_slope * (t3 - 2 * t2 + t) + to * (3 * t2 - 2 * t3) +
         to_slope * (t3 - t2);
}

// Constant before the first and after the last key, where the tangents are 0.
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
  // Repeats the keys before and after the loop, so that the tangents at its ends agree.
  Keys round;
  for (const double shift : {-1.0, 0.0, 1.0})
    for (const auto& [at, value] : keys) round.emplace_back(at + shift * animation.frames, value);
  return value_between(round, frame);
}

// Moves a foot by its phase in the cycle.
void add_foot(const WalkCycle& gait, double period, double phase, BoneMotion& io_foot) {
  const double half = 0.5 * gait.speed * period * gait.duty;
  if (phase < gait.duty) {
    io_foot.at.x += half * (1 - 2 * phase / gait.duty);
    return;
  }
  // In the air, the foot follows a cubic that leaves and meets the floor with the floor's speed, so that
  // there is no jerk.
  const double air = 1 - gait.duty, t = (phase - gait.duty) / air;
  const double slope = -gait.speed * period * air;
  const double arc = std::sin(std::numbers::pi * t);
  io_foot.at.x += cubic(-half, slope, half, slope, t);
  io_foot.at.z += gait.lift * arc;
  io_foot.turn_deg.x += gait.peel_deg * arc * (1.6 - 2.2 * t);
}

// Adds a gait on top of the keys. The first bone bobs twice per cycle and sways once.
void add_gait(const WalkCycle& gait, const Animation& animation, double frame, BonePose& io_pose) {
  const double period = animation.frames / gait.cycles;
  const double turns = frame / period;
  for (const WalkCycleFoot& foot : gait.feet) {
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

std::pair<Channel, double> mirror_channel(const Skeleton& skeleton, Channel channel) {
  if (channel >= plant_channel(skeleton)) return {channel, 1.0};
  const std::size_t bone = channel / kBoneChannels, number = channel % kBoneChannels;
  const std::size_t other = skeleton.find(mirror_name(skeleton.bones[bone].name)).value_or(bone);
  // Yaw, roll, and the sideways offset change their sign in a mirror.
  const bool is_negated = number == 1 || number == 2 || number == 4;
  return {bone_channel(other, number), is_negated ? -1.0 : 1.0};
}

BonePose pose_at(const Animation& animation, const Skeleton& skeleton, const ChannelValues& base,
                 double frame) {
  BonePose pose{std::vector<BoneMotion>(skeleton.bones.size())};
  for (const auto& [channel, value] : base) set_channel(skeleton, channel, value, pose);
  for (const auto& [channel, keys] : animation.keys)
    set_channel(skeleton, channel, value_at(animation, keys, frame), pose);
  for (const WalkCycle& gait : animation.gaits) add_gait(gait, animation, frame, pose);
  return pose;
}

}  // namespace temblor::artgen
