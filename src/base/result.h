// Result<T>: a value, or an Error about external input (a file, a packet, an option). Status: a Result
// without value. Nothing in the program throws; errors travel up as return values, and each layer adds what
// it knows:
//
//   base::Result<Level> load(const FileSystem& files) {
//     TRY(base::ByteVector bytes, files.read("maps/start.bsp"));      // returns the error, if there is one
//     TRY(Bsp bsp, formats::read_bsp(bytes).with_file("start.bsp"));  // the reader does not know the name
//     ...
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace temblor::base {

enum class ErrorCode {
  kNotFound,     // no such file, lump, level, variable
  kMalformed,    // the bytes contradict themselves or the format
  kUnsupported,  // valid, but we do not support it (for example a version)
  kTooLarge,     // over a stated limit
  kIo,           // error of the operating system
  kUsage,        // the user's request is invalid
};

// One line for a person. `what` names the place (lump, offset, line) and, if possible, the fix. Readers do
// not know file names; the caller that does adds `file` with with_file().
struct Error {
  ErrorCode code = ErrorCode::kMalformed;
  std::string what;
  std::string file;

  // "FILE: WHAT", or "WHAT" if the file is unknown.
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

// Converts implicitly from a value and from an Error, so that functions can return either.
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

  // Returns this result; adds the file name to its error, if there is one without.
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
