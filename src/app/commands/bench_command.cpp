#include "app/commands/bench_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/bench/bench_report.h"
#include "app/bench/comparison.h"
#include "app/bench/measure_views.h"
#include "app/bench/measurement.h"
#include "app/bench/measurement_output.h"
#include "app/bench/other_program.h"
#include "app/commands/command_line.h"
#include "app/files/diagnostics.h"
#include "app/files/interrupt.h"
#include "app/level/level_loading.h"
#include "base/function_ref.h"

namespace temblor::app {
namespace {

constexpr const char* kBenchHelpFooter =
    R"(In a level, the camera turns a full circle at every player start, teleport destination, and
intermission camera. Every view is drawn once before it is measured. A demo is drawn with one frame per
packet. After each frame, the benchmark measures the fill baseline: a plain loop that fills the frame from
one texture. The ratio of both times depends little on the machine.
--against compares with another program: both run in turns, and the ratio of their frame rates is printed. In
COMMAND, $1 and $2 are the width and height, and $3 is the level or demo. In JSON, all values outside "against"
are of the first round.
--views draws many small views of a level at once, as programs that learn to play do, and compares that with
drawing them one by one.
`temblor --help` describes --basedir, --game, --set, and --show.

Examples:
  temblor bench
  temblor --basedir ~/quake bench --map e1m1
  temblor --basedir ~/quake bench --map e1m1 --map e1m2 --size 1280x720 --color indexed --threads 1 --cold
  temblor --basedir ~/quake bench --demo demo1 --json > demo1.json
  temblor --basedir ~/quake bench --map start --report > table.md
  temblor --basedir ~/quake bench --map start --views 64 --threads 2
  temblor --basedir ~/quake bench --demo demo1 --size 640x480 --size 1920x1080 --against './timedemo.sh $1 $2')";

// Translates the options of the command to those of a measurement.
MeasureOptions make_measure_options(const BenchOptions& options, FrameSize size,
                                    const render::Settings& settings) {
  MeasureOptions measure_options;
  measure_options.size = size;
  measure_options.format = options.frame.format;
  measure_options.fov_deg = options.frame.fov_deg;
  measure_options.renderer = options.frame.renderer;
  measure_options.step_deg = options.step_deg;
  measure_options.runs = options.runs;
  measure_options.cold = options.cold;
  measure_options.relight = options.relight;
  measure_options.settings = settings;
  return measure_options;
}

// The resolution of a monitor, or of a picture that a program learns from.
std::vector<FrameSize> choose_sizes(const BenchOptions& options) {
  if (!options.sizes.empty()) return options.sizes;
  return {options.views > 0 ? FrameSize{160, 120} : FrameSize{1920, 1080}};
}

std::string require_text(const std::string& text) {
  return text.find_first_not_of(" \t\n") == std::string::npos ? "a command is missing" : "";
}

// Each pixel takes up to eight bytes, so this is 1 GiB.
base::Status check_views_fit(int views, FrameSize size) {
  constexpr std::int64_t kMaxPixels = std::int64_t{1} << 27;
  const std::int64_t pixels = std::int64_t{views} * size.width * size.height;
  if (pixels <= kMaxPixels) return base::Ok{};
  return base::error(base::ErrorCode::kUsage, "{} views of {} have {} pixels; the limit is {}", views,
                     format_size(size), pixels, kMaxPixels);
}

// Measures one level or demo.
using Measure = base::FunctionRef<base::Result<Measurement>(const MeasureOptions&)>;

// Measures levels and demos at all sizes and prints the results: JSON when everything has been measured, text
// at once, because measuring takes long.
class BenchRun {
 public:
  BenchRun(const BenchOptions& options, const render::Settings& settings)
      : options_(options), settings_(settings) {
    if (!options.against.empty()) interrupt_.emplace();
  }

  base::Status measure_all_sizes(const std::string& name, Measure measure) {
    std::vector<std::string> notes;
    for (const FrameSize& size : choose_sizes(options_)) {
      const MeasureOptions measure_options = make_measure_options(options_, size, settings_);
      if (interrupt_) {
        TRY_STATUS(compare(name, measure, measure_options, notes));
        continue;
      }
      TRY(const Measurement measurement, measure(measure_options));
      print_new_notes(measurement, notes);
      if (options_.json)
        results_.push_back(make_json(name, measurement));
      else
        print_at_once(describe_measurement(name, measurement));
    }
    return base::Ok{};
  }

  // Views at once, at all sizes.
  base::Status measure_views_at_all_sizes(const LoadedMap& map) {
    const std::string& name = map.level->name;
    for (const FrameSize& size : choose_sizes(options_)) {
      TRY_STATUS(check_views_fit(options_.views, size));
      const ViewsMeasurement measurement = measure_views(map, make_measure_options(options_, size, settings_),
                                                         static_cast<std::size_t>(options_.views));
      if (options_.json)
        results_.push_back(make_views_json(name, measurement));
      else
        print_at_once(describe_views(name, measurement));
    }
    return base::Ok{};
  }

  // A name or command need not be UTF-8.
  void print_json() const {
    const nlohmann::json& json = results_.size() == 1 ? results_[0] : results_;
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }

 private:
  // Output to a pipe must not wait for the end, because Ctrl-C would lose it.
  static void print_at_once(const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
  }

  // Repeated measurements find the same problems, which are printed once.
  static void print_new_notes(const Measurement& measurement, std::vector<std::string>& io_printed) {
    if (io_printed == measurement.notes) return;
    io_printed = measurement.notes;
    for (const std::string& note : io_printed) print_note(note);
  }

