// All built-in functions, by topic; builtins.cpp joins them. Each family is the table at the end of its
// source file.
#pragma once

#include <span>

#include "server/builtins/call.h"

namespace temblor::server {

std::span<const BuiltinEntry> vector_builtins();
std::span<const BuiltinEntry> entity_builtins();
std::span<const BuiltinEntry> entity_data_builtins();  // fields as text
std::span<const BuiltinEntry> finding_builtins();
std::span<const BuiltinEntry> tracing_builtins();
std::span<const BuiltinEntry> aiming_builtins();
std::span<const BuiltinEntry> movement_builtins();
std::span<const BuiltinEntry> precache_builtins();
std::span<const BuiltinEntry> effect_builtins();  // sounds, particles, light styles
std::span<const BuiltinEntry> temporary_effect_builtins();
std::span<const BuiltinEntry> printing_builtins();
std::span<const BuiltinEntry> writing_builtins();  // messages, value by value
std::span<const BuiltinEntry> command_builtins();
std::span<const BuiltinEntry> level_builtins();
std::span<const BuiltinEntry> debugging_builtins();
std::span<const BuiltinEntry> rerelease_builtins();      // called by name only
std::span<const BuiltinEntry> debug_drawing_builtins();  // called by name only
std::span<const BuiltinEntry> bot_builtins();            // clients that QuakeC plays
std::span<const BuiltinEntry> stat_builtins();           // values for HUD programs

}  // namespace temblor::server
