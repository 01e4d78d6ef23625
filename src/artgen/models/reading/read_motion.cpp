#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "artgen/models/reading/read_parts.h"
#include "artgen/models/reading/values.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// The name of a setting in a key or pose: "chest" rotates the bone, "chest.at" moves it, "chest.scale" scales
// it.
struct MotionName {
  std::string bone;
  // The first of three channels of the bone: 0, 3, or 6.
  std::size_t first_number = 0;
};

base::Result<MotionName> motion_name(const ScriptLine& line, std::string_view text) {
  const std::size_t dot = text.find('.');
  MotionName name{std::string(text.substr(0, dot)), 0};
  if (dot == std::string_view::npos) return name;
  const std::string_view what = text.substr(dot);
  if (what == ".at")
    name.first_number = 3;
  else if (what == ".scale")
    name.first_number = 6;
  else
    return script_error(line,
                        fmt::format("'{}' is neither BONE, BONE.at nor BONE.scale", base::quotable(text)));
  return name;
}

// Parses three numbers. A rotation may omit yaw and roll, and a scale may be a single number.
base::Result<math::Vec3d> motion_values(const ScriptLine& line, const MotionName& name,
                                        const std::string& text) {
  const auto numbers = parse_numbers(text);
  const bool fits = numbers && (numbers->size() == 3 || (name.first_number == 0 && numbers->size() <= 3) ||
                                (name.first_number == 6 && numbers->size() == 1));
  if (!fits)
    return script_error(line,
                        fmt::format("{}={} is not {}", name.bone, base::quotable(text),
                                    name.first_number == 0 ? "PITCH, PITCH,YAW or PITCH,YAW,ROLL" : "X,Y,Z"));
  math::Vec3d values(name.first_number == 6 ? numbers->front() : 0.0);
  for (std::size_t i = 0; i < numbers->size(); ++i) values[static_cast<int>(i)] = (*numbers)[i];
  if (name.first_number == 6 && std::min({values.x, values.y, values.z}) <= 0)
    return script_error(line, fmt::format("{}.scale={} is not above 0", name.bone, base::quotable(text)));
  return values;
}

// Sets the channels of one setting. A star in the bone's name also sets the mirrored channels of the right
// side.
base::Status add_motion(const ScriptLine& line, const Model& model, const std::string& setting,
                        const std::string& text, ChannelValues& io_values) {
  const Skeleton& skeleton = model.skeleton;
  if (setting == "plant" || setting == "hold") {
    const auto numbers = parse_numbers(text);
    if (!numbers || numbers->size() != 1 || numbers->front() < 0 || numbers->front() > 1)
      return script_error(line, fmt::format("{}={} is not from 0 to 1", setting, base::quotable(text)));
    io_values[setting == "plant" ? plant_channel(skeleton) : hold_channel(skeleton)] = numbers->front();
    return base::Ok{};
  }
  TRY(const MotionName name, motion_name(line, setting));
  TRY(const math::Vec3d values, motion_values(line, name, text));
  const bool both = is_pair(name.bone);
  TRY(const std::size_t bone, find_bone(line, skeleton, select_side(name.bone, 'l')));
  for (std::size_t i = 0; i < 3; ++i) {
    const Channel channel = bone_channel(bone, name.first_number + i);
    const double value = values[static_cast<int>(i)];
    io_values[channel] = value;
    if (!both) continue;
    const auto [other, factor] = mirror_channel(skeleton, channel);
    io_values[other] = value * factor;
  }
  return base::Ok{};
}

// Replaces io_values by a pose, or leaves them for "rest".
base::Status copy_pose(const ScriptLine& line, const Model& model, const std::string& name,
                       ChannelValues& io_values) {
  if (name == "rest") return base::Ok{};
  const auto pose = model.poses.find(name);
  if (pose == model.poses.end())
    return script_error(line, fmt::format("no pose is named '{}'", base::quotable(name)));
  io_values = pose->second;
  return base::Ok{};
}

