// All built-in functions, by what they are about; builtins.cpp joins them.
#pragma once

#include <span>

#include "server/builtins/call.h"

namespace temblor::server {

std::span<const BuiltinEntry> vector_builtins();
std::span<const BuiltinEntry> number_builtins();
std::span<const BuiltinEntry> entity_builtins();
std::span<const BuiltinEntry> finding_builtins();
std::span<const BuiltinEntry> tracing_builtins();
std::span<const BuiltinEntry> aiming_builtins();
std::span<const BuiltinEntry> movement_builtins();
std::span<const BuiltinEntry> precache_builtins();
std::span<const BuiltinEntry>
effect_builtins();  // sounds, particles, light styles: what clients see and hear
std::span<const BuiltinEntry> printing_builtins();
std::span<const BuiltinEntry> writing_builtins();  // messages, number by number
std::span<const BuiltinEntry> text_builtins();
std::span<const BuiltinEntry> file_builtins();
std::span<const BuiltinEntry> variable_builtins();
std::span<const BuiltinEntry> level_builtins();
std::span<const BuiltinEntry> debugging_builtins();
std::span<const BuiltinEntry> rerelease_builtins();  // by name only
std::span<const BuiltinEntry> bot_builtins();        // clients that the program plays

}  // namespace temblor::server
