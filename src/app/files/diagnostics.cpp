#include "app/files/diagnostics.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace temblor::app {
namespace {

// Paths may be in any encoding, so only control characters are replaced.
std::string on_one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return line;
}

}  // namespace

void print_error(const base::Error& error) {
  const bool is_usage = error.code == base::ErrorCode::kUsage;
  fmt::print(stderr, "temblor: {}{}\n", on_one_line(error.message()),
             is_usage ? " (temblor --help says more)" : "");
}

int exit_status(const base::Error& error) {
  return error.code == base::ErrorCode::kUsage ? kExitUsage : kExitFailure;
}

void print_note(std::string_view text) {
  fmt::print(stderr, "temblor: note: {}\n", on_one_line(text));
}

}  // namespace temblor::app
