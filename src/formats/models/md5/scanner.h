// Reads the words and numbers of an MD5 file. After the first fault, all functions return empty values, so
// that readers check once: each loop stops at `ok()`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

class Md5Scanner {
 public:
  explicit Md5Scanner(std::string_view text) : rest_(text.substr(0, text.find('\0'))) {}

  bool ok() const { return !fault_; }
  // CHECKs that there was a fault.
  base::Error error() const;
  // Records the fault at the current line, unless there is one already.
  void fail(std::string_view reason);

  bool is_at_end();
  // Returns the next word: text in quotes, a brace or parenthesis, or letters up to white space or one of
  // those.
  std::string_view word();
  // Takes the next word if it is this one.
  bool accept(std::string_view expected);
  // Takes the next word, which must be this one.
  void expect(std::string_view expected);
  // Takes the next element of a numbered list: NAME NUMBER.
  void expect_element(std::string_view name, std::size_t number);

  std::int32_t whole_number(std::int32_t min, std::int32_t max);
  std::uint32_t count(std::uint32_t max);
  // Finite, within kMaxMd5Number.
  float number();
  math::Vec2 vec2();  // ( X Y )
  math::Vec3 vec3();  // ( X Y Z )

 private:
  void skip_space_and_comments();

  std::string_view rest_;
  std::size_t line_ = 1;
  std::optional<base::Error> fault_;
};

// Completes a quaternion of length 1 that the file stores without its w.
glm::quat complete_orientation(math::Vec3 xyz);

}  // namespace temblor::formats
