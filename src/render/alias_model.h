// An alias model (MDL, MD3, or MD5 file) in the form in which it is drawn. It is made once from the parsed
// file, is immutable, and is shared by all renderers and threads. The layout is private (alias/alias_mesh.h).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/index.h"
#include "formats/models/mdl.h"
#include "formats/models/posed_model.h"
#include "math/vec.h"

namespace temblor::render {

enum class PoseIndex : std::uint32_t {};

struct AliasModel;

// CHECKs that the file has a skin with pixels, a frame, and a vertex; the MDL reader guarantees that. `name`
// is only used in messages.
std::shared_ptr<const AliasModel> make_alias_model(const formats::Mdl& mdl, std::string name);
// CHECKs that the model has skins, with a picture for each mesh and member, and that its vertices are within
// formats::kMaxMdlCoordinate. Pictures of all meshes are joined to one (alias/mesh/skin_atlas.h), so fails if
// that would be too large.
base::Result<std::shared_ptr<const AliasModel>> make_alias_model(const formats::PosedModel& posed,
                                                                 std::string name);

// The pose that frame number `frame` shows at `time_s`. A frame group plays in a loop. A frame number that
// the model lacks shows frame 0, as in stock Quake.
PoseIndex pose_at(const AliasModel& model, std::uint32_t frame, double time_s);
// The skin picture for skin number `skin`, with the same rules for groups and missing numbers.
std::uint32_t skin_at(const AliasModel& model, std::uint32_t skin, double time_s);

// formats::MdlFlags: rotation and the kind of trail.
std::uint32_t find_model_flags(const AliasModel& model);
// True: each entity starts the model's groups at a random time, so that torches do not flicker in step.
bool has_random_phase(const AliasModel& model);
std::uint32_t frame_count(const AliasModel& model);
std::uint32_t skin_count(const AliasModel& model);
const std::string& model_name(const AliasModel& model);
// Encloses every pose, in model space.
const math::Bounds& model_bounds(const AliasModel& model);
// The mean of the foremost vertices of the first pose, in model space: the mouth of a gun's barrel. Vertices
// within a unit of the largest x count.
math::Vec3 find_foremost_point(const AliasModel& model);

}  // namespace temblor::render
