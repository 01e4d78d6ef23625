#include "net/transport/base64url.h"

#include <array>
#include <cstdint>

namespace temblor::net {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::uint8_t kInvalid = 255;

// Maps each character to its six bits, others to kInvalid.
constexpr std::array<std::uint8_t, 256> make_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kInvalid);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  return values;
}
constexpr std::array<std::uint8_t, 256> kValues = make_values();

}  // namespace

void append_base64url(base::Bytes bytes, std::string& io_text) {
  std::uint32_t bits = 0;
  int count = 0;
  const auto append_top_bits = [&] { io_text += kAlphabet[bits >> (count - 6) & 63]; };
  for (const std::uint8_t byte : base::as_u8(bytes)) {
    bits = bits << 8 | byte;
    for (count += 8; count >= 6; count -= 6) append_top_bits();
  }
  if (count == 0) return;
  bits <<= 6 - count;
  count = 6;
  append_top_bits();
}

std::optional<std::size_t> read_base64url(std::string_view text, std::span<std::byte> out_bytes) {
  std::size_t size = 0;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kInvalid) return std::nullopt;
    bits = bits << 6 | value;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    if (size == out_bytes.size()) return std::nullopt;
    out_bytes[size++] = static_cast<std::byte>(bits >> count & 255);
  }
  return size;
}

}  // namespace temblor::net
