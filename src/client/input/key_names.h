// Key names as in stock configuration files: `bind UPARROW "+forward"`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "platform/key.h"

namespace temblor::client {

// Returns the name of a key: "w", "UPARROW", "MOUSE1", "SEMICOLON"; "KEY65" for a key without a name.
std::string key_name(platform::Key key);
// Finds a key by name, ignoring case. Returns nothing for an unknown name.
std::optional<platform::Key> find_key(std::string_view name);

}  // namespace temblor::client
