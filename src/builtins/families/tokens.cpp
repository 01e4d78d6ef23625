// Built-in functions that split a text. The tokens of the last text stay until the next one is split.
#include <algorithm>
#include <optional>

#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// More tokens are ignored.
constexpr std::size_t kMaxTokens = 1024;

bool is_space(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}

// Returns the token that begins at or after `io_place`, and moves past it: a word, or everything between two
// quotes. Empty at the end of the text.
std::optional<Token> take_token(std::string_view text, std::size_t& io_place, bool skips_comments) {
  while (io_place < text.size()) {
    if (is_space(text[io_place]))
      ++io_place;
    else if (skips_comments && text.substr(io_place).starts_with("//"))
      io_place = std::min(text.find('\n', io_place), text.size());
    else
      break;
  }
  if (io_place >= text.size()) return std::nullopt;
  const std::size_t begin = io_place;
  if (text[begin] == '"') {
    const std::size_t end = std::min(text.find('"', begin + 1), text.size());
    io_place = std::min(end + 1, text.size());
    return Token{std::string(text.substr(begin + 1, end - begin - 1)), begin, io_place};
  }
  while (io_place < text.size() && !is_space(text[io_place])) ++io_place;
  return Token{std::string(text.substr(begin, io_place - begin)), begin, io_place};
}

base::Status split(Call& io_call, bool skips_comments) {
  std::vector<Token>& tokens = io_call.context.tokens;
  tokens.clear();
  const std::string_view text = io_call.text(0);
  std::size_t place = 0;
  while (tokens.size() < kMaxTokens) {
    std::optional<Token> token = take_token(text, place, skips_comments);
    if (!token) break;
    tokens.push_back(*std::move(token));
  }
  return io_call.return_number(static_cast<double>(tokens.size()));
}

// tokenize(text): splits the text, and returns the number of tokens, which argv() returns one by one.
// tokenize_console() also skips comments, as the console does.
base::Status tokenize(Call& io_call) {
  return split(io_call, false);
}
base::Status tokenize_console(Call& io_call) {
  return split(io_call, true);
}

// tokenizebyseparator(text, separator, ...): the longest separator that fits ends a token.
base::Status tokenizebyseparator(Call& io_call) {
  std::vector<Token>& tokens = io_call.context.tokens;
  tokens.clear();
  const std::string_view text = io_call.text(0);
  std::size_t begin = 0, at = 0;
  const auto add = [&](std::size_t end) {
    tokens.push_back({std::string(text.substr(begin, end - begin)), begin, end});
  };
  while (at < text.size() && tokens.size() + 1 < kMaxTokens) {
    std::size_t longest = 0;
    for (int i = 1; i < io_call.count(); ++i)
      if (text.substr(at).starts_with(io_call.text(i))) longest = std::max(longest, io_call.text(i).size());
    if (longest > 0) add(at);
    at += std::max<std::size_t>(longest, 1);
    if (longest > 0) begin = at;
  }
  if (!text.empty()) add(text.size());
  return io_call.return_number(static_cast<double>(tokens.size()));
}

// Null if there is no token of the number in parameter 1.
const Token* find_token(const Call& call) {
  const std::vector<Token>& tokens = call.context.tokens;
  const int i = call.whole(0);
  return i >= 0 && static_cast<std::size_t>(i) < tokens.size() ? &tokens[static_cast<std::size_t>(i)]
                                                               : nullptr;
}

// argv(index): empty if there is no such token.
base::Status argv(Call& io_call) {
  const Token* const token = find_token(io_call);
  return io_call.return_text(token == nullptr ? std::string_view() : token->text);
}

// argv_start_index() and argv_end_index(): where the token is in the text, or -1.
base::Status argv_start_index(Call& io_call) {
  const Token* const token = find_token(io_call);
  return io_call.return_number(token == nullptr ? -1 : static_cast<double>(token->begin));
}
base::Status argv_end_index(Call& io_call) {
  const Token* const token = find_token(io_call);
  return io_call.return_number(token == nullptr ? -1 : static_cast<double>(token->end));
}

}  // namespace

std::span<const Entry> token_builtins() {
  static constexpr Entry kEntries[] = {
      {441, "tokenize", tokenize},
      {442, "argv", argv},
      {479, "tokenizebyseparator", tokenizebyseparator},
      {514, "tokenize_console", tokenize_console},
      {515, "argv_start_index", argv_start_index},
      {516, "argv_end_index", argv_end_index},
  };
  return kEntries;
}

}  // namespace temblor::builtins
