#include "formats/levels/entities.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include "base/text.h"

namespace temblor::formats {
namespace {

constexpr bool is_space(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}
constexpr bool is_brace(char c) {
  return c == '{' || c == '}';
}

struct Token {
  enum class Kind { kEnd, kOpen, kClose, kText };
  Kind kind = Kind::kEnd;
  std::string_view text;  // of kText
  std::size_t line = 1;   // of its first character
};

// Splits entity text into braces and texts, counts lines, and keeps the first fault.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : rest_(text.substr(0, text.find('\0'))) {}

  Token next() {
    skip_space_and_comments();
    Token token{Token::Kind::kEnd, {}, line_};
    if (rest_.empty()) return token;
    if (is_brace(rest_.front())) {
      token.kind = rest_.front() == '{' ? Token::Kind::kOpen : Token::Kind::kClose;
      take(1);
      return token;
    }
    token.kind = Token::Kind::kText;
    if (rest_.front() != '"') {
      // A quote inside of a word is a part of it, so an open quote costs other engines one entity, not the
      // rest.
      const auto end = std::ranges::find_if(rest_, [](char c) { return is_space(c) || is_brace(c); });
      token.text = take(static_cast<std::size_t>(end - rest_.begin()));
      return token;
    }
    take(1);
    const std::size_t end = rest_.find('"');
    if (end == std::string_view::npos) add_fault("line {}: this quote is never closed", token.line);
    token.text = take(std::min(end, rest_.size()));
    take(std::min<std::size_t>(1, rest_.size()));
    return token;
  }

  template <typename... Args>
  void add_fault(fmt::format_string<Args...> format, Args&&... args) {
    if (first_fault_.empty()) first_fault_ = fmt::format(format, std::forward<Args>(args)...);
  }
  const std::string& first_fault() const { return first_fault_; }

 private:
  std::string_view take(std::size_t count) {
    const std::string_view taken = rest_.substr(0, count);
    line_ += static_cast<std::size_t>(std::ranges::count(taken, '\n'));
    rest_.remove_prefix(count);
    return taken;
  }
  void skip_space_and_comments() {
    while (true) {
      const auto end = std::ranges::find_if_not(rest_, is_space);
      take(static_cast<std::size_t>(end - rest_.begin()));
      if (rest_.starts_with("//")) {
        take(std::min(rest_.find('\n'), rest_.size()));
      } else if (rest_.starts_with("/*")) {
        take(2);
        take(std::min(rest_.find("*/"), rest_.size()));
        take(std::min<std::size_t>(2, rest_.size()));
      } else {
        return;
      }
    }
  }

  std::string_view rest_;
  std::size_t line_ = 1;
  std::string first_fault_;
};

// Reads the rest of an entity after its opening brace, which is `io_token`. Sets it to the first token that
// does not belong to the entity.
Entity read_entity(Tokenizer& io_tokens, Token& io_token) {
  const std::size_t opened_on = io_token.line;
  Entity entity;
  io_token = io_tokens.next();
  while (io_token.kind == Token::Kind::kText) {
    const Token key = io_token;
    io_token = io_tokens.next();
    if (io_token.kind != Token::Kind::kText) {
      io_tokens.add_fault("line {}: the key \"{}\" has no value", key.line, base::printable(key.text));
      break;
    }
    entity.pairs.emplace_back(key.text, io_token.text);
    io_token = io_tokens.next();
  }
  if (io_token.kind == Token::Kind::kEnd)
    io_tokens.add_fault("line {}: this entity is never closed", opened_on);
  else if (io_token.kind == Token::Kind::kOpen)
    io_tokens.add_fault("line {}: an entity starts inside of the one from line {}", io_token.line, opened_on);
  else
    io_token = io_tokens.next();
  return entity;
}

// Parses numbers separated by white space. Returns false unless there are exactly as many as requested, all
// finite.
bool read_numbers(std::string_view text, std::span<float> out_numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skip_space = [&] { at = std::find_if_not(at, end, is_space); };
  for (float& number : out_numbers) {
    skip_space();
    // from_chars rejects a plus sign, so skip it; but not before another sign.
    if (at != end && *at == '+' && ++at != end && *at == '-') return false;
    const auto [after, code] = std::from_chars(at, end, number);
    if (code != std::errc{} || !std::isfinite(number)) return false;
    at = after;
    if (at != end && !is_space(*at)) return false;
  }
  skip_space();
  return at == end;
}

// Only bare words contain quotes, and those stay bare.
std::string written_text(std::string_view text) {
  return text.find('"') == std::string_view::npos ? fmt::format("\"{}\"", text) : std::string(text);
}

}  // namespace

std::optional<std::string_view> Entity::find(std::string_view key) const {
  for (const auto& [pair_key, value] : pairs)
    if (pair_key == key) return value;
  return std::nullopt;
}

std::optional<math::Vec3> Entity::find_vec3(std::string_view key) const {
  const auto text = find(key);
  std::array<float, 3> numbers{};
  if (!text || !read_numbers(*text, numbers)) return std::nullopt;
  return math::Vec3(numbers[0], numbers[1], numbers[2]);
}

std::optional<float> Entity::find_number(std::string_view key) const {
  const auto text = find(key);
  std::array<float, 1> number{};
  if (!text || !read_numbers(*text, number)) return std::nullopt;
  return number[0];
}

EntityText read_faulty_entities(std::string_view text) {
  EntityText result;
  Tokenizer tokens(text);
  Token token = tokens.next();
  while (token.kind != Token::Kind::kEnd) {
    if (token.kind == Token::Kind::kOpen) {
      result.entities.push_back(read_entity(tokens, token));
    } else {
      tokens.add_fault("line {}: expected the opening brace of an entity", token.line);
      token = tokens.next();
    }
  }
  result.first_fault = tokens.first_fault();
  return result;
}

base::Result<std::vector<Entity>> read_entities(std::string_view text) {
  EntityText result = read_faulty_entities(text);
  if (!result.first_fault.empty()) return base::malformed("{}", result.first_fault);
  return std::move(result.entities);
}

std::string write_entities(const std::vector<Entity>& entities) {
  std::string text;
  for (const Entity& entity : entities) {
    text += "{\n";
    for (const auto& [key, value] : entity.pairs)
      text += fmt::format("{} {}\n", written_text(key), written_text(value));
    text += "}\n";
  }
  return text;
}

}  // namespace temblor::formats
