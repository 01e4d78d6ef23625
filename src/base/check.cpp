#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace temblor::base {

void check_failed(const char* file, int line, const char* expression, const std::string& detail) {
  fmt::print(stderr, "{}:{}: CHECK failed: {}{}{}\n", file, line, expression, detail.empty() ? "" : ": ",
             detail);
  std::abort();
}

}  // namespace temblor::base
