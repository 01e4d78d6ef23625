// A word that only the owner of an address can say: the server sends it there, and waits for it to come back.
// It is worked out from the address and a secret, so that nothing needs to be remembered to check it.
//
// SipHash-2-4 (Aumasson and Bernstein, SipHash: a fast short-input PRF, 2012): who has seen any number of
// words, for addresses of his own, cannot tell another's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "platform/address.h"

namespace temblor::net {

using Secret = std::array<std::uint64_t, 2>;

std::uint64_t sip_hash(const Secret& secret, base::Bytes bytes);

// Ten letters and digits. `serial`: another one for each attempt.
std::string challenge_word(const Secret& secret, const platform::Address& address, std::uint64_t serial);

// The message that makes a client say it: console text, "cmd WORD", which clients of any NetQuake pass back.
base::ByteVector challenge_message(std::string_view word);

// What else a client's message holds beside the word said as a console line; nothing where it is not said, or
// the message cannot be read.
std::optional<base::ByteVector> without_word(base::Bytes message, std::string_view word);

}  // namespace temblor::net
