// UTF-8 text as people type it, and its conversion to the console's one-byte characters. Input is never
// trusted: any bytes are accepted, and invalid ones are replaced.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace temblor::client {

// The length in bytes of the character that begins at `at`, 1 to 4; 0 if none begins there: within a
// character, in invalid bytes, or at the end.
std::size_t character_length(std::string_view text, std::size_t at);

// Makes text fit for an input line: drops control characters, turns line ends and tabs into spaces, and
// replaces each invalid byte with '?'.
std::string sanitize_typed_text(std::string_view text);

// Converts to the console's character set: one byte per character, '?' for characters that are not ASCII.
std::string to_glyphs(std::string_view text);
// The same, in the bronze half of the character set.
std::string to_bronze_glyphs(std::string_view text);

}  // namespace temblor::client
