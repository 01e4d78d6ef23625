// A libFuzzer program for the targets of a folder: `fuzz_FOLDER TARGET [libFuzzer's options] [corpus
// folders]`. Without arguments it lists the targets.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz/targets.h"

namespace {

using namespace temblor::fuzz;

// libFuzzer's -jobs, -merge and -minimize_crash start the program again without the target's name, so the
// name is passed on in the environment.
constexpr const char* kTargetVariable = "TEMBLOR_FUZZ_TARGET";

TargetFunction chosen_target = nullptr;

TargetFunction find_target(std::string_view name) {
  for (const Target& target : all_targets())
    if (target.name == name) return target.run;
  return nullptr;
}

[[noreturn]] void end_with_list_of_targets(const char* program) {
  std::fprintf(stderr, "usage: %s TARGET [libFuzzer's options] [corpus folders]\ntargets:", program);
  for (const Target& target : all_targets()) std::fprintf(stderr, " %s", target.name);
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

// libFuzzer calls this before it reads the command line, from which the target's name is removed here.
extern "C" int LLVMFuzzerInitialize(int* io_count, char*** io_arguments) {
  char** arguments = *io_arguments;
  if (*io_count > 1 && (chosen_target = find_target(arguments[1])) != nullptr) {
    setenv(kTargetVariable, arguments[1], 1);
    arguments[1] = arguments[0];
    ++*io_arguments;
    --*io_count;
    return 0;
  }
  const char* inherited = std::getenv(kTargetVariable);
  if (inherited != nullptr) chosen_target = find_target(inherited);
  if (chosen_target == nullptr) end_with_list_of_targets(arguments[0]);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return chosen_target(data, size);
}
