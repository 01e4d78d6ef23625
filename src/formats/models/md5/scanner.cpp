#include "formats/models/md5/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "formats/models/md5.h"

namespace temblor::formats {
namespace {

constexpr bool is_md5_space(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}
constexpr bool is_bracket(char c) {
  return c == '{' || c == '}' || c == '(' || c == ')';
}

template <typename Number>
std::optional<Number> parse(std::string_view word) {
  Number number{};
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (fault != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

}  // namespace

base::Error Md5Scanner::error() const {
  CHECK(fault_.has_value());
  return *fault_;
}

void Md5Scanner::fail(std::string_view reason) {
  if (!fault_) fault_ = base::malformed("line {}: {}", line_, reason);
}

bool Md5Scanner::is_at_end() {
  skip_space_and_comments();
  return rest_.empty();
}

std::string_view Md5Scanner::word() {
  if (!ok()) return {};
  if (is_at_end()) {
    fail("the file ends too early");
    return {};
  }
  const bool is_quoted = rest_.front() == '"';
  if (is_quoted) rest_.remove_prefix(1);
  const auto end = std::ranges::find_if(rest_, [&](char c) {
    return is_quoted ? c == '"' || c == '\n' : is_md5_space(c) || is_bracket(c) || c == '"';
  });
  auto size = static_cast<std::size_t>(end - rest_.begin());
  if (is_quoted && (end == rest_.end() || *end != '"')) {
    fail("this quote is never closed");
    return {};
  }
  if (!is_quoted && size == 0) size = 1;  // a bracket
  const std::string_view taken = rest_.substr(0, size);
  rest_.remove_prefix(size + (is_quoted ? 1 : 0));
  return taken;
}

bool Md5Scanner::accept(std::string_view expected) {
  const std::string_view before = rest_;
  const std::size_t line = line_;
  if (!ok() || is_at_end()) return false;
  if (word() == expected) return true;
  rest_ = before;
  line_ = line;
  return false;
}

void Md5Scanner::expect(std::string_view expected) {
  const std::string_view found = word();
  if (ok() && found != expected)
    fail(fmt::format("\"{}\" instead of \"{}\"", base::quotable(found), expected));
}

void Md5Scanner::expect_element(std::string_view name, std::size_t number) {
  expect(name);
  const std::string_view found = word();
  if (ok() && parse<std::size_t>(found) != number)
    fail(fmt::format("{} \"{}\" instead of {}", name, base::quotable(found), number));
}

std::int32_t Md5Scanner::whole_number(std::int32_t min, std::int32_t max) {
  const std::string_view found = word();
  const auto value = parse<std::int32_t>(found);
  if (ok() && (!value || *value < min || *value > max))
    fail(min == max
             ? fmt::format("\"{}\" instead of {}", base::quotable(found), min)
             : fmt::format("\"{}\" is not a whole number from {} to {}", base::quotable(found), min, max));
  return ok() ? *value : 0;
}

std::uint32_t Md5Scanner::count(std::uint32_t max) {
  return static_cast<std::uint32_t>(whole_number(0, static_cast<std::int32_t>(max)));
}

float Md5Scanner::number() {
  const std::string_view found = word();
  const auto value = parse<float>(found);
  if (ok() && (!value || !(std::abs(*value) <= kMaxMd5Number)))
    fail(fmt::format("\"{}\" is not a number within {}", base::quotable(found), kMaxMd5Number));
  return ok() ? *value : 0;
}

math::Vec2 Md5Scanner::vec2() {
  expect("(");
  const float x = number(), y = number();
  expect(")");
  return {x, y};
}

math::Vec3 Md5Scanner::vec3() {
  expect("(");
  const float x = number(), y = number(), z = number();
  expect(")");
  return {x, y, z};
}

void Md5Scanner::skip_space_and_comments() {
  while (!rest_.empty()) {
    if (is_md5_space(rest_.front())) {
      line_ += rest_.front() == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    } else if (rest_.starts_with("//")) {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    } else {
      return;
    }
  }
}

glm::quat complete_orientation(math::Vec3 xyz) {
  const float w = -std::sqrt(std::max(0.0f, 1.0f - glm::dot(xyz, xyz)));
  return glm::normalize(glm::quat(w, xyz.x, xyz.y, xyz.z));
}

}  // namespace temblor::formats
