// Rules about sizes and names of parts. Each function returns one line for each violation; an empty list
// means that the rule holds.
#pragma once

#include <string>
#include <vector>

#include "architecture/source_tree.h"

namespace temblor::test {

// No file is longer than `max_lines`.
std::vector<std::string> find_long_files(const std::vector<SourceFile>& files, int max_lines);

// No folder holds more than `max_files` of these files directly; sub-folders do not count.
std::vector<std::string> find_crowded_folders(const std::vector<std::string>& paths, int max_files);

// No function is declared or defined with more than `max_parameters` parameters.
std::vector<std::string> find_long_parameter_lists(const std::vector<SourceFile>& files, int max_parameters);

// No two types of one namespace have the same name: the linker would merge their functions within one
// program.
std::vector<std::string> find_duplicate_types(const std::vector<SourceFile>& files);

}  // namespace temblor::test
