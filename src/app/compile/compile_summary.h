// What a mapper is told of a compilation.
#pragma once

#include <string>

#include "app/compile/level_output.h"
#include "compiler/build.h"
#include "compiler/compile_level.h"
#include "compiler/report.h"

namespace temblor::app {

// Notes: the first of each kind, with how many there are.
void print_warnings(const compiler::Warnings& warnings);

// What to do about it is for the caller to say: "the level leaks, so ...: entity 3 (light) at 0 0 64, line
// 120 of the map, sees the outside".
std::string describe_leak(const compiler::LeakPath& leak);

// Where the level leaks, and where that can be seen.
void print_leak(const compiler::LeakPath& leak, const LevelPaths& paths);

// Counts beside the limits of the original engine, what leaves see, the time of each stage.
void print_summary(const compiler::Build& build, const compiler::CompileReport& report,
                   const LevelPaths& paths);

// The times in one line.
void print_times(const compiler::CompileReport& report, const LevelPaths& paths);

}  // namespace temblor::app
