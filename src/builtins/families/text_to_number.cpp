#include "builtins/families/text_to_number.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace temblor::builtins {
namespace {

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// Removes the number from the beginning of the text.
float read_number(std::string_view& io_text) {
  while (!io_text.empty() && is_blank(io_text.front())) io_text.remove_prefix(1);
  if (io_text.starts_with('+') && !io_text.starts_with("+-")) io_text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(io_text.data(), io_text.data() + io_text.size(), value);
  io_text.remove_prefix(static_cast<std::size_t>(end - io_text.data()));
  if (error != std::errc{}) return 0;
  constexpr double kMax = std::numeric_limits<float>::max();
  return static_cast<float>(value > kMax ? kMax : value < -kMax ? -kMax : value);
}

}  // namespace

float number_from(std::string_view text) {
  return read_number(text);
}

math::Vec3 vector_from(std::string_view text) {
  const std::size_t quote = text.find('\'');
  if (quote != std::string_view::npos) text.remove_prefix(quote + 1);
  math::Vec3 value{0.0f};
  for (int axis = 0; axis < 3; ++axis) value[axis] = read_number(text);
  return value;
}

}  // namespace temblor::builtins
