// The scripted player: plays a level from its start to its exit, as a client of a server, as fast as the
// machine can. README.md describes its options, its messages for level designers, and how it works.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fstream>

#include "scripted_player/film/make_film.h"
#include "scripted_player/session/run.h"
#include "vfs/disk.h"

namespace temblor::player {
namespace {

// Prints an error and returns false if the file cannot be written.
bool write(const std::string& file, base::Bytes bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (out.flush()) return true;
  fmt::print(stderr, "scripted_player: {}: cannot write the file\n", file);
  return false;
}

// Makes the film of a script. Returns the exit status.
int record_film(const std::string& script_file, const std::string& base_folder,
                const std::string& demo_file) {
  const auto make = [&]() -> base::Result<Film> {
    TRY(const base::ByteVector text, vfs::read_disk_file(script_file));
    TRY(const FilmScript script,
        read_film_script({reinterpret_cast<const char*>(text.data()), text.size()}).with_file(script_file));
    return make_film(script, base_folder);
  };
  const base::Result<Film> film = make();
  if (!film.ok()) {
    fmt::print(stderr, "scripted_player: {}\n", film.error().message());
    return 2;
  }
  if (!write(demo_file, film->demo)) return 2;
  fmt::print("{}: {:.1f} s, {} bytes\n", demo_file, film->length_s, film->demo.size());
  return 0;
}

int run(int argument_count, char** arguments) {
  CLI::App program(
      "Plays a level from its start to its exit. Exit status: 0 if it reached the exit, 1 if not, 2 for an "
      "error.");
  RunSetup setup;
  setup.session.map = "start";
  int players = 0;
  std::string record, film, report_file, place_file, base_folder, program_file;
  std::vector<float> waypoints;
  bool is_peaceful = false, is_verbose = false;
  program.add_option("--basedir", base_folder, "Directory that contains id1")->required();
  program.add_option("--game", setup.session.games, "Game directory to add to id1; repeatable");
  program.add_option("--progs", program_file, "Game code; default: progs.dat of the game directories");
  CLI::Option* map = program.add_option("--map", setup.session.map, "Level to play");
  program.add_option("--skill", setup.session.skill, "Skill, 0 to 3")->check(CLI::Range(0, 3));
  program.add_option("--seed", setup.session.seed, "Seed of all random numbers");
  program.add_option("--coop", players, "Number of cooperating players")->check(CLI::Range(1, 16));
  program.add_option("--deathmatch", setup.session.bots, "Number of bots to play against until the limit")
      ->check(CLI::Range(1, 15));
  program.add_option("--limit", setup.limit_s, "Limit of game time in seconds")->capture_default_str();
  program
      .add_option("--protocol", setup.session.protocol,
                  "Protocol of the game and its demo; the oldest has no sizes of models")
      ->check(CLI::IsMember({"auto", "15", "666", "999"}))
      ->capture_default_str();
  program.add_option("--exit", setup.exit_map, "Take the exit to this level");
  program.add_option("--waypoints", waypoints, "Points to visit first: X Y Z X Y Z ...");
  CLI::Option* record_option = program.add_option("--record", record, "Record a demo of the first player");
  program.add_option("--film", film, "Record the demo of a film script (game/film.script) instead")
      ->needs(record_option)
      ->excludes(map);
  program.add_option("--report", report_file, "Write the results as JSON");
  program.add_option("--places", place_file, "Write every place that a player can reach, as text");
  program.add_flag("--secrets", setup.visits_secrets, "Visit every secret");
  program.add_flag("--tour", setup.visits_stops, "First visit the tour stops of the level");
  program.add_flag("--god", setup.has_god, "Play without damage");
  program.add_flag("--peaceful", is_peaceful, "Do not fight");
  program.add_flag("--verbose", is_verbose, "Print the current goal every few seconds");
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return program.exit(error);  // --help
    fmt::print(stderr, "scripted_player: {}\n", error.what());
    return 2;
  }

  if (!film.empty()) return record_film(film, base_folder, record);
  if (map->empty()) {
    fmt::print(stderr, "scripted_player: --map or --film is required\n");
    return 2;
  }
  if (waypoints.size() % 3 != 0) {
    fmt::print(stderr, "scripted_player: --waypoints: each point needs three numbers, X Y Z\n");
    return 2;
  }
  setup.session.base_folder = base_folder;
  setup.session.program_file = program_file;
  setup.session.cooperative = players > 0;
  setup.session.players = players > 0 ? static_cast<std::uint32_t>(players) : 1;
  setup.session.can_cheat = setup.has_god;
  setup.fights = !is_peaceful;
  setup.session.records = !record.empty();
  for (std::size_t i = 0; i + 2 < waypoints.size(); i += 3)
    setup.waypoints.push_back({waypoints[i], waypoints[i + 1], waypoints[i + 2]});
  setup.lists_places = !place_file.empty();
  if (is_verbose) setup.on_status = [](std::string_view line) { fmt::print(stderr, "{}\n", line); };

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
  if (!record.empty() && !write(record, report->demo)) return 2;
  const bool is_won = setup.session.bots > 0 ? report->errors.empty() : report->reached_exit;
  return is_won ? 0 : 1;
}

}  // namespace
}  // namespace temblor::player

int main(int argument_count, char** arguments) {
  return temblor::player::run(argument_count, arguments);
}
