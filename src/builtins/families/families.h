// The shared built-in functions, by topic. Each family is the table at the end of its source file.
#pragma once

#include <span>

#include "builtins/call.h"

namespace temblor::builtins {

std::span<const Entry> number_builtins();
std::span<const Entry> vector_builtins();
std::span<const Entry> text_builtins();
std::span<const Entry> comparison_builtins();  // of texts; search and replacement
std::span<const Entry> conversion_builtins();  // letters, colors, hexadecimal numbers, info strings
std::span<const Entry> token_builtins();
std::span<const Entry> buffer_builtins();  // lists of strings
std::span<const Entry> file_builtins();
std::span<const Entry> variable_builtins();
std::span<const Entry> function_builtins();  // functions and fields of the program, found by name

}  // namespace temblor::builtins
