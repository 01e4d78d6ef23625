// Built-in functions that convert numbers to text and back, and cut, join and split text. Each result is a
// new string. The original has one buffer, which the next call overwrites.
#include <algorithm>

#include "server/builtins/families.h"
#include "server/builtins/text/number_text.h"
#include "server/builtins/text/printf_format.h"
#include "server/builtins/text/text_to_number.h"

namespace temblor::server {
namespace {

// More tokens are ignored.
constexpr std::size_t kMaxTokens = 1024;

// ftos(), vtos() and etos(): a number, a vector and an entity as text.
base::Status ftos(Call& io_call) {
  return io_call.return_text(number_text(io_call.number(0)));
}
base::Status vtos(Call& io_call) {
  return io_call.return_text(vector_text(io_call.vector(0)));
}
base::Status etos(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  return io_call.return_text(fmt::format("entity {}", base::to_size(entity)));
}
// stof() and stov(): the reverse. Text without a number is 0.
base::Status stof(Call& io_call) {
  io_call.machine.return_float(number_from(io_call.text(0)));
  return base::Ok{};
}
base::Status stov(Call& io_call) {
  io_call.machine.return_vector(vector_from(io_call.text(0)));
  return base::Ok{};
}

// Counts bytes: the game's characters have one byte each.
base::Status strlen(Call& io_call) {
  io_call.machine.return_float(static_cast<float>(io_call.text(0).size()));
  return base::Ok{};
}

base::Status strcat(Call& io_call) {
  return io_call.return_text(io_call.joined_text(0));
}

// substring(text, first, count): the part of the range that exists.
base::Status substring(Call& io_call) {
  const std::string text(io_call.text(0));
  const auto first = static_cast<std::size_t>(std::max(io_call.whole(1), 0));
  const auto count = static_cast<std::size_t>(std::max(io_call.whole(2), 0));
  return io_call.return_text(first < text.size() ? std::string_view(text).substr(first, count) : "");
}

// strzone(): a copy that lives until strunzone().
base::Status strzone(Call& io_call) {
  TRY(const vm::StringIndex zoned, io_call.machine.strings().zone(std::string(io_call.text(0))));
  io_call.machine.return_string(zoned);
  return base::Ok{};
}
base::Status strunzone(Call& io_call) {
  if (!io_call.machine.strings().unzone(io_call.machine.parameter_string(0)))
    io_call.warn_once("a string that strzone() did not make");
  return base::Ok{};
}

base::Status sprintf(Call& io_call) {
  return io_call.return_text(format_parameters(io_call.text(0), io_call.machine, 1));
}

// Removes the next token from the text: a word, or everything between two quotes. Empty at the end of the
// text.
std::optional<std::string> take_token(std::string_view& io_text) {
  const auto is_blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  const auto begin = std::find_if_not(io_text.begin(), io_text.end(), is_blank);
  io_text.remove_prefix(static_cast<std::size_t>(begin - io_text.begin()));
  if (io_text.empty()) return std::nullopt;
  if (io_text.front() == '"') {
    io_text.remove_prefix(1);
    const std::size_t size = std::min(io_text.find('"'), io_text.size());
    std::string token(io_text.substr(0, size));
    io_text.remove_prefix(std::min(size + 1, io_text.size()));
    return token;
  }
  const auto end = std::find_if(io_text.begin(), io_text.end(), is_blank);
  std::string token(io_text.begin(), end);
  io_text.remove_prefix(token.size());
  return token;
}

// tokenize(text): splits the text, and returns the number of tokens, which argv() returns one by one.
base::Status tokenize(Call& io_call) {
  std::vector<std::string>& tokens = io_call.game.tokens;
  tokens.clear();
  std::string_view text = io_call.text(0);
  while (tokens.size() < kMaxTokens) {
    std::optional<std::string> token = take_token(text);
    if (!token) break;
    tokens.push_back(*std::move(token));
  }
  io_call.machine.return_float(static_cast<float>(tokens.size()));
  return base::Ok{};
}

// argv(index): empty if there is no such token.
base::Status argv(Call& io_call) {
  const std::vector<std::string>& tokens = io_call.game.tokens;
  const int i = io_call.whole(0);
  const bool is_there = i >= 0 && static_cast<std::size_t>(i) < tokens.size();
  return io_call.return_text(is_there ? std::string_view(tokens[static_cast<std::size_t>(i)]) : "");
}

}  // namespace

std::span<const BuiltinEntry> text_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {26, "ftos", ftos},
      {27, "vtos", vtos},
      {65, "etos", etos},
      {81, "stof", stof},
      {114, "strlen", strlen},
      {115, "strcat", strcat},
      {116, "substring", substring},
      {117, "stov", stov},
      {441, "tokenize", tokenize},
      {442, "argv", argv},
      {118, "strzone", strzone},
      {119, "strunzone", strunzone},
      {627, "sprintf", sprintf},
  };
  return kEntries;
}

}  // namespace temblor::server
