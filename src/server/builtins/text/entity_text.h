// Prints an entity for people: every field that is not 0.
#pragma once

#include <string>

#include "server/game/edicts.h"
#include "vm/machine.h"

namespace temblor::server {

// Lines such as "entity 3:" and "  classname       \"door\"", each with a newline. A free entity has one line
// that says so.
std::string describe_entity(const Edicts& edicts, const vm::Machine& machine, vm::EntityIndex entity);

}  // namespace temblor::server
