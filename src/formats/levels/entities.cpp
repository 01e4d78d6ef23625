#include "formats/levels/entities.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

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

// Splits entity text into braces and texts, and counts lines for errors.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : rest_(text.substr(0, text.find('\0'))) {}

  base::Result<Token> next() {
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
      const auto end =
          std::ranges::find_if(rest_, [](char c) { return is_space(c) || is_brace(c) || c == '"'; });
      token.text = take(static_cast<std::size_t>(end - rest_.begin()));
      return token;
    }
    take(1);
    const std::size_t end = rest_.find('"');
    if (end == std::string_view::npos)
      return base::malformed("line {}: this quote is never closed", token.line);
    token.text = take(end);
    take(1);
    return token;
  }

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
      if (!rest_.starts_with("//")) return;
      take(std::min(rest_.find('\n'), rest_.size()));
    }
  }

  std::string_view rest_;
  std::size_t line_ = 1;
};

// Reads the rest of an entity after its opening brace on line `opened_on`.
base::Result<Entity> read_entity(Tokenizer& tokens, std::size_t opened_on) {
  Entity entity;
  while (true) {
    TRY(const Token key, tokens.next());
    switch (key.kind) {
      case Token::Kind::kEnd:
        return base::malformed("line {}: this entity is never closed", opened_on);
      case Token::Kind::kOpen:
        return base::malformed("line {}: an entity starts inside of the one from line {}", key.line,
                               opened_on);
      case Token::Kind::kClose:
        return entity;
      case Token::Kind::kText:
        break;
    }
    TRY(const Token value, tokens.next());
    if (value.kind != Token::Kind::kText)
      return base::malformed("line {}: the key \"{}\" has no value", key.line, key.text);
    entity.pairs.emplace_back(key.text, value.text);
  }
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

base::Result<std::vector<Entity>> read_entities(std::string_view text) {
  std::vector<Entity> entities;
  Tokenizer tokens(text);
  while (true) {
    TRY(const Token token, tokens.next());
    if (token.kind == Token::Kind::kEnd) return entities;
    if (token.kind != Token::Kind::kOpen)
      return base::malformed("line {}: expected the opening brace of an entity", token.line);
    TRY(Entity entity, read_entity(tokens, token.line));
    entities.push_back(std::move(entity));
  }
}

std::string write_entities(const std::vector<Entity>& entities) {
  std::string text;
  for (const Entity& entity : entities) {
    text += "{\n";
    for (const auto& [key, value] : entity.pairs) text += fmt::format("\"{}\" \"{}\"\n", key, value);
    text += "}\n";
  }
  return text;
}

}  // namespace temblor::formats
