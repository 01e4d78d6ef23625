// Names of keys as in stock configuration files: `bind UPARROW "+forward"`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "platform/key.h"

namespace temblor::client {

// "w", "UPARROW", "MOUSE1", "SEMICOLON"; "KEY65" for one without a name.
std::string key_name(platform::Key key);
// Case does not matter. Nothing for a name that no key has.
std::optional<platform::Key> find_key(std::string_view name);

}  // namespace temblor::client
