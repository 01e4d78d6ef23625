// Challenge cookies: proof that a peer receives packets at the address that it claims. The server sends a
// cookie to the address, and the peer must return it before it becomes a connection.
//
//   server -> peer   svc_stufftext "cmd COOKIE\n"      every NetQuake client executes this and replies
//   peer -> server   clc_stringcmd "COOKIE"
//
// The cookie is the SipHash-2-4 of the address under a server secret (Aumasson and Bernstein, "SipHash: a
// fast short-input PRF", 2012). So checking it needs no table, and a peer that has seen cookies for its own
// addresses cannot guess the cookie of another address.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "platform/address.h"

namespace temblor::net {

// 128-bit key.
using Secret = std::array<std::uint64_t, 2>;

// SipHash-2-4 of `bytes`.
std::uint64_t sip_hash(const Secret& secret, base::Bytes bytes);

// Returns the cookie for an address: ten hexadecimal digits (40 bits). Pass a new `serial` for each attempt.
std::string make_challenge_cookie(const Secret& secret, const platform::Address& address,
                                  std::uint64_t serial);

// Makes the reliable message that asks a client for the cookie.
base::ByteVector make_challenge_message(std::string_view cookie);

// Returns the client message without the console line that repeats the cookie. Returns nullopt if the message
// does not contain the cookie, or cannot be read.
std::optional<base::ByteVector> remove_challenge_reply(base::Bytes message, std::string_view cookie);

}  // namespace temblor::net
