// CHECK(condition) aborts the program if a condition is false that only a bug in our own code can break, and
// prints the given operands. Bad input must never fail a CHECK; it is an Error (result.h). DCHECK does the
// same in debug builds only, for checks in inner loops.
#pragma once

#include <fmt/format.h>

#include <string>

namespace temblor::base {

// Prints "FILE:LINE: CHECK failed: EXPRESSION (DETAIL)" to standard error and aborts.
[[noreturn]] void check_failed(const char* file, int line, const char* expression, const std::string& detail);

}  // namespace temblor::base

// CHECK(condition) or CHECK(condition, format, arguments...).
#define CHECK(condition, ...)                                                                       \
  do {                                                                                              \
    if (!(condition)) [[unlikely]]                                                                  \
      ::temblor::base::check_failed(__FILE__, __LINE__, #condition, ::fmt::format("" __VA_ARGS__)); \
  } while (false)

#ifdef NDEBUG
#define DCHECK(condition, ...) \
  do {                         \
  } while (false)
#else
#define DCHECK(condition, ...) CHECK(condition __VA_OPT__(, ) __VA_ARGS__)
#endif
