#include "app/commands/inspect_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "app/inspect/inspection.h"

namespace temblor::app {
namespace {

constexpr const char* kInspectHelpFooter =
    R"(Known formats: levels (.bsp of versions 29, 30, 2PSB, and BSP2), maps (.map), colored light (.lit),
directions of light (.lux), visibility patches (.vis), entity text (.ent), archives (.pak, .pk3, .wad),
pictures, palettes, and colormaps (.lmp), models (.mdl, .md3, .md5mesh, .md5anim), sprites (.spr),
demos (.dem), sounds (.wav), and compiled QuakeC (.dat).
"problems" lists faults that the game tolerates. An unusable file is an error, with exit status 1.

Examples:
  temblor inspect ~/quake/id1/pak0.pak
  temblor inspect ~/quake/id1/maps/start.bsp --json
  temblor inspect mymod/progs.dat
  temblor inspect mygame/progs/knight.mdl --picture knight.png --frames 0,walk1,walk5 --views front,side)";

// Names in files may have any encoding; JSON needs UTF-8, so invalid bytes are replaced.
std::string dump(const Inspection& json) {
  return json.dump(2, ' ', false, Inspection::error_handler_t::replace);
}

}  // namespace

Command* add_inspect_command(Command& program, InspectOptions& io_options) {
  Command* command = program.add_subcommand("inspect", "Show the contents and problems of a file");
  command->add_option("file", io_options.file, "File of a known format (see below)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", io_options.json, "Print JSON");
  Option* const picture = command
                              ->add_option("--picture", io_options.sheet.out,
                                           "Draw a model: its frames side by side, one row per view")
                              ->type_name("OUT.png");
  // The remaining options only choose what --picture draws.
  command
      ->add_option("--frames", io_options.sheet.frames,
                   "Frames by number or name (default: eight, evenly spaced)")
      ->type_name("A,B,...")
      ->needs(picture);
  command
      ->add_option("--views", io_options.sheet.views,
                   "Views: front, side, back, above, quarter, or hand (as the view weapon)")
      ->type_name("A,B,...")
      ->capture_default_str()
      ->needs(picture);
  command->add_option("--cell", io_options.sheet.cell_px, "Width and height of each picture")
      ->type_name("PIXELS")
      ->check(in_range(16, 1024))
      ->capture_default_str()
      ->needs(picture);
  command->add_option("--skin", io_options.sheet.skin, "Skin number")
      ->type_name("N")
      ->check(in_range(0, 1000))
      ->needs(picture);
  command->add_option("--light", io_options.sheet.light, "Light level")
      ->type_name("0-255")
      ->check(in_range(0, 255))
      ->capture_default_str()
      ->needs(picture);
  command->footer(kInspectHelpFooter);
  return command;
}

base::Status run_inspect(const InspectOptions& options) {
  const base::Result<Inspection> result = inspect_file(options.file);
  // A script that asked for JSON gets an object, too; the error itself goes to standard error as always.
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
