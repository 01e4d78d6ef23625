// Errors and notes of the program: one line each on standard error, and an exit status.
#pragma once

#include <string_view>

#include "base/result.h"

namespace temblor::app {

constexpr int kExitSuccess = 0;
// A problem with a file, a folder, or the machine.
constexpr int kExitFailure = 1;
// A problem with the command line.
constexpr int kExitUsage = 2;

// Prints "temblor: FILE: PROBLEM". Always one line: control characters, for example in file names, become
// '?'. Usage errors also point to --help.
void print_error(const base::Error& error);
int exit_status(const base::Error& error);

// Prints "temblor: note: TEXT" for a problem that does not stop the command.
void print_note(std::string_view text);

}  // namespace temblor::app
