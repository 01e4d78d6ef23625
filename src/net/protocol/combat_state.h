// Whether monsters hunt the player, for the combat layer of music. It is a console comment in svc_stufftext,
// which stock clients ignore:
//
//   //temblor combat 0|1
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace temblor::net {

// Formats a line for svc_stufftext, with its line end.
std::string format_combat_state(bool is_hunted);
// Whether a line of stuffed text, without its line end, is meant as such a state.
bool is_combat_state(std::string_view line);
// Parses such a line. Fails if the state is neither 0 nor 1.
base::Result<bool> read_combat_state(std::string_view line);

}  // namespace temblor::net
