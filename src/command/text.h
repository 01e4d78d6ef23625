// The text that commands are written in: commands end at a newline or ';', words are separated by white
// space, "double quotes" keep a word (and a ';') together, and // starts a comment that reaches to the line's
// end. There is no escape: a quote cannot hold a quote or a newline. Unlike the original, ':', parentheses
// and braces are ordinary characters, and a ';' in a comment ends nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::command {

// The number of characters of `text` up to the end of its first command, without the newline or ';' that ends
// it.
std::size_t command_length(std::string_view text);

// The words of one command; quotes are taken off, so a word may be empty. A quote that is never closed ends
// with the text.
std::vector<std::string> split_words(std::string_view command);

// A number that is all of the text, a '+' before it allowed; nothing for other text, and for what is not
// finite or does not fit.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_whole_number(std::string_view text);

// One text that splits into these words again, as far as quoting allows: a quote or newline inside a word is
// left out.
std::string join_words(const std::vector<std::string>& words);

}  // namespace temblor::command
