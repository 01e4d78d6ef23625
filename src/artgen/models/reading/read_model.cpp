#include <fmt/format.h>

#include <array>

#include "artgen/models/model.h"
#include "artgen/models/reading/read_parts.h"
#include "artgen/models/reading/values.h"

namespace temblor::artgen {
namespace {

constexpr std::array<std::string_view, 8> kFlagNames = {
    "rocket_trail", "grenade_smoke", "gib_blood", "rotate", "tracer", "zombie_blood", "tracer2", "tracer3"};

base::Status read_flags(const ScriptLine& line, Model& io_model) {
  for (const std::string& value : line.values) {
    const auto* const at = std::find(kFlagNames.begin(), kFlagNames.end(), value);
    if (at == kFlagNames.end())
      return script_error(line, fmt::format("'{}' is none of {}", value, fmt::join(kFlagNames, ", ")));
    io_model.flags |= 1u << (at - kFlagNames.begin());
  }
  return base::Ok{};
}

base::Status read_head_line(const ScriptLine& thing, Model& io_model) {
  Arguments arguments(thing);
  io_model.path = arguments.text();
  if (!io_model.path.ends_with(".mdl")) arguments.complain("the first value is the model's file, NAME.mdl");
  io_model.density = arguments.number("density", 2, 0.1, 32);
  io_model.floor = arguments.number("floor", -24, -4096, 4096);
  io_model.size = arguments.number("size", 1, 0.05, 20);
  io_model.eye = arguments.vector("eye", math::Vec3(0.0f));
  io_model.random_phase = arguments.flag("random_phase");
  return arguments.finish();
}

// Far above what is of use, far below what the file format and the skin can hold.
constexpr std::size_t kMaxTriangles = 8192;
constexpr std::int32_t kMaxFrames = 4096;

base::Status check_size(const ScriptLine& thing, const Model& model) {
  if (model.mesh.triangles.empty()) return script_error(thing, "it has no shape");
  if (model.mesh.triangles.size() > kMaxTriangles)
    return script_error(thing, fmt::format("{} triangles; a model has at most {}",
                                           model.mesh.triangles.size(), kMaxTriangles));
  std::int32_t frames = 0;
  for (const Animation& animation : model.animations) frames += animation.frames;
  if (frames > kMaxFrames)
    return script_error(thing, fmt::format("{} frames; a model has at most {}", frames, kMaxFrames));
  return base::Ok{};
}

enum class Kind { kFlags, kBone, kPaint, kSkin, kShape, kPose, kAnimation };

base::Result<Kind> kind_of(const ScriptLine& line) {
  constexpr std::array<std::pair<std::string_view, Kind>, 11> kWords = {{{"flags", Kind::kFlags},
                                                                         {"bone", Kind::kBone},
                                                                         {"scale", Kind::kBone},
                                                                         {"foot", Kind::kBone},
                                                                         {"grip", Kind::kBone},
                                                                         {"paint", Kind::kPaint},
                                                                         {"skin", Kind::kSkin},
                                                                         {"pose", Kind::kPose},
                                                                         {"animation", Kind::kAnimation},
                                                                         {"cycle", Kind::kAnimation},
                                                                         {"like", Kind::kAnimation}}};
  for (const auto& [word, kind] : kWords)
    if (line.word == word) return kind;
  if (is_shape_word(line.word)) return Kind::kShape;
  return script_error(
      line,
      "models have flags, bone, scale, foot, grip, paint, skin, tube, ball, box, plate, spike, "
      "crystal, pose, animation, cycle and like");
}

base::Status read_skin(const ScriptLine& line, Model& io_model) {
  std::vector<Paint> paints = io_model.skins.front();
  const std::size_t count = paints.size();
  for (const ScriptLine& below : line.below) {
    if (below.word != "paint") return script_error(below, "a skin has lines 'paint'");
    TRY_STATUS(read_paint(below, paints));
    if (paints.size() > count) return script_error(below, "the model has no paint of this name");
  }
  io_model.skins.push_back(std::move(paints));
  return base::Ok{};
}

base::Status read_line(const ScriptLine& line, Kind kind, Model& io_model) {
  switch (kind) {
    case Kind::kFlags:
      return read_flags(line, io_model);
    case Kind::kBone:
      return read_bone(line, io_model);
    case Kind::kPaint:
      return read_paint(line, io_model.skins.front());
    case Kind::kSkin:
      return read_skin(line, io_model);
    case Kind::kShape:
      return read_shape(line, io_model);
    case Kind::kPose:
      return read_pose(line, io_model);
    case Kind::kAnimation:
      return read_animation(line, io_model);
  }
  return base::Ok{};
}

}  // namespace

base::Result<Model> read_model(const ScriptLine& thing) {
  Model model;
  TRY_STATUS(read_head_line(thing, model));
  model.skins.emplace_back();
  std::vector<Kind> kinds;
  for (const ScriptLine& line : thing.below) {
    TRY(const Kind kind, kind_of(line));
    kinds.push_back(kind);
  }
  // Whatever order they stand in: shapes need bones and paints, movements need bones and poses.
  for (const Kind kind :
       {Kind::kFlags, Kind::kBone, Kind::kPaint, Kind::kSkin, Kind::kShape, Kind::kPose, Kind::kAnimation})
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kinds[i] == kind) TRY_STATUS(read_line(thing.below[i], kind, model));
  TRY_STATUS(check_size(thing, model));
  if (model.animations.empty()) {
    Animation still;
    still.name = "still";
    model.animations.push_back(std::move(still));
  }
  return model;
}

}  // namespace temblor::artgen
