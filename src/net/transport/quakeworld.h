// Packets of QuakeWorld, and of DarkPlaces's own protocol, which Temblor does not speak: as much as it takes
// to tell players that they have met the other game. These packets begin with four bytes of 255, then a word.
//
//   getchallenge, connect   a client asks to join            -> print (n) with an explanation
//   status                  asks a QuakeWorld server         -> n\KEY\VALUE... (rules, players)
//   getstatus               asks a DarkPlaces server         -> statusResponse (rules, players)
#pragma once

#include <string_view>

#include "base/bytes.h"

namespace temblor::net {

// Whether a QuakeWorld client asks to join.
bool is_quakeworld_join(base::Bytes packet);
// The reply that a QuakeWorld client prints to its console.
base::ByteVector make_quakeworld_print(std::string_view text);

base::ByteVector make_quakeworld_status_request();
// A request of QuakeWorld's or DarkPlaces's status.
bool is_status_request(base::Bytes packet);
// Whether a QuakeWorld server has answered that request.
bool is_quakeworld_status(base::Bytes packet);

// DarkPlaces answers whatever protocol its players use, so an answer alone does not mean that we cannot join.
base::ByteVector make_darkplaces_status_request();
bool is_darkplaces_status(base::Bytes packet);

}  // namespace temblor::net
