#include "app/commands/bench_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/bench/bench_report.h"
#include "app/bench/measurement.h"
#include "app/bench/measurement_output.h"
#include "app/commands/command_line.h"
#include "app/files/diagnostics.h"
#include "app/level/level_loading.h"

namespace temblor::app {
namespace {

constexpr const char* kBenchHelpFooter =
    R"(In a level, the camera turns a full circle at every player start, teleport destination, and
intermission camera. Every view is drawn once before it is measured. A demo is drawn with one frame per
packet. After each frame, the benchmark measures the fill baseline: a plain loop that fills the frame from
one texture. The ratio of both times depends little on the machine.
`temblor --help` describes --basedir, --game, --set, and --show.

Examples:
  temblor bench
  temblor --basedir ~/quake bench --map e1m1
  temblor --basedir ~/quake bench --map e1m1 --map e1m2 --size 1280x720 --color indexed --threads 1 --cold
  temblor --basedir ~/quake bench --demo demo1 --json > demo1.json
  temblor --basedir ~/quake bench --map start --report > table.md)";

// Translates the options of the command to those of a measurement.
MeasureOptions make_measure_options(const BenchOptions& options, const render::Settings& settings) {
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
  Command* command = program.add_subcommand("bench", "Measure how fast levels and demos are rendered");
  command
      ->add_option("--map", io_options.maps,
                   "Level of the game, or a .bsp file; repeatable (default: a small built-in level)")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  command->add_option("--demo", io_options.demos, "Demo of the game, or a .dem file; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  add_frame_options(*command, io_options.frame);
  command->add_option("--step", io_options.step_deg, "Angle between two views")
      ->type_name("DEGREES")
      ->check(in_range(0.1, 360.0))
      ->capture_default_str();
  command->add_option("--runs", io_options.runs, "Draw each demo N times and keep each frame's fastest time")
      ->type_name("N")
      ->check(in_range(1, 100))
      ->capture_default_str();
  command->add_flag("--cold", io_options.cold, "Also measure views with an empty surface cache");
  command->add_flag("--relight", io_options.relight, "Also measure views with changing light");
  Option* json = command->add_flag("--json", io_options.json,
                                   "Print JSON: one object, or a list for several levels and demos");
  command
      ->add_flag("--report", io_options.report,
                 "Print the tables of docs/performance.md in Markdown; takes minutes and chooses sizes, "
                 "threads, and "
                 "formats itself")
      ->excludes(json);
  command->footer(kBenchHelpFooter);
  return command;
}

base::Status run_bench(const BenchOptions& options, const GameFolders& folders,
                       const client::PresentationSettings& presentation, const render::Settings& settings) {
  // An empty name is the built-in level.
  std::vector<std::string> maps = options.maps;
  if (maps.empty() && options.demos.empty()) maps.emplace_back();
  if (options.report) print_report_header();
  // JSON is printed when everything has been measured, text and tables at once, because measuring takes long.
  nlohmann::json results = nlohmann::json::array();
  const auto show = [&](const std::string& name, const Measurement& measurement) {
    if (options.json)
      results.push_back(make_json(name, measurement));
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
      show(name, measure(loaded, make_measure_options(options, settings)));
  }
  for (const std::string& demo : options.demos) {
    TRY(const LoadedDemo loaded, load_demo(folders, demo));
    if (options.report) {
      TRY_STATUS(print_demo_report(demo, loaded, presentation, settings));
      continue;
    }
    TRY(const Measurement measurement,
        measure_demo(loaded, presentation, make_measure_options(options, settings)));
    show(demo, measurement);
  }
  if (options.json) fmt::print("{}\n", (results.size() == 1 ? results[0] : results).dump(2));
  return base::Ok{};
}

}  // namespace temblor::app
