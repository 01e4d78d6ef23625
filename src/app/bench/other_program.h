// Runs another program's benchmark, to compare it with ours (`temblor bench --against COMMAND`).
#pragma once

#include <string>
#include <string_view>

#include "app/commands/options.h"
#include "app/files/interrupt.h"
#include "base/result.h"

namespace temblor::app {

// A shell command that prints frames per second as its last number.
struct OtherProgram {
  std::string command;
  // Its parameters: $1 and $2 are the width and height, $3 is the level or demo.
  FrameSize size;
  std::string name;
};

// Runs the command with /bin/sh and returns its frames per second, more than 0. Its standard input is empty,
// and it has no terminal. Processes that it leaves behind are ended.
// Errors: it fails, prints no such number or more than 16 MiB, or a signal interrupts it.
base::Result<double> measure_other_program(const OtherProgram& program, Interrupt& interrupt);

// Returns the last number of a program's output, for example 72.5 of "72.5 fps" or "fps=72.5 (demo1)". A
// number may have a sign, an exponent, and a unit, but does not follow a letter directly: demo1 has none.
// Errors (kMalformed, "prints ..."): there is no number, or the last one may mean several, such as 1,234.5 or
// 640x480.
base::Result<double> find_last_number(std::string_view output);

}  // namespace temblor::app
