// Packets of QuakeWorld, which Temblor does not speak: as much as it takes to tell players that they have met
// the other game. Its packets outside a connection begin with four bytes of 255, then a word.
//
//   getchallenge, connect      a client asks to join                        -> print (n) with an explanation
//   status                     asks a server to describe itself             -> n\KEY\VALUE... (rules,
//   players)
#pragma once

#include <string_view>

#include "base/bytes.h"

namespace temblor::net {

// Whether a QuakeWorld client asks to join.
bool is_quakeworld_join(base::Bytes packet);
// The reply that a QuakeWorld client prints to its console.
base::ByteVector make_quakeworld_print(std::string_view text);

base::ByteVector make_quakeworld_status_request();
bool is_quakeworld_status_request(base::Bytes packet);
// Whether a QuakeWorld server has answered that request.
bool is_quakeworld_status(base::Bytes packet);

}  // namespace temblor::net
