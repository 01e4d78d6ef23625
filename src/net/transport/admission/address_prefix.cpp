#include "net/transport/admission/address_prefix.h"

#include <fmt/format.h>

#include <charconv>

#include "base/text.h"

namespace temblor::net {
namespace {

constexpr int kHostBits = 128, kIp4PrefixBits = 96;

// Returns the mask for byte `index` of a host, of which the first `bits` bits are covered.
std::uint8_t compute_prefix_mask_byte(int bits, int index) {
  const int covered = bits - index * 8;
  if (covered <= 0) return 0;
  return covered >= 8 ? std::uint8_t{0xff} : static_cast<std::uint8_t>(0xff << (8 - covered));
}

}  // namespace

bool AddressPrefix::contains(const platform::Address& address) const {
  for (int i = 0; i < kHostBits / 8; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (((address.host[at] ^ base.host[at]) & compute_prefix_mask_byte(bits, i)) != 0) return false;
  }
  return true;
}

base::Result<AddressPrefix> parse_prefix(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto host = platform::parse_host(text.substr(0, slash), 0);
  if (!host)
    return base::error(base::ErrorCode::kUsage, "'{}' is not a numeric IP address", base::quotable(text));
  AddressPrefix prefix{*host, kHostBits};
  if (slash != std::string_view::npos) {
    const std::string_view number = text.substr(slash + 1);
    const int max_bits = host->is_ip4() ? kHostBits - kIp4PrefixBits : kHostBits;
    int bits = -1;
    const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), bits);
    if (failure != std::errc{} || end != number.data() + number.size() || bits < 0 || bits > max_bits)
      return base::error(base::ErrorCode::kUsage, "'{}': the mask length must be a number from 0 to {}",
                         base::quotable(text), max_bits);
    prefix.bits = kHostBits - max_bits + bits;
  }
  for (int i = 0; i < kHostBits / 8; ++i)
    prefix.base.host[static_cast<std::size_t>(i)] &= compute_prefix_mask_byte(prefix.bits, i);
  return prefix;
}

std::string to_text(const AddressPrefix& prefix) {
  const std::string host = prefix.base.is_local() ? "::" : platform::host_text(prefix.base);
  if (prefix.bits == kHostBits) return host;
  return fmt::format("{}/{}", host, prefix.base.is_ip4() ? prefix.bits - kIp4PrefixBits : prefix.bits);
}

}  // namespace temblor::net
