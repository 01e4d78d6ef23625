#include "app/compile/play_watch.h"

#include <fmt/format.h>

#include <utility>

#include "command/text.h"

namespace temblor::app {
namespace {

constexpr double kLookEvery_s = 0.2, kIdleBeforeFull_s = 5;

// Returns the command line that compiles the map with this program. A separate process, so that a map which
// crashes the compiler does not end the game.
std::vector<std::string> make_compiler_command(const std::filesystem::path& map,
                                               const std::filesystem::path& level,
                                               const host::GameFolders& folders) {
  std::vector<std::string> words = {std::filesystem::read_symlink("/proc/self/exe").string(), "--basedir",
                                    folders.base_folder.string()};
  for (const std::string& game : folders.games) words.insert(words.end(), {"--game", game});
  words.insert(words.end(), {"compile", map.string(), "-o", level.string()});
  return words;
}

std::vector<std::string> make_fast(std::vector<std::string> compile) {
  compile.emplace_back("--fast");
  return compile;
}

// The compiler removes the path when the level is sealed.
bool has_leak(const std::filesystem::path& leak_points) {
  std::error_code ignored;
  return std::filesystem::exists(leak_points, ignored);
}

// Returns a console command that prints the line.
std::string make_echo_command(std::string_view line) {
  return command::join_words({"echo", std::string(line)});
}

}  // namespace

base::Result<PlayWatch> PlayWatch::begin(const std::vector<std::string>& files,
                                         const host::GameFolders& folders) {
  PlayWatch watch;
  if (files.empty()) return watch;
  TRY(const host::MountedGames games, host::mount_games(folders));
  for (const std::string& name : files) {
    const std::filesystem::path file = name;
    const FileStamp stamp = read_file_stamp(file);
    if (!stamp.exists) return base::error(base::ErrorCode::kNotFound, "--watch: {} does not exist", name);
    if (file.extension() == ".dat") {
      watch.program_ = name;
      watch.played_.add({stamp});
      continue;
    }
    if (file.extension() != ".map" && file.extension() != ".bsp")
      return base::error(base::ErrorCode::kUsage, "--watch: {} is not a .map, .bsp, or .dat file", name);
    // A map is compiled to the directory that the game writes to. A .bsp may also be in another game
    // directory.
    watch.level_ = file.stem().string();
    const std::filesystem::path level = games.write_folders.back() / "maps" / (watch.level_ + ".bsp");
    const bool is_map = file.extension() == ".map";
    if (is_map) {
      std::error_code ignored;
      std::filesystem::create_directories(level.parent_path(), ignored);
      Map map{watch.level_,
              std::filesystem::path(level).replace_extension(".pts"),
              make_compiler_command(file, level, folders),
              {}};
      map.watch.add({stamp});
      TRY(ChildProcess compiler, ChildProcess::start(make_fast(map.compile)));
      TRY_STATUS(compiler.finish());
      for (const std::string& line : compiler.messages()) watch.echo(line);
      map.needs_full = !has_leak(map.leak_points);
      watch.maps_.push_back(std::move(map));
    }
    const std::string played = games.files.where("maps/" + watch.level_ + ".bsp");
    watch.played_.add({read_file_stamp(is_map || played.empty() ? level : std::filesystem::path(played))});
  }
  return watch;
}

void PlayWatch::echo(std::string_view line) {
  lines_.push_back(make_echo_command(line));
}

// Notes saved maps. A compilation in full of one is out of date, so it stops.
void PlayWatch::find_changes(double now_s) {
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    Map& map = maps_[i];
    if (!map.watch.has_changed()) continue;
    map.needs_fast = true;
    map.needs_full = false;
    map.changed_at_s = now_s;
    if (!compiling_ || compiling_->map != i || !compiling_->is_full) continue;
    compiling_->process.terminate();
    compiling_->is_stopped = true;
  }
}

// The new level is noticed as a change of the .bsp.
void PlayWatch::finish_compiling() {
  if (!compiling_ || !compiling_->process.has_ended()) return;
  Compiling ended = std::move(*compiling_);
  compiling_.reset();
  const base::Status status = ended.process.finish();
  if (ended.is_stopped) return;
  if (!status.ok()) return echo(status.error().message());
  for (const std::string& line : ended.process.messages()) echo(line);
  Map& map = maps_[ended.map];
  map.needs_full = !ended.is_full && !map.needs_fast && !has_leak(map.leak_points);
}

// Starts one compilation; saved maps come first.
void PlayWatch::start_compiling(double now_s) {
  if (compiling_) return;
  for (std::size_t i = 0; i < maps_.size(); ++i)
    if (std::exchange(maps_[i].needs_fast, false)) return start(i, false);
  for (std::size_t i = 0; i < maps_.size(); ++i)
    if (maps_[i].needs_full && now_s - maps_[i].changed_at_s >= kIdleBeforeFull_s) {
      maps_[i].needs_full = false;
      return start(i, true);
    }
}

void PlayWatch::start(std::size_t map, bool is_full) {
  const std::vector<std::string>& full = maps_[map].compile;
  base::Result<ChildProcess> process = ChildProcess::start(is_full ? full : make_fast(full));
  if (!process.ok()) return echo(process.error().message());
  if (is_full) process->lower_priority();
  echo(is_full ? "Compiling in full..." : "Compiling...");
  compiling_.emplace(Compiling{std::move(*process), map, is_full});
}

std::vector<std::string> PlayWatch::look(double now_s, std::string_view played_level) {
  const bool has_begun_level = !played_level.empty() && played_level_ != played_level;
  played_level_ = played_level;
  if (has_begun_level)
    for (const Map& map : maps_)
      if (map.level == played_level && has_leak(map.leak_points)) lines_.emplace_back("pointfile");
  if (now_s - looked_at_s_ >= kLookEvery_s) {
    if (looked_at_s_ == 0)
      for (Map& map : maps_) map.changed_at_s = now_s;
    looked_at_s_ = now_s;
    find_changes(now_s);
    finish_compiling();
    start_compiling(now_s);
    if (played_.has_changed()) lines_.emplace_back("reload");
  }
  return std::exchange(lines_, {});
}

}  // namespace temblor::app
