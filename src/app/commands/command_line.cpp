#include "app/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace temblor::app {

void add_common_options(CLI::App& program, CommonOptions& io_options) {
  program
      .add_option("--basedir", io_options.folders.base_folder,
                  "Folder that holds the game folders (id1, mods); the current one where it holds id1")
      ->type_name("DIR");
  program
      .add_option("--game", io_options.folders.games,
                  "Game folder to add to id1; may be repeated, the last one wins")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  program
      .add_option("--set", io_options.assignments,
                  "Sets a console variable; may be repeated; `temblor settings` lists them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  program
      .add_option(
          "--show", io_options.show,
          "Draws that instead of the picture: faces, edges, spans, surfaces, mips, pvs, overdraw, depth")
      ->type_name("KIND");
}

void add_frame_options(CLI::App& command, FrameOptions& io_options) {
  add_parsed_option(command, "--size", io_options.size, parse_size, "Size of a frame in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", io_options.size.width, io_options.size.height));
  add_parsed_option(command, "--color", io_options.format, parse_color,
                    "Pixel format: palette indices as the original, or 32 bits with colored light")
      ->type_name("indexed|rgb")
      ->default_str(name_of(io_options.format));
  command
      .add_option("--fov", io_options.fov_deg,
                  "Horizontal field of view of a 4:3 picture in degrees; wider pictures see more")
      ->type_name("DEGREES")
      ->check(CLI::Range(10.0, 170.0))
      ->capture_default_str();
  command.add_option("--threads", io_options.threads, "Threads that draw; 0: one for each core")
      ->type_name("N")
      ->check(CLI::Range(0, 256));
}

}  // namespace temblor::app
