// Rules about includes. Each function returns one line for each violation, with file and line; an empty list
// means that the rule holds.
#pragma once

#include <string>
#include <vector>

#include "architecture/source_tree.h"

namespace temblor::test {

// A folder includes only the folders that the table in layering.cpp allows. Sub-folders are private to their
// folder, except for the rooms of `formats`, `net` and `client`. Inside `render`, each stage
// includes only earlier stages and, of the folder above it, only the headers that define a frame's input and
// output.
std::vector<std::string> find_layering_violations(const std::vector<SourceFile>& files);

// A header directly in src/FOLDER is public: another folder of src includes it.
std::vector<std::string> find_unused_public_headers(const std::vector<SourceFile>& files);

}  // namespace temblor::test