  // Alternates with the other program. JSON has the first of our measurements.
  base::Status compare(const std::string& name, Measure measure, const MeasureOptions& measure_options,
                       std::vector<std::string>& io_notes) {
    Comparison comparison{.command = options_.against, .fps = {}, .other_fps = {}};
    const OtherProgram other{options_.against, measure_options.size, name};
    nlohmann::json result;
    if (!options_.json) print_at_once(fmt::format("{}: {}\n", name, describe_conditions(measure_options)));
    for (int round = 0; round < options_.rounds; ++round) {
      TRY(const Measurement measurement, measure(measure_options));
      print_new_notes(measurement, io_notes);
      if (round == 0) result = make_json(name, measurement);
      TRY(const double other_fps, measure_other_program(other, *interrupt_));
      comparison.fps.push_back(measurement.fps);
      comparison.other_fps.push_back(other_fps);
      if (!options_.json) print_at_once(describe_last_round(comparison));
    }
    result["against"] = make_json(comparison);
    results_.push_back(std::move(result));
    if (!options_.json) print_at_once(describe_ratio(comparison));
    return base::Ok{};
  }

  const BenchOptions& options_;
  const render::Settings& settings_;
  // Only with another program, which must not survive Ctrl-C.
  std::optional<Interrupt> interrupt_;
  nlohmann::json results_ = nlohmann::json::array();
};

}  // namespace

Command* add_bench_command(Command& program, BenchOptions& io_options) {
  Command* command = program.add_subcommand("bench", "Measure how fast levels and demos are rendered");
  command
      ->add_option("--map", io_options.maps,
                   "Level of the game, or a .bsp file; repeatable (default: a small built-in level)")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  Option* demo =
      command->add_option("--demo", io_options.demos, "Demo of the game, or a .dem file; repeatable")
          ->type_name("NAME")
          ->allow_extra_args(false)
          ->take_all();
  add_parsed_list_option(*command, "--size", io_options.sizes, parse_size,
                         "Size in pixels; repeatable (default with --views: 160x120)")
      ->type_name("WxH")
      ->default_str("1920x1080");
  add_frame_options_without_size(*command, io_options.frame);
  add_renderer_option(*command, io_options.frame);
  command->add_option("--step", io_options.step_deg, "Angle between two views")
      ->type_name("DEGREES")
      ->check(in_range(0.1, 360.0))
      ->capture_default_str();
  command->add_option("--runs", io_options.runs, "Draw each demo N times and keep each frame's fastest time")
      ->type_name("N")
      ->check(in_range(1, 100))
      ->capture_default_str();
  Option* cold =
      command->add_flag("--cold", io_options.cold, "Also measure views with an empty surface cache");
  Option* relight =
      command->add_flag("--relight", io_options.relight, "Also measure views with changing light");
  Option* json = command->add_flag("--json", io_options.json,
                                   "Print JSON: one object, or a list for several levels, demos, and sizes");
  Option* report =
      command
          ->add_flag("--report", io_options.report,
                     "Print the tables of docs/performance.md in Markdown; takes minutes and chooses sizes, "
                     "threads, and formats itself")
          ->excludes(json);
  Option* against =
      command
          ->add_option("--against", io_options.against,
                       "Compare with another program: a shell command whose last number is frames per second")
          ->type_name("COMMAND")
          ->check(require_text)
          ->excludes(report);
  command->add_option("--rounds", io_options.rounds, "Alternating runs of both programs")
      ->type_name("N")
      ->check(in_range(1, 100))
      ->capture_default_str()
      ->needs(against);
  command->add_option("--views", io_options.views, "Draw N views of a level at once instead of one at a time")
      ->type_name("N")
      ->check(in_range(1, kMaxViews))
      ->excludes(demo)
      ->excludes(report)
      ->excludes(against)
      ->excludes(cold)
      ->excludes(relight);
  command->footer(kBenchHelpFooter);
  return command;
}

base::Status run_bench(const BenchOptions& options, const GameFolders& folders,
                       const client::PresentationSettings& presentation, const render::Settings& settings) {
  if (options.frame.renderer == RendererKind::kGl && (options.cold || options.report || options.views > 0))
    return base::error(base::ErrorCode::kUsage,
                       "--renderer gl: --cold, --report, and --views measure the CPU's renderer only");
  // An empty name is the built-in level.
  std::vector<std::string> maps = options.maps;
  if (maps.empty() && options.demos.empty()) maps.emplace_back();
  if (options.report) print_report_header();
  BenchRun run(options, settings);
  for (const std::string& map : maps) {
    TRY(const LoadedMap loaded, load_map(folders, map));
    for (const std::string& note : loaded.notes) print_note(note);
    const std::string& name = loaded.level->name;
    if (options.report) {
      print_report(name, loaded, settings, options.step_deg);
      continue;
    }
    if (options.views > 0) {
      TRY_STATUS(run.measure_views_at_all_sizes(loaded));
      continue;
    }
    TRY_STATUS(run.measure_all_sizes(
        name, [&](const MeasureOptions& measure_options) { return measure(loaded, measure_options); }));
  }
  for (const std::string& demo : options.demos) {
    TRY(const LoadedDemo loaded, load_demo(folders, demo));
    if (options.report) {
      TRY_STATUS(print_demo_report(demo, loaded, presentation, settings));
      continue;
    }
    TRY_STATUS(run.measure_all_sizes(demo, [&](const MeasureOptions& measure_options) {
      return measure_demo(loaded, presentation, measure_options);
    }));
  }
  if (options.json) run.print_json();
  return base::Ok{};
}

}  // namespace temblor::app
