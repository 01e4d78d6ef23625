#include "app/commands/play_watch.h"

#include <fmt/format.h>

#include <chrono>

#include "app/files/child_process.h"
#include "command/text.h"

namespace temblor::app {
namespace {

constexpr double kLookEvery_s = 0.2;

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

// Returns a console command that prints the line.
std::string make_echo_command(const std::string& line) {
  return command::join_words({"echo", line});
}

}  // namespace

PlayWatch::Compiled PlayWatch::run_compiler(const std::vector<std::string>& words) {
  TRY(ChildProcess compiler, ChildProcess::start(words));
  TRY_STATUS(compiler.finish());
  return compiler.messages();
}

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
      Map map{make_compiler_command(file, level, folders), {}};
      map.watch.add({stamp});
      TRY(const std::vector<std::string> said, run_compiler(map.compile));
      for (const std::string& line : said) watch.lines_.push_back(make_echo_command(line));
      watch.maps_.push_back(std::move(map));
    }
    const std::string played = games.files.where("maps/" + watch.level_ + ".bsp");
    watch.played_.add({read_file_stamp(is_map || played.empty() ? level : std::filesystem::path(played))});
  }
  return watch;
}

std::vector<std::string> PlayWatch::look(double now_s) {
  std::vector<std::string> lines = std::exchange(lines_, {});
  if (now_s - looked_at_s_ < kLookEvery_s) return lines;
  looked_at_s_ = now_s;
  // The compiler runs in a thread, one map at a time. Its level is noticed as a change of the .bsp.
  if (compiling_ && compiling_->wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    const Compiled compiled = compiling_->get();
    compiling_.reset();
    if (!compiled.ok())
      lines.push_back(make_echo_command(compiled.error().message()));
    else
      for (const std::string& line : *compiled) lines.push_back(make_echo_command(line));
  }
  for (Map& map : maps_)
    if (!compiling_ && map.watch.has_changed()) {
      lines.push_back("echo Compiling...");
      compiling_ = std::async(std::launch::async, run_compiler, map.compile);
    }
  if (played_.has_changed()) lines.emplace_back("reload");
  return lines;
}

}  // namespace temblor::app