// A `key` line.
struct KeyLine {
  double frame = 0;
  // It is based on a pose: channels that it does not mention return to rest.
  bool whole = false;
  ChannelValues values;
};

// `key FRAME [POSE] BONE=...`
base::Result<KeyLine> read_key(const ScriptLine& line, const Model& model, const Animation& animation) {
  KeyLine key;
  const auto frame = line.values.empty() ? std::nullopt : parse_numbers(line.values.front());
  if (!frame || frame->size() != 1 || frame->front() < 0 || frame->front() > animation.frames)
    return script_error(line, fmt::format("the first value must be a frame from 0 to {}", animation.frames));
  key.frame = frame->front();
  if (line.values.size() > 2)
    return script_error(line, "expected a frame, optionally a pose, and BONE=... settings");
  if (line.values.size() == 2) {
    key.whole = true;
    TRY_STATUS(copy_pose(line, model, line.values[1], key.values));
  }
  for (const auto& [setting, text] : line.settings)
    TRY_STATUS(add_motion(line, model, setting, text, key.values));
  return key;
}

// The same key for the other side of the body at another frame.
KeyLine mirror_key(const KeyLine& key, const Model& model, double frame) {
  KeyLine image{frame, key.whole, {}};
  for (const auto& [channel, value] : key.values) {
    const auto [other, factor] = mirror_channel(model.skeleton, channel);
    image.values[other] = value * factor;
  }
  return image;
}

// Converts the lines to curves. A line without a pose adds keys only for its own channels; one with a pose
// also adds keys at rest for all channels that any line of the animation uses.
void add_keys(std::vector<KeyLine> lines, const Model& model, Animation& io_animation) {
  std::stable_sort(lines.begin(), lines.end(),
                   [](const KeyLine& a, const KeyLine& b) { return a.frame < b.frame; });
  ChannelValues all;
  for (const KeyLine& line : lines) all.insert(line.values.begin(), line.values.end());
  // A key with a pose also resets the channels of the stance, which is the base of every animation.
  const auto stance = model.poses.find("stance");
  const bool any_whole =
      std::any_of(lines.begin(), lines.end(), [](const KeyLine& line) { return line.whole; });
  if (any_whole && stance != model.poses.end()) all.insert(stance->second.begin(), stance->second.end());
  for (const KeyLine& line : lines) {
    for (const auto& [channel, unused] : all) {
      const auto value = line.values.find(channel);
      if (value == line.values.end() && !line.whole) continue;
      auto& keys = io_animation.keys[channel];
      const double number = value != line.values.end() ? value->second : rest_value(model.skeleton, channel);
      if (!keys.empty() && keys.back().first >= line.frame)
        keys.back().second = number;
      else
        keys.emplace_back(line.frame, number);
    }
  }
}

// `gait speed=... foot_l=0 foot_r=0.5`. Without named feet, all feet of the model step, right ones half a
// cycle later.
base::Status read_gait(const ScriptLine& line, const Model& model, Animation& io_animation) {
  Arguments arguments(line);
  WalkCycle gait;
  gait.speed = arguments.number("speed", 0, -1000, 1000) / model.size;
  gait.cycles = arguments.number("cycles", 1, 1, 100);
  gait.duty = arguments.number("duty", 0.6, 0.05, 0.95);
  gait.lift = arguments.number("lift", 4, 0, 1000);
  gait.peel_deg = arguments.number("peel", 25, -180, 180);
  gait.bob = arguments.number("bob", 0, -100, 100);
  gait.sway = arguments.number("sway", 0, -100, 100);
  for (const Limb& limb : model.skeleton.limbs) {
    if (limb.grip_on) continue;
    const std::string& name = model.skeleton.bones[limb.end].name;
    const bool any_named =
        std::any_of(model.skeleton.limbs.begin(), model.skeleton.limbs.end(),
                    [&](const Limb& other) { return arguments.has(model.skeleton.bones[other.end].name); });
    if (any_named && !arguments.has(name)) continue;
    gait.feet.push_back({limb.end, arguments.number(name, name.ends_with("_r") ? 0.5 : 0.0, 0, 1)});
  }
  if (gait.feet.empty()) arguments.set_error("the model has no 'foot'");
  if (io_animation.frames / gait.cycles < 2) arguments.set_error("a gait's cycle needs at least two frames");
  io_animation.gaits.push_back(std::move(gait));
  return arguments.finish();
}

