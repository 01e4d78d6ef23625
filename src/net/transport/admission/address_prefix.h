// Networks to keep out: "192.0.2.0/24", "2001:db8::/32", or one host.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "platform/address.h"

namespace temblor::net {

struct AddressPrefix {
  platform::Address base;
  int bits = 128;  // of the host as platform::Address holds it: 96 more than those of an IPv4 mask

  bool contains(const platform::Address& address) const;
  bool operator==(const AddressPrefix&) const = default;
};

// "HOST" or "HOST/BITS", the host in numbers; bits of the host beyond the mask are cleared. kUsage with what
// is wrong.
base::Result<AddressPrefix> parse_prefix(std::string_view text);
// As parse_prefix reads it; one host without its bits.
std::string to_text(const AddressPrefix& prefix);

}  // namespace temblor::net
