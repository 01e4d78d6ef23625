#include <fmt/format.h>

#include <array>

#include "artgen/models/model.h"
#include "artgen/models/reading/read_parts.h"
#include "artgen/models/reading/values.h"

namespace temblor::artgen {
namespace {

// In the order of the bits of the MDL header; see formats::MdlFlags.
constexpr std::array<std::string_view, 8> kFlagNames = {
    "rocket_trail", "grenade_smoke", "gib_blood", "rotate", "tracer", "zombie_blood", "tracer2", "tracer3"};

base::Status read_flags(const ScriptLine& line, Model& io_model) {
  for (const std::string& value : line.values) {
    const auto* const at = std::find(kFlagNames.begin(), kFlagNames.end(), value);
    if (at == kFlagNames.end())
      return script_error(line, fmt::format("'{}' is not one of {}", value, fmt::join(kFlagNames, ", ")));
    io_model.flags |= 1u << (at - kFlagNames.begin());
  }
  return base::Ok{};
}

base::Status read_head_line(const ScriptLine& asset, Model& io_model) {
  Arguments arguments(asset);
  io_model.path = arguments.text();
  if (!io_model.path.ends_with(".mdl"))
    arguments.set_error("expected the model's file, NAME.mdl, as the first value");
  io_model.density = arguments.number("density", 2, 0.1, 32);
  io_model.floor = arguments.number("floor", -24, -4096, 4096);
  io_model.size = arguments.number("size", 1, 0.05, 20);
  io_model.eye = arguments.vector("eye", math::Vec3(0.0f));
  io_model.random_phase = arguments.flag("random_phase");
  return arguments.finish();
}

// Far above what is useful, and far below the limits of the file format and the skin.
constexpr std::size_t kMaxTriangles = 8192;
constexpr std::int32_t kMaxFrames = 4096;

base::Status check_size(const ScriptLine& asset, const Model& model) {
  if (model.mesh.triangles.empty()) return script_error(asset, "the model has no shapes");
  if (model.mesh.triangles.size() > kMaxTriangles)
    return script_error(asset, fmt::format("{} triangles; a model has at most {}",
                                           model.mesh.triangles.size(), kMaxTriangles));
  std::int32_t frames = 0;
  for (const Animation& animation : model.animations) frames += animation.frames;
  if (frames > kMaxFrames)
    return script_error(asset, fmt::format("{} frames; a model has at most {}", frames, kMaxFrames));
  return base::Ok{};
}

// The kinds of lines, in the order in which they are read.
enum class Kind { kFlags, kBone, kPaint, kSkin, kShape, kPose, kAnimation };

base::Result<Kind> find_line_kind(const ScriptLine& line) {
  constexpr std::array<std::pair<std::string_view, Kind>, 11> kKeywords = {{{"flags", Kind::kFlags},
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
  for (const auto& [word, kind] : kKeywords)
    if (line.keyword == word) return kind;
  if (is_shape_keyword(line.keyword)) return Kind::kShape;
  return script_error(
      line,
      "unknown keyword; models have flags, bone, scale, foot, grip, paint, skin, tube, ball, box, plate, "
      "spike, crystal, pose, animation, cycle and like");
}

// An additional skin: a copy of the model's paints in which some are replaced.
base::Status read_skin(const ScriptLine& line, Model& io_model) {
  std::vector<Paint> paints = io_model.skins.front();
  const std::size_t count = paints.size();
  for (const ScriptLine& below : line.below) {
    if (below.keyword != "paint") return script_error(below, "only 'paint' lines can be under a skin");
    TRY_STATUS(read_paint(below, paints));
    if (paints.size() > count) return script_error(below, "the model has no paint with this name");
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

base::Result<Model> read_model(const ScriptLine& asset) {
  Model model;
  TRY_STATUS(read_head_line(asset, model));
  model.skins.emplace_back();
  std::vector<Kind> kinds;
  for (const ScriptLine& line : asset.below) {
    TRY(const Kind kind, find_line_kind(line));
    kinds.push_back(kind);
  }
  // In the order of dependencies, whatever the order in the script: shapes need bones and paints, animations
  // need poses.
  for (const Kind kind :
       {Kind::kFlags, Kind::kBone, Kind::kPaint, Kind::kSkin, Kind::kShape, Kind::kPose, Kind::kAnimation})
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kinds[i] == kind) TRY_STATUS(read_line(asset.below[i], kind, model));
  TRY_STATUS(check_size(asset, model));
  if (model.animations.empty()) {
    // Every model needs at least one frame.
    Animation still;
    still.name = "still";
    model.animations.push_back(std::move(still));
  }
  return model;
}

}  // namespace temblor::artgen