// The lines under an animation. `alternates`: the second half of the animation is the mirror image of the
// first.
base::Status read_movement(const ScriptLine& line, bool alternates, const Model& model,
                           Animation& io_animation) {
  std::vector<KeyLine> keys;
  for (const ScriptLine& below : line.below) {
    if (below.keyword == "gait") {
      TRY_STATUS(read_gait(below, model, io_animation));
      continue;
    }
    if (below.keyword != "key")
      return script_error(below, "only 'key' and 'gait' lines can be under an animation");
    TRY(KeyLine key, read_key(below, model, io_animation));
    if (alternates) {
      const double half = 0.5 * io_animation.frames;
      if (key.frame >= half)
        return script_error(
            below, "with alternate=yes keys stand in the first half; the second is its mirror image");
      keys.push_back(mirror_key(key, model, key.frame + half));
    }
    keys.push_back(std::move(key));
  }
  add_keys(std::move(keys), model, io_animation);
  return base::Ok{};
}

// `like NAME OTHER COUNT`: a copy of another animation, stretched to another number of frames. Feet cover the
// same distance in total, so the speed of gaits changes.
base::Status read_like(const ScriptLine& line, Model& io_model) {
  Arguments arguments(line);
  const std::string name = arguments.text(), other = arguments.text();
  const auto frames = static_cast<std::int32_t>(std::lround(arguments.number(1, 1000)));
  TRY_STATUS(arguments.finish());
  const auto known = std::find_if(io_model.animations.begin(), io_model.animations.end(),
                                  [&](const Animation& animation) { return animation.name == other; });
  if (known == io_model.animations.end())
    return script_error(line,
                        fmt::format("no animation '{}' is defined above this line", base::quotable(other)));
  Animation animation = *known;
  animation.name = name;
  animation.frames = frames;
  // A loop lasts `frames` frames; otherwise the last pose is in frame `frames` - 1.
  const double old_end = known->loops ? known->frames : std::max(1, known->frames - 1);
  const double end = known->loops ? frames : std::max(1, frames - 1);
  for (auto& [channel, keys] : animation.keys)
    for (auto& [frame, value] : keys) frame *= end / old_end;
  for (WalkCycle& gait : animation.gaits) gait.speed *= old_end / end;
  io_model.animations.push_back(std::move(animation));
  return base::Ok{};
}

}  // namespace

base::Status read_pose(const ScriptLine& line, Model& io_model) {
  if (line.values.empty() || line.values.size() > 2)
    return script_error(line, "expected a name, optionally a pose to start from, and BONE=... settings");
  ChannelValues values;
  if (line.values.size() == 2) TRY_STATUS(copy_pose(line, io_model, line.values[1], values));
  for (const auto& [setting, text] : line.settings)
    TRY_STATUS(add_motion(line, io_model, setting, text, values));
  io_model.poses[line.values.front()] = std::move(values);
  return base::Ok{};
}

base::Status read_animation(const ScriptLine& line, Model& io_model) {
  if (line.keyword == "like") return read_like(line, io_model);
  Arguments arguments(line);
  Animation animation;
  animation.name = arguments.text();
  animation.frames = static_cast<std::int32_t>(std::lround(arguments.number(1, 1000)));
  animation.loops = line.keyword == "cycle";
  animation.settles = arguments.flag("settle");
  animation.group_frame_s = arguments.number("group", 0, 0, 100);
  const bool alternates = arguments.flag("alternate");
  TRY_STATUS(arguments.finish());
  TRY_STATUS(read_movement(line, alternates, io_model, animation));
  io_model.animations.push_back(std::move(animation));
  return base::Ok{};
}

}  // namespace temblor::artgen
