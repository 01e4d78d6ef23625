// What the program says when something is wrong: one line on standard error, and an exit status.
#pragma once

#include <string_view>

#include "base/result.h"

namespace temblor::app {

constexpr int kExitSuccess = 0;
constexpr int kExitFailure = 1;  // a file, a folder or the machine
constexpr int kExitUsage = 2;    // the command line

// "temblor: FILE: WHAT". Always one line: control characters (of a file's name, say) become '?'.
// A wrong command line (kUsage) also gets a hint at --help.
void print_error(const base::Error& error);
int exit_status(const base::Error& error);

// "temblor: note: TEXT": worth knowing, but not in the way.
void print_note(std::string_view text);

}  // namespace temblor::app
