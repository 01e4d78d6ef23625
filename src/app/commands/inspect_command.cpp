#include "app/commands/inspect_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "app/inspect/inspection.h"

namespace temblor::app {
namespace {

constexpr const char* kInspectHelpFooter =
    R"(Known formats: levels (.bsp versions 29, 2PSB, BSP2), maps (.map), colored light (.lit), entity text (.ent),
archives (.pak, .pk3, .wad), pictures, palettes and colormaps (.lmp), models (.mdl), sprites (.spr),
recordings (.dem), compiled QuakeC (.dat).
"problems" are what the game can live with; a file that it cannot use at all gives one line on standard
error and exit status 1.

Examples:
  temblor inspect quake/id1/pak0.pak
  temblor inspect quake/id1/maps/start.bsp --json
  temblor inspect mymod/progs.dat
  temblor inspect mygame/progs/knight.mdl --picture knight.png --frames 0,walk1,walk5 --views front,side)";

// Names in files may be in any encoding; what is not UTF-8 is replaced.
std::string dump(const Inspection& json) {
  return json.dump(2, ' ', false, Inspection::error_handler_t::replace);
}

}  // namespace

Command* add_inspect_command(Command& program, InspectOptions& io_options) {
  Command* command = program.add_subcommand("inspect", "Says what a file holds, and what is wrong with it");
  command->add_option("file", io_options.file, "File of any known format")->type_name("FILE")->required();
  command->add_flag("--json", io_options.json, "Prints one JSON object");
  Option* const picture = command
                              ->add_option("--picture", io_options.sheet.out,
                                           "Draws a model: its frames side by side, a row a view")
                              ->type_name("OUT.png");
  command
      ->add_option("--frames", io_options.sheet.frames, "Which frames, by number or name; else eight of them")
      ->type_name("A,B,...")
      ->needs(picture);
  command->add_option("--views", io_options.sheet.views, "Of front, side, back, above, quarter, hand")
      ->type_name("A,B,...")
      ->capture_default_str()
      ->needs(picture);
  command->add_option("--cell", io_options.sheet.cell_px, "Width and height of each picture")
      ->type_name("PIXELS")
      ->check(in_range(16, 1024))
      ->capture_default_str()
      ->needs(picture);
  command->add_option("--skin", io_options.sheet.skin, "Number of the skin")
      ->type_name("N")
      ->check(in_range(0, 1000))
      ->needs(picture);
  command->add_option("--light", io_options.sheet.light, "Light where it stands, as in a level")
      ->type_name("0-255")
      ->check(in_range(0, 255))
      ->capture_default_str()
      ->needs(picture);
  command->footer(kInspectHelpFooter);
  return command;
}

base::Status run_inspect(const InspectOptions& options) {
  const base::Result<Inspection> result = inspect_file(options.file);
  if (!result.ok()) {
    if (options.json)
      fmt::print("{}\n", dump(Inspection{{"file", options.file}, {"error", result.error().what}}));
    return result.error();
  }
  if (!options.sheet.out.empty()) TRY_STATUS(draw_model_sheet(options.file, options.sheet));
  fmt::print("{}", options.json ? dump(*result) + "\n" : describe_inspection(*result));
  return base::Ok{};
}

}  // namespace temblor::app
