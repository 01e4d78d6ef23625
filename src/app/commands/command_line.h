// The options that commands share, as CLI11 reads them. Included where options are defined only: CLI11 takes
// seconds to compile.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <string_view>

#include "app/commands/options.h"
#include "base/result.h"

namespace temblor::app {

void add_common_options(CLI::App& program, CommonOptions& io_options);
// The initial values of `io_options` are the defaults.
void add_frame_options(CLI::App& command, FrameOptions& io_options);

// Adds an option that `parse` reads; its error becomes CLI11's. `value` may also be a std::optional<T>.
template <typename T, typename Value>
CLI::Option* add_parsed_option(CLI::App& command, const std::string& name, Value& value,
                               base::Result<T> (*parse)(std::string_view), const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [name, &value, parse](const std::string& text) {
        const base::Result<T> parsed = parse(text);
        if (!parsed.ok()) throw CLI::ValidationError(name, parsed.error().what);
        value = parsed.value();
      },
      help);
}

}  // namespace temblor::app
