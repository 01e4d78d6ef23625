// Binary data as text that is safe inside a console line: base64url (RFC 4648, section 5: A-Z a-z 0-9 - _)
// without padding. The move acknowledgments of numbered_moves.h use it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.h"

namespace temblor::net {

// Appends ceil(size * 8 / 6) characters to `io_text`, most significant bits first; the last character is
// padded with zero bits.
void append_base64url(base::Bytes bytes, std::string& io_text);

// Decodes `text` into `out_bytes` and returns the number of bytes written. Ignores trailing bits that do not
// fill a byte. Returns nullopt if a character is not in the alphabet or `out_bytes` is too small.
std::optional<std::size_t> read_base64url(std::string_view text, std::span<std::byte> out_bytes);

}  // namespace temblor::net
