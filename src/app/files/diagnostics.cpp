#include "app/files/diagnostics.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace temblor::app {
namespace {

// Replaces only control characters, because paths may have any encoding. A message stays on one line, and a
// file name cannot control the terminal.
std::string replace_control_characters(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return line;
}

}  // namespace

void print_error(const base::Error& error) {
  const bool is_usage = error.code == base::ErrorCode::kUsage;
  fmt::print(stderr, "temblor: {}{}\n", replace_control_characters(error.message()),
             is_usage ? " (see temblor --help)" : "");
}

int exit_status(const base::Error& error) {
  return error.code == base::ErrorCode::kUsage ? kExitUsage : kExitFailure;
}

void print_note(std::string_view text) {
  fmt::print(stderr, "temblor: note: {}\n", replace_control_characters(text));
}

}  // namespace temblor::app
