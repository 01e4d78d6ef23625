// Bytes as letters that mean nothing to a console, six bits each: A-Z a-z 0-9 - _.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.h"

namespace temblor::net {

// Each byte's upper bits first; the last letter is filled up with zeros.
void append_base64url(base::Bytes bytes, std::string& io_text);
// How many bytes they are; bits that are no whole byte are left over. Nothing where another letter is among
// them, and where `out_bytes` has no room.
std::optional<std::size_t> read_base64url(std::string_view text, std::span<std::byte> out_bytes);

}  // namespace temblor::net
