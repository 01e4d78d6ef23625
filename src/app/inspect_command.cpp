#include "app/inspect_command.h"

#include <fmt/format.h>

#include <CLI/App.hpp>

#include "app/inspection.h"

namespace temblor::app {
namespace {

constexpr const char* kHelpFooter =
    R"(Known formats: levels (.bsp versions 29, 2PSB, BSP2), maps (.map), coloured light (.lit), entity text (.ent),
archives (.pak, .pk3, .wad), pictures, palettes and colormaps (.lmp), models (.mdl), sprites (.spr),
recordings (.dem), compiled QuakeC (.dat).
"problems" are what the game can live with; a file that it cannot use at all gives one line on standard
error and exit status 1.

Examples:
  temblor inspect quake/id1/pak0.pak
  temblor inspect quake/id1/maps/start.bsp --json
  temblor inspect mymod/progs.dat)";

// Names in files may be in any encoding; what is not UTF-8 is replaced.
std::string dump(const Inspection& json) {
  return json.dump(2, ' ', false, Inspection::error_handler_t::replace);
}

}  // namespace

CLI::App* add_inspect_command(CLI::App& program, InspectOptions& io_options) {
  CLI::App* command = program.add_subcommand("inspect", "Says what a file holds, and what is wrong with it");
  command->add_option("file", io_options.file, "File of any known format")->type_name("FILE")->required();
  command->add_flag("--json", io_options.json, "Prints one JSON object");
  command->footer(kHelpFooter);
  return command;
}

base::Status run_inspect(const InspectOptions& options) {
  const base::Result<Inspection> result = inspect_file(options.file);
  if (!result.ok()) {
    if (options.json)
      fmt::print("{}\n", dump(Inspection{{"file", options.file}, {"error", result.error().what}}));
    return result.error();
  }
  fmt::print("{}", options.json ? dump(*result) + "\n" : describe_inspection(*result));
  return base::Ok{};
}

}  // namespace temblor::app
