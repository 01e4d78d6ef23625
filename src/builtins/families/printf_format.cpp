#include "builtins/families/printf_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>

namespace temblor::builtins {
namespace {

// Bounds the memory that a short format can ask for.
constexpr int kMaxWidth = 512;
constexpr std::string_view kFlags = "-+ 0#";
constexpr std::string_view kWholeConversions = "dicxXou", kFloatConversions = "fFeEgGv";

// One parsed directive, with its width and precision already read.
struct Directive {
  std::string flags;
  int width = 0;
  int precision = -1;  // -1: not given
  char length = 0;     // 'l', 'h' or 0
  char conversion = 0;
  int value = 0;  // the index of the value, from 0
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Reads the format from left to right. `rest_` is what is still to be read, `text_` the result so far.
class Formatter {
 public:
  Formatter(std::string_view format, vm::Machine& io_machine, int first)
      : rest_(format), machine_(io_machine), first_(first) {}

  std::string run() {
    while (!rest_.empty() && text_.size() < kMaxFormattedChars) {
      const std::size_t plain = std::min(rest_.find('%'), rest_.size());
      text_ += rest_.substr(0, plain);
      rest_.remove_prefix(plain);
      if (!rest_.empty()) one_directive();
    }
    text_.resize(std::min(text_.size(), kMaxFormattedChars));
    return std::move(text_);
  }

 private:
  void one_directive() {
    const std::string_view begin = rest_;
    rest_.remove_prefix(1);
    if (take('%')) {
      text_ += '%';
      return;
    }
    if (const std::optional<Directive> directive = parse())
      write(*directive);
    else
      text_ += begin.substr(0, begin.size() - rest_.size());
  }

  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  // Reads digits. Empty: there are none. At most kMaxWidth.
  std::optional<int> take_number() {
    if (rest_.empty() || !is_digit(rest_.front())) return std::nullopt;
    int number = 0;
    for (; !rest_.empty() && is_digit(rest_.front()); rest_.remove_prefix(1))
      number = std::min(number * 10 + (rest_.front() - '0'), kMaxWidth);
    return number;
  }

  // Reads a width or a precision.
  std::optional<int> take_size() {
    if (!take('*')) return take_number();
    return static_cast<int>(std::clamp(number(next_value_++), -double{kMaxWidth}, double{kMaxWidth}));
  }

  // "2$" selects the second value. Anything else is not an index, and stays unread.
  std::optional<int> take_index() {
    const std::string_view before = rest_;
    const std::optional<int> index = take_number();
    if (index && *index >= 1 && take('$')) return *index - 1;
    rest_ = before;
    return std::nullopt;
  }

  // Reads a directive. Empty: it makes no sense, and rest_ starts after the part that was understood.
  std::optional<Directive> parse() {
    Directive directive;
    const std::optional<int> index = take_index();
    while (!rest_.empty() && kFlags.find(rest_.front()) != std::string_view::npos) {
      if (directive.flags.find(rest_.front()) == std::string::npos) directive.flags += rest_.front();
      rest_.remove_prefix(1);
    }
    directive.width = take_size().value_or(0);
    if (directive.width < 0) {
      directive.flags += '-';
      directive.width = -directive.width;
    }
    if (take('.')) directive.precision = take_size().value_or(0);
    while (rest_.starts_with('l') || rest_.starts_with('h')) {
      directive.length = rest_.front();
      rest_.remove_prefix(1);
    }
    if (rest_.empty()) return std::nullopt;
    directive.conversion = rest_.front();
    rest_.remove_prefix(1);
    if ((std::string(kWholeConversions) + std::string(kFloatConversions) + 's').find(directive.conversion) ==
        std::string::npos)
      return std::nullopt;
    directive.value = index ? *index : next_value_++;
    return directive;
  }

  bool is_passed(int value) const {
    return value < vm::Machine::kMaxParameters && first_ + value < machine_.parameter_count();
  }
  // NaN counts as 0 where a whole number is needed; see whole().
  double number(int value) const {
    const double found = is_passed(value) ? double{machine_.parameter_float(first_ + value)} : 0.0;
    return std::isnan(found) ? 0.0 : found;
  }

