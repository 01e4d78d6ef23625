// An entity in words, for people: every field that is not 0.
#pragma once

#include <string>

#include "server/game/edicts.h"
#include "vm/machine.h"

namespace temblor::server {

// Lines, each with a newline: "entity 3:" and "  classname       \"door\"", or one that says that it was
// removed.
std::string describe_entity(const Edicts& edicts, const vm::Machine& machine, vm::EntityIndex entity);

}  // namespace temblor::server
