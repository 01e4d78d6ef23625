// Readers for the lines of a model's script, one for each kind of line. Each adds what its line says to the
// model. Errors begin with the line's number.
//
// read_model (model.h) calls them in the order of their dependencies: bones, paints, skins, shapes, poses,
// animations.
#pragma once

#include "artgen/models/model.h"

namespace temblor::artgen {

// Whether the keyword is a shape: tube, ball, box, plate, spike, or crystal.
bool is_shape_keyword(std::string_view word);

// The lines bone, scale, foot, and grip.
base::Status read_bone(const ScriptLine& line, Model& io_model);
// Replaces a paint with the same name, so that an asset can change the paints of a part.
base::Status read_paint(const ScriptLine& line, std::vector<Paint>& io_paints);
// Needs all bones and paints.
base::Status read_shape(const ScriptLine& line, Model& io_model);
// Needs all bones. Replaces a pose with the same name.
base::Status read_pose(const ScriptLine& line, Model& io_model);
// The lines animation, cycle, and like. Needs all poses.
base::Status read_animation(const ScriptLine& line, Model& io_model);

// The index of a bone. Fails if no bone has the name.
base::Result<std::size_t> find_bone(const ScriptLine& line, const Skeleton& skeleton, std::string_view name);

}  // namespace temblor::artgen
