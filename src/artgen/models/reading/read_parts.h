// The lines of a model's script, kind by kind; each adds what it says to the model. Errors begin with the
// line.
#pragma once

#include "artgen/models/model.h"

namespace temblor::artgen {

bool is_shape_word(std::string_view word);

base::Status read_bone(const ScriptLine& line, Model& io_model);  // bone, scale, foot, grip
base::Status read_paint(const ScriptLine& line, std::vector<Paint>& io_paints);
base::Status read_shape(const ScriptLine& line, Model& io_model);      // after all bones and paints
base::Status read_pose(const ScriptLine& line, Model& io_model);       // after all bones
base::Status read_animation(const ScriptLine& line, Model& io_model);  // after all poses

// A bone's name, where it must be one.
base::Result<std::size_t> find_bone(const ScriptLine& line, const Skeleton& skeleton, std::string_view name);

}  // namespace temblor::artgen
