#include "app/commands/bench_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/bench/bench_report.h"
#include "app/bench/measurement.h"
#include "app/bench/measurement_output.h"
#include "app/commands/command_line.h"
#include "app/files/diagnostics.h"
#include "app/files/level_loading.h"

namespace temblor::app {
namespace {

constexpr const char* kBenchHelpFooter =
    R"(In a level: stands at every player start, teleport destination and intermission camera and turns a full
circle. Everything is drawn once before it is timed. In a recording: a frame for each of its packets, once, with all
that belongs to it. Beside each frame runs the floor: a plain loop that fills the frame from one texture; a frame's
time in floors says little about the machine.
--basedir, --game, --set and --show: see temblor --help.

Examples:
  temblor --basedir quake bench --map e1m1
  temblor --basedir quake bench --map e1m1 --map e1m2 --size 1280x720 --color indexed --threads 1 --cold
  temblor --basedir quake bench --demo demo1 --json > demo1.json
  temblor --basedir quake bench --report --map start > table.md
  temblor bench)";

MeasureOptions measure_options(const BenchOptions& options, const render::Settings& settings) {
  MeasureOptions measure_options;
  measure_options.size = options.frame.size;
  measure_options.format = options.frame.format;
  measure_options.fov_deg = options.frame.fov_deg;
  measure_options.step_deg = options.step_deg;
  measure_options.runs = options.runs;
  measure_options.cold = options.cold;
  measure_options.relight = options.relight;
  measure_options.settings = settings;
  return measure_options;
}

}  // namespace

Command* add_bench_command(Command& program, BenchOptions& io_options) {
  Command* command = program.add_subcommand("bench", "Measures how fast levels are drawn");
  command->add_option("--map", io_options.maps, "Level to draw; may be repeated; else one made in code")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--demo", io_options.demos, "Recording to draw: its name, or a .dem file; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  add_frame_options(*command, io_options.frame);
  command->add_option("--step", io_options.step_deg, "Turn between two views of a circle")
      ->type_name("DEGREES")
      ->check(in_range(0.1, 360.0))
      ->capture_default_str();
  command
      ->add_option(
          "--runs", io_options.runs,
          "Draws a recording so often and takes each frame's quickest: what it costs where other work "
          "disturbs the machine")
      ->type_name("N")
      ->check(in_range(1, 100))
      ->capture_default_str();
  command->add_flag("--cold", io_options.cold, "Also times views whose surfaces are still to be built");
  command->add_flag("--relight", io_options.relight, "Also times views whose light changes");
  Option* json = command->add_flag("--json", io_options.json,
                                   "Prints one JSON object, or a list of them for several levels");
  command
      ->add_flag("--report", io_options.report,
                 "Prints the table of docs/performance.md instead (takes minutes; sizes, threads and formats "
                 "are its own)")
      ->excludes(json);
  command->footer(kBenchHelpFooter);
  return command;
}

base::Status run_bench(const BenchOptions& options, const GameFolders& folders,
                       const client::PresentationSettings& presentation, const render::Settings& settings) {
  std::vector<std::string> maps = options.maps;
  if (maps.empty() && options.demos.empty()) maps.emplace_back();
  if (options.report) print_report_header();
  nlohmann::json results = nlohmann::json::array();
  const auto show = [&](const std::string& name, const Measurement& measurement) {
    if (options.json)
      results.push_back(json_of(name, measurement));
    else
      fmt::print("{}", describe_measurement(name, measurement));
  };
  for (const std::string& map : maps) {
    TRY(const LoadedMap loaded, load_map(folders, map));
    for (const std::string& note : loaded.notes) print_note(note);
    const std::string& name = loaded.level->name;
    if (options.report)
      print_report(name, loaded, settings, options.step_deg);
    else
      show(name, measure(loaded, measure_options(options, settings)));
  }
  for (const std::string& demo : options.demos) {
    TRY(const LoadedDemo loaded, load_demo(folders, demo));
    if (options.report) {
      TRY_STATUS(print_demo_report(demo, loaded, presentation, settings));
      continue;
    }
    TRY(const Measurement measurement,
        measure_demo(loaded, presentation, measure_options(options, settings)));
    show(demo, measurement);
  }
  if (options.json) fmt::print("{}\n", (results.size() == 1 ? results[0] : results).dump(2));
  return base::Ok{};
}

}  // namespace temblor::app
