#include "app/lab/card/card_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "app/files/diagnostics.h"

namespace temblor::app {

Command* add_card_command(Command& lab, CardOptions& io_options) {
  Command* command = lab.add_subcommand(
      kCardName, "Measure ways to draw levels with a graphics card, and its caches of surfaces");
  const Option* map = command
                          ->add_option("--map", io_options.map,
                                       "Level of the game, or a .bsp file (default: a small built-in level)")
                          ->type_name("NAME");
  command->add_option("--demo", io_options.demo, "Demo of the game, or a .dem file")
      ->type_name("NAME")
      ->excludes(map);
  add_parsed_list_option(*command, "--size", io_options.grid.sizes, parse_size, "Size in pixels; repeatable")
      ->type_name("WxH")
      ->default_str("320x200, 640x480, 1920x1080");
  command->add_option("--step", io_options.grid.step_deg, "Angle between two views of a level")
      ->type_name("DEGREES")
      ->check(in_range(0.1, 360.0))
      ->capture_default_str();
  command
      ->add_option("--seconds", io_options.grid.seconds,
                   "Time of the first cache of each size; the others draw the same frames")
      ->type_name("S")
      ->check(in_range(0.01, 1000.0))
      ->capture_default_str();
  command
      ->add_option("--lights", io_options.grid.lights,
                   "Lights that move around the eye, to see what they cost")
      ->type_name("COUNT")
      ->check(in_range(0, 100))
      ->capture_default_str();
  command->add_flag("--json", io_options.json, "Print JSON");
  return command;
}

base::Status run_card(const CardOptions& options, const GameFolders& folders,
                      const client::PresentationSettings& presentation, const render::Settings& settings) {
  TRY(const LabScenes scenes, options.demo.empty()
                                  ? LabScenes::load_level(folders, options.map, {})
                                  : LabScenes::load_demo(folders, options.demo, presentation));
  for (const std::string& note : scenes.notes()) print_note(note);
  TRY(const CardResults results, measure_card(scenes, options.grid, settings));
  if (options.json)
    fmt::print("{}\n", make_card_json(results).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    fmt::print("{}", describe_card(results));
  return base::Ok{};
}

}  // namespace temblor::app
