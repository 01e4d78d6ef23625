#include "app/installs/game_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "app/files/atomic_write.h"
#include "app/files/game_files.h"
#include "base/text.h"
#include "command/text.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxChoiceFileBytes = 1 << 20;
constexpr std::string_view kKey = "basedir";

bool is_choice(std::string_view line) {
  const std::vector<std::string> words = command::split_words(line);
  return !words.empty() && base::equal_ignoring_case(words[0], kKey);
}

std::string_view take_line(std::string_view& io_text) {
  const std::string_view line = io_text.substr(0, io_text.find('\n'));
  io_text.remove_prefix(std::min(line.size() + 1, io_text.size()));
  return line;
}

base::Result<std::string> read_choice_text(const fs::path& file) {
  std::error_code failure;
  if (!fs::exists(file, failure)) return std::string();
  TRY(const base::ByteVector bytes, vfs::read_disk_file(file, kMaxChoiceFileBytes));
  return std::string(base::as_text(bytes));
}

bool has_id1(const fs::path& folder) {
  std::error_code failure;
  for (fs::directory_iterator i(vfs::find_id1_parent(folder), failure), end; !failure && i != end;
       i.increment(failure))
    if (base::equal_ignoring_case(i->path().filename().string(), "id1")) return true;
  return false;
}

// Lists what the menu offers. A folder that the user has chosen is offered although no store installed it.
std::vector<host::GameSource> list_sources(const std::optional<fs::path>& shipped, const fs::path& chosen,
                                           const UserFolders& user) {
  std::vector<host::GameSource> sources;
  if (shipped)
    sources.push_back(
        {std::string(kShippedGameName), "Temblor's own game", *shipped, is_installed_game(*shipped)});
  for (const InstalledGame& game : find_installed_games(user))
    sources.push_back({game.base_folder.string(), game.title, game.base_folder, false});
  const auto is_listed = [&](const host::GameSource& source) { return source.base_folder == chosen; };
  if (!chosen.empty() && std::none_of(sources.begin(), sources.end(), is_listed))
    sources.push_back({chosen.string(), chosen.string(), chosen, false});
  return sources;
}

}  // namespace

fs::path find_choice_file(const UserFolders& user) {
  return user.config.empty() ? fs::path() : user.config / "temblor/temblor.cfg";
}

base::Result<std::optional<std::string>> read_choice(const fs::path& file, const fs::path& home) {
  TRY(const std::string text, read_choice_text(file));
  std::optional<std::string> choice;
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::string_view line = take_line(rest);
    if (!is_choice(line)) continue;
    const std::vector<std::string> words = command::split_words(line);
    if (words.size() != 2 || words[1].empty())
      return base::Error{
          base::ErrorCode::kMalformed,
          fmt::format("line {}: basedir takes one folder; put quotes around a name with spaces", number),
          file.string()};
    choice = words[1].starts_with("~/") ? (home / words[1].substr(2)).string() : words[1];
  }
  return choice;
}

base::Status write_choice(const fs::path& file, std::string_view value) {
  TRY(const std::string text, read_choice_text(file));
  std::string kept;
  for (std::string_view rest = text; !rest.empty();)
    if (const std::string_view line = take_line(rest); !is_choice(line)) kept += std::string(line) + '\n';
  kept += command::join_words({std::string(kKey), std::string(value)}) + '\n';
  std::error_code failure;
  fs::create_directories(file.parent_path(), failure);
  return replace_file(file, base::as_bytes(kept), Remedy::kNone);
}

base::Result<GameChoice> choose_game(const GameFolders& folders, const UserFolders& user) {
  const char* const data = std::getenv("TEMBLOR_DATA");
  if (folders.base_folder.empty() && data != nullptr && *data != 0) return GameChoice{.base_folder = data};
  if (!has_no_game_data(folders)) {
    TRY(const fs::path base_folder, find_base_folder(folders));
    return GameChoice{.base_folder = base_folder};
  }
  const base::Result<fs::path> found_shipped = find_base_folder(folders);
  const std::optional<fs::path> shipped = found_shipped.ok() ? std::optional(*found_shipped) : std::nullopt;

  GameChoice choice;
  fs::path chosen;
  bool has_chosen = false;
  const base::Result<std::optional<std::string>> setting = read_choice(find_choice_file(user), user.home);
  if (!setting.ok()) {
    choice.warning = setting.error().message();
  } else if (*setting && **setting == kShippedGameName) {
    has_chosen = shipped.has_value();
  } else if (*setting && has_id1(**setting)) {
    chosen = **setting;
    has_chosen = true;
  } else if (*setting) {
    choice.warning = fmt::format("{}: basedir: there is no id1 in {}", find_choice_file(user).string(),
                                 base::printable(**setting));
  }
  choice.sources = list_sources(shipped, chosen, user);
  if (choice.sources.empty()) return found_shipped.error();
  choice.base_folder = has_chosen && !chosen.empty() ? chosen : choice.sources.front().base_folder;
  if (choice.sources.size() < 2) choice.sources.clear();
  choice.asks = !has_chosen && !choice.sources.empty();
  return choice;
}

}  // namespace temblor::app
