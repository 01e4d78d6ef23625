#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "artgen/models/reading/read_parts.h"
#include "artgen/models/reading/values.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// "chest" turns it, "chest.at" moves it, "chest.scale" grows it.
struct MotionName {
  std::string bone;
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

// As many numbers as the motion has; pitch alone is enough for a turn, one number for a scale.
base::Result<math::Vec3d> motion_values(const ScriptLine& line, const MotionName& name,
                                        const std::string& text) {
  const auto numbers = numbers_in(text);
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

base::Status add_motion(const ScriptLine& line, const Model& model, const std::string& setting,
                        const std::string& text, ChannelValues& io_values) {
  const Skeleton& skeleton = model.skeleton;
  if (setting == "plant" || setting == "hold") {
    const auto numbers = numbers_in(text);
    if (!numbers || numbers->size() != 1 || numbers->front() < 0 || numbers->front() > 1)
      return script_error(line, fmt::format("{}={} is not from 0 to 1", setting, base::quotable(text)));
    io_values[setting == "plant" ? plant_channel(skeleton) : hold_channel(skeleton)] = numbers->front();
    return base::Ok{};
  }
  TRY(const MotionName name, motion_name(line, setting));
  TRY(const math::Vec3d values, motion_values(line, name, text));
  const bool both = is_pair(name.bone);
  TRY(const std::size_t bone, find_bone(line, skeleton, on_side(name.bone, 'l')));
  for (std::size_t i = 0; i < 3; ++i) {
    const Channel channel = bone_channel(bone, name.first_number + i);
    const double value = values[static_cast<int>(i)];
    io_values[channel] = value;
    if (!both) continue;
    const auto [other, factor] = mirrored(skeleton, channel);
    io_values[other] = value * factor;
  }
  return base::Ok{};
}

// A pose's values under its name, or none for "rest".
base::Status take_pose(const ScriptLine& line, const Model& model, const std::string& name,
                       ChannelValues& io_values) {
  if (name == "rest") return base::Ok{};
  const auto pose = model.poses.find(name);
  if (pose == model.poses.end())
    return script_error(line, fmt::format("there is no pose '{}'", base::quotable(name)));
  io_values = pose->second;
  return base::Ok{};
}

struct KeyLine {
  double frame = 0;
  bool whole = false;  // a pose's: what it does not mention rests
  ChannelValues values;
};

base::Result<KeyLine> read_key(const ScriptLine& line, const Model& model, const Animation& animation) {
  KeyLine key;
  const auto frame = line.values.empty() ? std::nullopt : numbers_in(line.values.front());
  if (!frame || frame->size() != 1 || frame->front() < 0 || frame->front() > animation.frames)
    return script_error(line, fmt::format("its first value is a frame from 0 to {}", animation.frames));
  key.frame = frame->front();
  if (line.values.size() > 2)
    return script_error(line, "it has a frame, a pose if need be, and bones' settings");
  if (line.values.size() == 2) {
    key.whole = true;
    TRY_STATUS(take_pose(line, model, line.values[1], key.values));
  }
  for (const auto& [setting, text] : line.settings)
    TRY_STATUS(add_motion(line, model, setting, text, key.values));
  return key;
}

KeyLine mirror_key(const KeyLine& key, const Model& model, double frame) {
  KeyLine image{frame, key.whole, {}};
  for (const auto& [channel, value] : key.values) {
    const auto [other, factor] = mirrored(model.skeleton, channel);
    image.values[other] = value * factor;
  }
  return image;
}

void add_keys(std::vector<KeyLine> lines, const Model& model, Animation& io_animation) {
  std::stable_sort(lines.begin(), lines.end(),
                   [](const KeyLine& a, const KeyLine& b) { return a.frame < b.frame; });
  ChannelValues all;
  for (const KeyLine& line : lines) all.insert(line.values.begin(), line.values.end());
  // Where a key says everything, the stance says nothing.
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

base::Status read_gait(const ScriptLine& line, const Model& model, Animation& io_animation) {
  Arguments arguments(line);
  Gait gait;
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
  if (gait.feet.empty()) arguments.complain("the model has no 'foot'");
  if (io_animation.frames / gait.cycles < 2) arguments.complain("a cycle has at least two frames");
  io_animation.gaits.push_back(std::move(gait));
  return arguments.finish();
}

base::Status read_movement(const ScriptLine& line, bool alternates, const Model& model,
                           Animation& io_animation) {
  std::vector<KeyLine> keys;
  for (const ScriptLine& below : line.below) {
    if (below.word == "gait") {
      TRY_STATUS(read_gait(below, model, io_animation));
      continue;
    }
    if (below.word != "key") return script_error(below, "movements have lines 'key' and 'gait'");
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

// An animation that is another one, made longer or shorter.
base::Status read_like(const ScriptLine& line, Model& io_model) {
  Arguments arguments(line);
  const std::string name = arguments.text(), other = arguments.text();
  const auto frames = static_cast<std::int32_t>(std::lround(arguments.number(1, 1000)));
  TRY_STATUS(arguments.finish());
  const auto known = std::find_if(io_model.animations.begin(), io_model.animations.end(),
                                  [&](const Animation& animation) { return animation.name == other; });
  if (known == io_model.animations.end())
    return script_error(line, fmt::format("there is no animation '{}' before it", base::quotable(other)));
  Animation animation = *known;
  animation.name = name;
  animation.frames = frames;
  const double old_end = known->loops ? known->frames : std::max(1, known->frames - 1);
  const double end = known->loops ? frames : std::max(1, frames - 1);
  for (auto& [channel, keys] : animation.keys)
    for (auto& [frame, value] : keys) frame *= end / old_end;
  for (Gait& gait : animation.gaits) gait.speed *= old_end / end;
  io_model.animations.push_back(std::move(animation));
  return base::Ok{};
}

}  // namespace

base::Status read_pose(const ScriptLine& line, Model& io_model) {
  if (line.values.empty() || line.values.size() > 2)
    return script_error(line, "it has a name, the pose it begins with if there is one, and bones' settings");
  ChannelValues values;
  if (line.values.size() == 2) TRY_STATUS(take_pose(line, io_model, line.values[1], values));
  for (const auto& [setting, text] : line.settings)
    TRY_STATUS(add_motion(line, io_model, setting, text, values));
  io_model.poses[line.values.front()] = std::move(values);
  return base::Ok{};
}

base::Status read_animation(const ScriptLine& line, Model& io_model) {
  if (line.word == "like") return read_like(line, io_model);
  Arguments arguments(line);
  Animation animation;
  animation.name = arguments.text();
  animation.frames = static_cast<std::int32_t>(std::lround(arguments.number(1, 1000)));
  animation.loops = line.word == "cycle";
  animation.settles = arguments.flag("settle");
  animation.group_frame_s = arguments.number("group", 0, 0, 100);
  const bool alternates = arguments.flag("alternate");
  TRY_STATUS(arguments.finish());
  TRY_STATUS(read_movement(line, alternates, io_model, animation));
  io_model.animations.push_back(std::move(animation));
  return base::Ok{};
}

}  // namespace temblor::artgen
