#include "command/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace temblor::command {
namespace {

bool is_space(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}

bool is_comment_at(std::string_view text, std::size_t position) {
  return text.substr(position, 2) == "//";
}

// std::from_chars does not depend on the locale, which decides about decimal points elsewhere.
template <typename Number>
std::optional<Number> parse(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool needs_quotes(std::string_view word) {
  return word.empty() || word.find("//") != std::string_view::npos ||
         std::any_of(word.begin(), word.end(), [](char c) { return is_space(c) || c == ';'; });
}

}  // namespace

std::size_t command_length(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') return i;
    if (text[i] == '"') quoted = !quoted;
    if (quoted) continue;
    if (text[i] == ';') return i;
    if (is_comment_at(text, i)) return std::min(text.find('\n', i), text.size());
  }
  return text.size();
}

std::vector<std::string_view> split_commands(std::string_view text) {
  std::vector<std::string_view> commands;
  while (!text.empty()) {
    const std::size_t length = command_length(text);
    commands.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return commands;
}

std::vector<std::string> split_words(std::string_view command) {
  std::vector<std::string> words;
  std::size_t i = 0;
  while (i < command.size()) {
    if (is_space(command[i])) {
      ++i;
      continue;
    }
    if (is_comment_at(command, i)) break;
    std::size_t begin = i, end = i;
    if (command[i] == '"') {
      begin = i + 1;
      end = std::min(command.find('"', begin), command.size());
      i = std::min(end + 1, command.size());
    } else {
      while (end < command.size() && !is_space(command[end]) && command[end] != '"' &&
             !is_comment_at(command, end))
        ++end;
      i = end;
    }
    words.emplace_back(command.substr(begin, end - begin));
  }
  return words;
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> number = parse<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> parse_whole_number(std::string_view text) {
  return parse<std::int64_t>(text);
}

std::string join_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    std::string plain = word;
    std::erase_if(plain, [](char c) { return c == '"' || c == '\n'; });
    if (!text.empty()) text += ' ';
    text += needs_quotes(plain) ? '"' + plain + '"' : plain;
  }
  return text;
}

}  // namespace temblor::command
