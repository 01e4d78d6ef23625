// Plays a level from its start to its exit, as a client of a server, as fast as the machine can.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fstream>

#include "scripted_player/run.h"

namespace temblor::player {
namespace {

bool write(const std::string& file, base::Bytes bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (out.flush()) return true;
  fmt::print(stderr, "scripted_player: {}: cannot be written\n", file);
  return false;
}

int run(int argument_count, char** arguments) {
  CLI::App program("Plays a level from its start to its exit; exit status 0: it got there");
  RunSetup setup;
  setup.session.map = "start";
  int players = 0;
  std::string record, report_file, place_file, base_folder, program_file;
  std::vector<float> waypoints;
  bool is_peaceful = false, is_verbose = false;
  program.add_option("--basedir", base_folder, "Folder that holds id1")->required();
  program.add_option("--game", setup.session.games, "Game folder over id1; may be repeated");
  program.add_option("--progs", program_file, "The game's code; without it the game folders' progs.dat");
  program.add_option("--map", setup.session.map, "Level")->required();
  program.add_option("--skill", setup.session.skill, "0 to 3")->check(CLI::Range(0, 3));
  program.add_option("--seed", setup.session.seed, "Of all chance");
  program.add_option("--coop", players, "So many players together")->check(CLI::Range(1, 16));
  program.add_option("--deathmatch", setup.session.bots, "Against so many bots, until the limit")
      ->check(CLI::Range(1, 15));
  program.add_option("--limit", setup.limit_s, "Seconds of the game's time")->capture_default_str();
  program.add_option("--exit", setup.exit_map, "Of several exits the one to this level");
  program.add_option("--waypoints", waypoints, "Places to visit first: X Y Z X Y Z ...");
  program.add_option("--record", record, "Writes what the first player sees (.dem)");
  program.add_option("--report", report_file, "Writes what was found as JSON");
  program.add_option("--places", place_file, "Writes every place that a player can get to, as text");
  program.add_flag("--secrets", setup.visits_secrets, "Visits every secret");
  program.add_flag("--tour", setup.visits_stops, "Visits the stops that the level names, first");
  program.add_flag("--god", setup.has_god, "Cannot be hurt");
  program.add_flag("--peaceful", is_peaceful, "Does not fight");
  program.add_flag("--verbose", is_verbose, "Tells what it does");
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return program.exit(error);  // --help
    fmt::print(stderr, "scripted_player: {}\n", error.what());
    return 2;
  }

  if (waypoints.size() % 3 != 0) {
    fmt::print(stderr, "scripted_player: --waypoints: each has three numbers, X Y Z\n");
    return 2;
  }
  setup.session.base_folder = base_folder;
  setup.session.program_file = program_file;
  setup.session.cooperative = players > 0;
  setup.session.players = players > 0 ? static_cast<std::uint32_t>(players) : 1;
  setup.session.can_cheat = setup.has_god;
  setup.fights = !is_peaceful;
  setup.records = !record.empty();
  for (std::size_t i = 0; i + 2 < waypoints.size(); i += 3)
    setup.waypoints.push_back({waypoints[i], waypoints[i + 1], waypoints[i + 2]});
  setup.lists_places = !place_file.empty();
  if (is_verbose) setup.tell = [](std::string_view line) { fmt::print(stderr, "{}\n", line); };

  const base::Result<RunReport> report = play_level(setup);
  if (!report.ok()) {
    fmt::print(stderr, "scripted_player: {}\n", report.error().message());
    return 2;
  }
  fmt::print("{} skill {} seed {}{}: {}", setup.session.map, setup.session.skill, setup.session.seed,
             players > 0 ? fmt::format(" coop {}", players) : std::string(), as_text(*report));
  const std::string json = as_json(*report);
  if (!report_file.empty() && !write(report_file, base::as_bytes(json))) return 2;
  if (!place_file.empty() && !write(place_file, base::as_bytes(report->place_list))) return 2;
  if (!record.empty() && !write(record, report->recording)) return 2;
  const bool is_won = setup.session.bots > 0 ? report->errors.empty() : report->reached_exit;
  return is_won ? 0 : 1;
}

}  // namespace
}  // namespace temblor::player

int main(int argument_count, char** arguments) {
  return temblor::player::run(argument_count, arguments);
}
