// Address ranges for bans: "192.0.2.0/24", "2001:db8::/32", or a single host.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "platform/address.h"

namespace temblor::net {

struct AddressPrefix {
  platform::Address base;
  int bits = 128;  // of the 16-byte host in platform::Address; an IPv4 mask has 96 fewer

  bool contains(const platform::Address& address) const;
  bool operator==(const AddressPrefix&) const = default;
};

// Parses "HOST" or "HOST/BITS" with a numeric host, and clears the host bits outside of the mask. Returns
// kUsage with the reason if `text` is invalid.
base::Result<AddressPrefix> parse_prefix(std::string_view text);
// Formats a prefix for parse_prefix(); omits the bits of a single host.
std::string to_text(const AddressPrefix& prefix);

}  // namespace temblor::net
