// The syntax of console text. A command ends at a newline or ';'. White space separates words. "Double
// quotes" keep a word together, including ';'. A comment runs from // to the end of the line. There are no
// escapes: quotes cannot contain quotes or newlines.
//
//   bind f1 "impulse 7; wait; +attack" // rocket        -> bind | f1 | impulse 7; wait; +attack
//
// Unlike in the original, ':', parentheses, and braces are ordinary characters, and a ';' in a comment does
// not end the comment.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::command {

// Returns the length of the first command in `text`, without the newline or ';' that ends it. The comment of
// the line belongs to the command. 0 for an empty command.
std::size_t command_length(std::string_view text);

// Splits a text into its commands, as parts of `text`; some may be empty.
std::vector<std::string_view> split_commands(std::string_view text);

// Splits a command into words and removes quotes; so words may be empty. An unclosed quote ends with the
// text.
std::vector<std::string> split_words(std::string_view command);

// Parse the whole text as a number; a leading '+' is allowed. Return nullopt for other text, and for numbers
// that are not finite or out of range.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_whole_number(std::string_view text);

// Joins words so that split_words() returns them again. Quotes and newlines inside of words are dropped,
// because they cannot be quoted.
std::string join_words(const std::vector<std::string>& words);

}  // namespace temblor::command
