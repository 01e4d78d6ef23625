// Text as people type it: UTF-8, one character at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace temblor::client {

// Bytes of the character that begins at `at`; 0 where none does: in the middle of one, in bytes that are no
// UTF-8, at the end.
std::size_t character_length(std::string_view text, std::size_t at);

// Fit for a line to type in: control characters are left out, but for line ends and tabs, which are spaces;
// each byte that belongs to no character becomes '?'.
std::string typed_text(std::string_view text);

// For the console's characters: one byte for each of `text`'s, '?' for what is not ASCII.
std::string to_glyphs(std::string_view text);
// The same in bronze.
std::string to_bronze_glyphs(std::string_view text);

}  // namespace temblor::client
