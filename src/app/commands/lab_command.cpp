#include "app/commands/lab_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "app/commands/command_line.h"
#include "app/files/diagnostics.h"
#include "app/files/picture_file.h"
#include "app/lab/book/school_pages.h"
#include "app/lab/book/write_book.h"
#include "app/lab/card/card_methods.h"
#include "app/lab/lab_picture.h"
#include "app/lab/lab_scenes.h"
#include "app/lab/technique_figures.h"
#include "lab/registry.h"

namespace temblor::app {
namespace {

constexpr const char* kLabHelpFooter =
    R"(A technique replaces a stage of the engine and draws the same scene. Its times are measured like those of
`temblor bench`. Its pixels are compared with an oracle, which follows a ray through each pixel.
TECHNIQUE is a name, or a name with parameters: abutting-edges:epsilon=0.001,mesh=0

Examples:
  temblor lab list
  temblor lab run painter -o painter.png
  temblor lab run space --solids 1000 --shape concave
  temblor --basedir ~/quake lab run independent-edges --map e1m1 --color indexed -o edges.png
  temblor --basedir ~/quake lab run model-sprites --models 100 --distance 300 --model ogre
  temblor --basedir ~/quake lab compare painter painter:pvs=0 z-buffer --demo demo1 --json > lab.json
  temblor --basedir ~/quake lab replay ~/quake/id1/lockstep0000.replay
  temblor lab wire --loss 2 --latency 200
  temblor --basedir ~/quake lab card --demo demo1 --size 640x480
  temblor --basedir ~/quake lab book --map start --map e1m1 -o book)";

void add_scene_options(Command& command, LabOptions& io_options) {
  const Option* map = command
                          .add_option("--map", io_options.map,
                                      "Level of the game, or a .bsp file (default: a small built-in level)")
                          ->type_name("NAME");
  Option* demo = command.add_option("--demo", io_options.demo, "Demo of the game, or a .dem file")
                     ->type_name("NAME")
                     ->excludes(map);
  add_parsed_option(command, "--pos", io_options.position_world, parse_vec3,
                    "Position of the camera in the picture and the oracle's views (default: several)")
      ->type_name("X,Y,Z")
      ->excludes(demo);
  add_parsed_option(command, "--angles", io_options.angles_deg, parse_vec3,
                    "Its direction in degrees; positive pitch looks down")
      ->type_name("PITCH,YAW,ROLL")
      ->excludes(demo);
  Option* models = command
                       .add_option("--models", io_options.models.count,
                                   "Show N copies of a model in rows before the camera, without the world")
                       ->type_name("N")
                       ->check(in_range(1, CrowdOptions::kMaxModels))
                       ->excludes(demo);
  command.add_option("--distance", io_options.models.distance, "Units from the eye to the nearest models")
      ->type_name("D")
      ->check(in_range(CrowdOptions::kMinDistance, CrowdOptions::kMaxDistance))
      ->capture_default_str()
      ->needs(models);
  command
      .add_option("--model", io_options.models.model,
                  "Model of the game, such as ogre (default: the first monster or item that it has)")
      ->type_name("NAME")
      ->needs(models);
  add_frame_options(command, io_options.frame);
  command.add_option("--step", io_options.step_deg, "Angle between two measured views of a level")
      ->type_name("DEGREES")
      ->check(in_range(1.0, 360.0))
      ->capture_default_str();
  command
      .add_option("--rounds", io_options.rounds,
                  "Measure each technique N times, in turns, and keep the fastest")
      ->type_name("N")
      ->check(in_range(1, 100))
      ->capture_default_str();
  command.add_flag("--json", io_options.json, "Print JSON");
}

nlohmann::json make_json(const lab::Technique& technique) {
  nlohmann::json parameters = nlohmann::json::array();
  for (const lab::Parameter& parameter : technique.parameters)
    parameters.push_back({{"name", parameter.name},
                          {"default", parameter.value},
                          {"min", parameter.min},
                          {"max", parameter.max},
                          {"meaning", parameter.meaning}});
  return {{"name", technique.name},
          {"title", technique.title},
          {"summary", technique.summary},
          {"article", technique.article},
          {"heading", technique.heading},
          {"replaces", technique.replaces},
          {"expected", technique.expected},
          {"max_wrong_share", technique.max_wrong_share},
          {"parameters", std::move(parameters)}};
}

// With the fields of a technique.
nlohmann::json make_space_entry() {
  return {{"name", kSpaceName},
          {"title", kSpaceTitle},
          {"summary", kSpaceSummary},
          {"article", "Sorted Spans in Action"},
          {"heading", "1/z span sorting in action"},
          {"replaces", "the whole frame"},
          {"expected", kSpaceExpected},
          {"max_wrong_share", 0},
          {"parameters", nlohmann::json::array()}};
}

void print_list(bool json) {
  if (json) {
    nlohmann::json list = nlohmann::json::array();
    for (const lab::Technique& technique : lab::list_techniques()) list.push_back(make_json(technique));
    list.push_back(make_space_entry());
    fmt::print("{}\n", list.dump(2));
    return;
  }
  for (const lab::Technique& technique : lab::list_techniques()) {
    fmt::print("{}: {}\n  {}\n  From \"{}\", {}. Replaces: {}.\n  Expected: {}\n", technique.name,
               technique.title, technique.summary, technique.article, technique.heading, technique.replaces,
               technique.expected);
    for (const lab::Parameter& parameter : technique.parameters)
      fmt::print("  {}={}, {} to {}. {}\n", parameter.name, parameter.value, parameter.min, parameter.max,
                 parameter.meaning);
  }
  fmt::print("{}{}{}", describe_space(), describe_wire_methods(), describe_card_methods());
}

// The first option that is for levels only, or nothing.
std::string find_level_option(const LabOptions& options) {
  const LabOptions defaults;
  return !options.map.empty()                            ? "--map"
         : !options.demo.empty()                         ? "--demo"
         : options.position_world                        ? "--pos"
         : options.angles_deg                            ? "--angles"
         : options.step_deg != defaults.step_deg         ? "--step"
         : options.rounds != defaults.rounds             ? "--rounds"
         : options.frame.threads                         ? "--threads"
         : options.frame.format != defaults.frame.format ? "--color"
                                                         : "";
}

base::Status check_space_options(const LabOptions& options) {
  const std::string option = find_level_option(options);
  if (option.empty()) return base::Ok{};
  return base::error(base::ErrorCode::kUnsupported, "{} is for levels, and {} has none", option, kSpaceName);
}

base::Status check_technique_options(const LabOptions& options) {
  const auto gives_parameters = [](const std::string& text) {
    return text.starts_with(std::string(kSpaceName) + ":");
  };
  if (gives_parameters(options.technique) || std::ranges::any_of(options.techniques, gives_parameters))
    return base::error(base::ErrorCode::kUnsupported,
                       "{} has options instead of parameters, such as --solids", kSpaceName);
  if (std::ranges::count(options.techniques, kSpaceName) > 0)
    return base::error(base::ErrorCode::kUnsupported,
                       "{0} is a scene of its own and draws no level; use `temblor lab run {0}`", kSpaceName);
  if (options.technique == kWireName || std::ranges::count(options.techniques, kWireName) > 0)
    return base::error(base::ErrorCode::kUnsupported, "{0} draws nothing; use `temblor lab {0}`", kWireName);
  const std::string option = options.space.find_given();
  if (option.empty()) return base::Ok{};
  return base::error(base::ErrorCode::kUnsupported, "{} is an option of `temblor lab run {}`", option,
                     kSpaceName);
}

base::Result<LabScenes> load_scenes(const LabOptions& options, const GameFolders& folders,
                                    client::PresentationSettings presentation) {
  presentation.view.fov_deg = options.frame.fov_deg;
  if (!options.demo.empty()) return LabScenes::load_demo(folders, options.demo, presentation);
  return LabScenes::load_level(folders, options.map,
                               {options.position_world, options.angles_deg, options.frame.fov_deg},
                               options.models);
}

base::Status write_picture(const LabOptions& options, const lab::Choice& choice, const LabScenes& scenes,
                           const render::Settings& settings) {
  const FrameSize size = options.frame.size;
  const assets::Look& look = scenes.look();
  render::FrameBuffer technique(size.width, size.height, options.frame.format);
  render::FrameBuffer engine(size.width, size.height, options.frame.format);
  const render::Settings adapted = scenes.adapt(settings);
  render::Renderer of_engine(look.palette, look.colormap), of_technique(look.palette, look.colormap);
  of_technique.replace_stages(choice.make_stages());
  TRY_STATUS(scenes.show_picture_scene([&](const render::Scene& scene) {
    of_engine.render(scene, adapted, engine);
    of_technique.render(scene, adapted, technique);
  }));
  return write_lab_picture(options.out, technique, engine, look.palette);
}

base::Status compare(std::span<const lab::Choice> choices, const LabOptions& options, const LabScenes& scenes,
                     const render::Settings& settings) {
  FigureOptions figure_options;
  figure_options.measure.size = options.frame.size;
  figure_options.measure.format = options.frame.format;
  figure_options.measure.fov_deg = options.frame.fov_deg;
  figure_options.measure.step_deg = options.step_deg;
  figure_options.measure.settings = settings;
  figure_options.rounds = options.rounds;
  TRY(const std::vector<TechniqueFigures> figures, find_figures(scenes, choices, figure_options));
  if (options.json)
    fmt::print(
        "{}\n",
        app::make_json(scenes.name(), figures).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    fmt::print("{}", describe_figures(scenes.name(), figures));
  return base::Ok{};
}

// A level without game code, or a file, cannot be played.
base::Result<WireResults> measure_wire_for_book(const std::string& map, const GameFolders& folders) {
  const base::Result<WireResults> measured = measure_wire({.map = map}, folders);
  if (measured.ok()) return measured;
  print_note(fmt::format("the wire sends the built-in world: {}", measured.error().message()));
  return measure_wire(WireOptions{}, folders);
}

base::Status make_book(const LabOptions& options, const GameFolders& folders,
                       const render::Settings& settings) {
  BookOptions book;
  book.size = options.frame.size;
  book.format = options.frame.format;
  book.settings = settings;
  if (!options.frame.threads) book.settings.threads = 1;  // so that machines can be compared
  std::vector<LabScenes> levels;
  std::vector<std::string> maps = options.maps;
  if (maps.empty()) maps.emplace_back();
  for (const std::string& map : maps) {
    TRY(LabScenes level,
        LabScenes::load_level(folders, map,
                              {.position_world = {}, .angles_deg = {}, .fov_deg = options.frame.fov_deg}));
    levels.push_back(std::move(level));
  }
  std::vector<LabScenes> model_scenes;
  for (const CrowdOptions& crowd : list_book_crowds()) {
    TRY(LabScenes scenes,
        LabScenes::load_level(folders, maps.front(),
                              {.position_world = {}, .angles_deg = {}, .fov_deg = options.frame.fov_deg},
                              crowd));
    model_scenes.push_back(std::move(scenes));
  }
  TRY_STATUS(make_page_folder(options.out));  // before minutes of measurements
  TRY(const WireResults wire, measure_wire_for_book(maps.front(), folders));
  return write_book(options.out, levels, model_scenes, wire, book);
}

}  // namespace

LabCommands add_lab_command(Command& program, LabOptions& io_options) {
  LabCommands commands;
  commands.lab = program.add_subcommand("lab", "Compare techniques of Michael Abrash's articles");
  commands.lab->require_subcommand();
  commands.lab->footer(kLabHelpFooter);
  commands.list = commands.lab->add_subcommand("list", "List the techniques");
  commands.list->add_flag("--json", io_options.json, "Print JSON");
  commands.run = commands.lab->add_subcommand("run", "Compare a technique with the engine");
  commands.run->add_option("TECHNIQUE", io_options.technique, "Name, or NAME:PARAMETER=VALUE,...")
      ->required();
  add_scene_options(*commands.run, io_options);
  add_space_options(*commands.run, io_options.space);
  commands.run
      ->add_option(
          "-o,--output", io_options.out,
          "Picture of the technique, the engine, and their difference, side by side; space: a picture, "
          "or a plot of its cost (.svg)")
      ->type_name("FILE.png");
  commands.compare = commands.lab->add_subcommand("compare", "Print a table of several techniques");
  commands.compare->add_option("TECHNIQUES", io_options.techniques, "Names, as for run")->required();
  add_scene_options(*commands.compare, io_options);
  commands.book = commands.lab->add_subcommand("book", "Write pages that compare all techniques");
  commands.book
      ->add_option("--map", io_options.maps,
                   "Level of the game, or a .bsp file; repeatable (default: a small built-in level)")
      ->type_name("NAME");
  add_frame_options(*commands.book, io_options.frame);
  commands.book->add_option("-o,--output", io_options.out, "Folder for the pages")
      ->type_name("FOLDER")
      ->required();
  commands.school = commands.lab->add_subcommand("school", "List lessons in rendering, or write their pages");
  commands.school->add_option("-o,--output", io_options.out, "Folder for the pages")->type_name("FOLDER");
  commands.replay = add_replay_command(*commands.lab, io_options.replay);
  commands.wire = commands.lab->add_subcommand(
      kWireName, "Compare ways to send a game's state over a network that loses packets");
  add_wire_options(*commands.wire, io_options.wire);
  commands.wire->add_flag("--json", io_options.json, "Print JSON");
  commands.wire->add_option("-o,--output", io_options.out, "Plots of freezes and bytes against loss")
      ->type_name("FILE.svg");
  commands.card = add_card_command(*commands.lab, io_options.card);
  return commands;
}

base::Status run_lab(const LabCommands& commands, const LabOptions& options, const GameFolders& folders,
                     const client::PresentationSettings& presentation, const render::Settings& settings) {
  if (commands.list->parsed()) {
    print_list(options.json);
    return base::Ok{};
  }
  if (commands.school->parsed()) {
    if (!options.out.empty()) return write_school(options.out);
    fmt::print("{}", describe_lessons());
    return base::Ok{};
  }
  if (commands.replay->parsed()) return run_replay(options.replay, folders);
  if (commands.wire->parsed()) return run_wire(options.wire, folders, options.json, options.out);
  if (commands.card->parsed()) return run_card(options.card, folders, presentation, settings);
  if (commands.book->parsed()) return make_book(options, folders, settings);
  const bool is_run = commands.run->parsed();
  if (is_run && options.technique == kSpaceName) {
    TRY_STATUS(check_space_options(options));
    return run_space(options.space, options.frame, options.json, options.out);
  }
  TRY_STATUS(check_technique_options(options));
  std::vector<std::string> texts = options.techniques;
  if (is_run) texts = {std::string(lab::list_techniques().front().name), options.technique};
  std::vector<lab::Choice> choices;
  for (const std::string& text : texts) {
    TRY(lab::Choice choice, lab::parse_choice(text));
    choices.push_back(std::move(choice));
  }
  if (is_run && !options.out.empty()) TRY_STATUS(numbered_name(options.out, 0));
  TRY(const LabScenes scenes, load_scenes(options, folders, presentation));
  for (const std::string& note : scenes.notes()) print_note(note);
  TRY_STATUS(scenes.check(choices));
  if (is_run && !options.out.empty()) TRY_STATUS(write_picture(options, choices.back(), scenes, settings));
  return compare(choices, options, scenes, settings);
}

}  // namespace temblor::app
