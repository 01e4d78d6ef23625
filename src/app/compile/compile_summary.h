// The messages of a compilation, for mappers. Problems go to standard error, results to standard output.
#pragma once

#include <string>

#include "app/compile/level_output.h"
#include "compiler/build.h"
#include "compiler/compile_level.h"
#include "compiler/report.h"

namespace temblor::app {

// Prints one note per kind of warning: the number of warnings and the first three.
void print_warnings(const compiler::Warnings& warnings);

// Returns "the level leaks, so it has no visibility: entity 3 (light) at 0 0 64, line 120 of the map, can
// reach the outside at 144 0 64".
std::string describe_leak(const compiler::LeakPath& leak);

// Prints where the level leaks and which files show the path.
void print_leak(const compiler::LeakPath& leak, const LevelPaths& paths);

// Prints counts with the limits of the original engine, the average share of visible leaves, and the time of
// each stage.
void print_summary(const compiler::Build& build, const compiler::CompileReport& report,
                   const LevelPaths& paths);

// Prints the times of all stages on one line.
void print_times(const compiler::CompileReport& report, const LevelPaths& paths);

}  // namespace temblor::app
