// An alias model as it is drawn: made once from the file's, immutable, shared.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/index.h"
#include "formats/models/mdl.h"
#include "math/vec.h"

namespace temblor::render {

enum class PoseIndex : std::uint32_t {};

struct AliasModel;

// `name` is for messages.
std::shared_ptr<const AliasModel> make_alias_model(const formats::Mdl& mdl, std::string name);

// What frame number `frame` shows at `time_s`, a group's animation included. A frame that the model lacks is
// frame 0, as in the original.
PoseIndex pose_at(const AliasModel& model, std::uint32_t frame, double time_s);
// The skin picture, alike.
std::uint32_t skin_at(const AliasModel& model, std::uint32_t skin, double time_s);

std::uint32_t flags_of(const AliasModel& model);  // formats::MdlFlags
bool random_phase_of(const AliasModel& model);    // its groups start at a time of their own for each entity
std::uint32_t frame_count(const AliasModel& model);
std::uint32_t skin_count(const AliasModel& model);
const std::string& name_of(const AliasModel& model);
// Of every pose together, in model space.
const math::Bounds& bounds_of(const AliasModel& model);

}  // namespace temblor::render