  std::int32_t word(int value) const {
    return is_passed(value) ? std::bit_cast<std::int32_t>(machine_.parameter_float(first_ + value)) : 0;
  }

  // Whether the value is an integer. Programs of version 6 have no integers, except in words of other types,
  // such as entities. These are small: as floats they would be denormal, or NaN if they are negative.
  bool holds_whole(const Directive& directive) const {
    if (directive.length != 0) return directive.length == 'l';
    return directive.conversion == 'i' && !std::isnormal(std::bit_cast<float>(word(directive.value)));
  }

  std::int64_t whole(const Directive& directive) const {
    if (holds_whole(directive)) return word(directive.value);
    return static_cast<std::int64_t>(std::clamp(number(directive.value), -9e18, 9e18));
  }

  double fraction(const Directive& directive) const {
    if (holds_whole(directive)) return word(directive.value);
    return is_passed(directive.value) ? double{machine_.parameter_float(first_ + directive.value)} : 0.0;
  }

  // `kind` is C's length and conversion for the type of `value`.
  template <typename Value>
  void print(const Directive& directive, const char* kind, Value value) {
    const std::string precision = directive.precision < 0 ? "" : fmt::format(".{}", directive.precision);
    const std::string width = directive.width == 0 ? "" : fmt::format("{}", directive.width);
    const std::string format = "%" + directive.flags + width + precision + kind;
    // The longest result has all digits of a double, and a precision after them.
    std::array<char, 2 * kMaxWidth> buffer{};
    const int size = std::snprintf(buffer.data(), buffer.size(), format.c_str(), value);
    text_.append(buffer.data(), std::min(buffer.size() - 1, static_cast<std::size_t>(std::max(size, 0))));
  }

  // Like print(), for text that may be longer than its buffer.
  void print_text(const Directive& directive, std::string_view text) {
    if (directive.precision >= 0) text = text.substr(0, static_cast<std::size_t>(directive.precision));
    const std::size_t width = static_cast<std::size_t>(directive.width);
    const std::string padding(width > text.size() ? width - text.size() : 0, ' ');
    const bool is_left = directive.flags.find('-') != std::string::npos;
    text_ += is_left ? std::string(text) + padding : padding + std::string(text);
  }

  void write_whole(const Directive& directive) {
    const std::int64_t value = whole(directive);
    switch (directive.conversion) {
      case 'c': {
        const char character = static_cast<char>(value & 0xff);
        return print_text(directive, std::string_view(&character, character == '\0' ? 0 : 1));
      }
      case 'd':
      case 'i':
        return print(directive, "lld", static_cast<long long>(value));
      default:
        const char kind[] = {directive.conversion, '\0'};
        return print(directive, kind, static_cast<unsigned int>(static_cast<std::uint64_t>(value)));
    }
  }

  void write_vector(const Directive& directive) {
    const math::Vec3 vector =
        is_passed(directive.value) ? machine_.parameter_vector(first_ + directive.value) : math::Vec3(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) text_ += ' ';
      print(directive, "g", double{vector[axis]});
    }
  }

  void write(const Directive& directive) {
    if (directive.conversion == 's')
      return print_text(directive, is_passed(directive.value)
                                       ? machine_.parameter_text(first_ + directive.value)
                                       : std::string_view());
    if (directive.conversion == 'v') return write_vector(directive);
    if (kWholeConversions.find(directive.conversion) != std::string_view::npos) return write_whole(directive);
    const char kind[] = {directive.conversion, '\0'};
    print(directive, kind, fraction(directive));
  }

  std::string_view rest_;
  vm::Machine& machine_;
  int first_;
  int next_value_ = 0;
  std::string text_;
};

}  // namespace

std::string format_parameters(std::string_view format, vm::Machine& io_machine, int first) {
  return Formatter(format, io_machine, first).run();
}

}  // namespace temblor::builtins
