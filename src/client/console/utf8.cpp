// Follows the table of well-formed byte sequences in the Unicode standard, section 3.9: overlong encodings,
// surrogates and code points past U+10FFFF are invalid.
#include "client/console/utf8.h"

#include <cstdint>

namespace temblor::client {

namespace {

// The facts that a character's first byte gives: the character's length in bytes (0: no character starts with
// this byte), and the valid range of its second byte.
struct Lead {
  std::size_t length = 0;
  std::uint8_t second_min = 0x80, second_max = 0xbf;
};

Lead decode_lead_byte(std::uint8_t byte) {
  if (byte < 0x80) return {1};
  if (byte >= 0xc2 && byte <= 0xdf) return {2};
  if (byte == 0xe0) return {3, 0xa0, 0xbf};  // below: overlong encodings
  if (byte == 0xed) return {3, 0x80, 0x9f};  // above: surrogates
  if (byte >= 0xe1 && byte <= 0xef) return {3};
  if (byte == 0xf0) return {4, 0x90, 0xbf};
  if (byte == 0xf4) return {4, 0x80, 0x8f};  // above: past U+10FFFF
  if (byte >= 0xf1 && byte <= 0xf3) return {4};
  return {};
}

std::uint8_t get_byte(std::string_view text, std::size_t at) {
  return static_cast<std::uint8_t>(text[at]);
}

// C0 controls, DEL, and C1 controls, which take two bytes.
bool is_control(std::string_view character) {
  const std::uint8_t first = get_byte(character, 0);
  if (character.size() == 1) return first < ' ' || first == 0x7f;
  return first == 0xc2 && get_byte(character, 1) < 0xa0;
}

}  // namespace

std::size_t character_length(std::string_view text, std::size_t at) {
  if (at >= text.size()) return 0;
  const Lead lead = decode_lead_byte(get_byte(text, at));
  if (lead.length == 0 || lead.length > text.size() - at) return 0;
  for (std::size_t i = 1; i < lead.length; ++i) {
    const std::uint8_t byte = get_byte(text, at + i);
    if (byte < (i == 1 ? lead.second_min : 0x80) || byte > (i == 1 ? lead.second_max : 0xbf)) return 0;
  }
  return lead.length;
}

std::string sanitize_typed_text(std::string_view text) {
  std::string typed;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const std::string_view character = text.substr(at, length);
    if (length == 0)
      typed += '?';
    else if (character == "\n" || character == "\t")
      typed += ' ';
    else if (!is_control(character))
      typed += character;
    at += length == 0 ? 1 : length;
  }
  return typed;
}

std::string to_glyphs(std::string_view text) {
  std::string glyphs;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    glyphs += length == 1 ? text[at] : '?';
    at += length == 0 ? 1 : length;
  }
  return glyphs;
}

std::string to_bronze_glyphs(std::string_view text) {
  std::string glyphs = to_glyphs(text);
  for (char& c : glyphs) c = static_cast<char>(static_cast<std::uint8_t>(c) | 0x80);
  return glyphs;
}

}  // namespace temblor::client
