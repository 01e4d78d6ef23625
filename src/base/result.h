// Result<T>: a value, or an Error that says what is wrong with something from outside (a file, a packet, an
// option).
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace temblor::base {

enum class ErrorCode {
  kNotFound,     // no such file, lump, level, variable
  kMalformed,    // the bytes contradict themselves or the format
  kUnsupported,  // a known kind of thing that we do not handle (an unknown version)
  kTooLarge,     // over a stated limit
  kIo,           // the operating system said no
  kUsage,        // the user asked for something that makes no sense
};

// One line for a person: `what` names the lump and offset where they matter, and what to do where that is
// known; `file` is filled in by whoever knows the name (with_file).
struct Error {
  ErrorCode code = ErrorCode::kMalformed;
  std::string what;
  std::string file;

  // "FILE: WHAT", or "WHAT" when no file is known.
  std::string message() const { return file.empty() ? what : file + ": " + what; }
};

template <typename... Args>
Error error(ErrorCode code, fmt::format_string<Args...> format, Args&&... args) {
  return Error{code, fmt::format(format, std::forward<Args>(args)...), {}};
}
template <typename... Args>
Error malformed(fmt::format_string<Args...> format, Args&&... args) {
  return Error{ErrorCode::kMalformed, fmt::format(format, std::forward<Args>(args)...), {}};
}

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  // CHECKs ok().
  T& value() & {
    CHECK(ok(), "{}", std::get<1>(state_).message());
    return std::get<0>(state_);
  }
  const T& value() const& {
    CHECK(ok(), "{}", std::get<1>(state_).message());
    return std::get<0>(state_);
  }
  T&& value() && {
    CHECK(ok(), "{}", std::get<1>(state_).message());
    return std::move(std::get<0>(state_));
  }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }

  // CHECKs !ok().
  const Error& error() const {
    CHECK(!ok());
    return std::get<1>(state_);
  }

  // The same result, its error (if any) naming the file.
  Result with_file(std::string_view file) && {
    if (!ok() && std::get<1>(state_).file.empty()) std::get<1>(state_).file = file;
    return std::move(*this);
  }

 private:
  std::variant<T, Error> state_;
};

// Success without a value.
struct Ok {};
using Status = Result<Ok>;

}  // namespace temblor::base

#define TEMBLOR_JOIN_INNER(a, b) a##b
#define TEMBLOR_JOIN(a, b) TEMBLOR_JOIN_INNER(a, b)

// TRY(auto x, f());  declares x from f()'s value, or returns f()'s error from the enclosing function.
#define TRY(declaration, expression) \
  TEMBLOR_TRY_INNER(TEMBLOR_JOIN(try_result_, __LINE__), declaration, expression)
#define TEMBLOR_TRY_INNER(name, declaration, expression) \
  auto name = (expression);                              \
  if (!name.ok()) return name.error();                   \
  declaration = std::move(name).value()

// TRY_STATUS(f());  returns f()'s error, if it has one.
#define TRY_STATUS(expression)                                                       \
  do {                                                                               \
    if (auto try_status = (expression); !try_status.ok()) return try_status.error(); \
  } while (false)
