#include "host/commands/configuration.h"

#include <fmt/format.h>

#include <algorithm>

#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr std::uint64_t kMaxCommandFileBytes = 1 << 20;
constexpr std::string_view kStockConfiguration = "config.cfg";

// Whether all bytes are printable or white space. Bytes from 128 on are allowed: UTF-8, or the game's own
// letters.
bool is_text(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return c == 0 || (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\r' && c != '\n');
  });
}

// Finds the file of that name in the write folders, unless a later game folder came with one. Looks at the
// disk, because files that were written after the folders were mounted are not in their file tables.
std::optional<std::filesystem::path> find_written_file(const GameData& data, std::string_view name) {
  const std::optional<std::size_t> came_with = data.library.files().find_game(name);
  for (std::size_t game = data.write_folders.size(); game-- > came_with.value_or(0);) {
    const std::filesystem::path file = data.write_folders[game] / name;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

}  // namespace

bool has_commands(const GameData& data, std::string_view name) {
  return find_written_file(data, name) || data.library.files().contains(name);
}

base::Result<std::string> read_commands(const GameData& data, std::string_view name) {
  const std::optional<std::string> normalized = vfs::normalize_name(name);
  if (!normalized) return base::error(base::ErrorCode::kUsage, "\"{}\" is not a valid file name", name);
  const std::optional<std::filesystem::path> written = find_written_file(data, name);
  const base::Result<base::ByteVector> bytes =
      written ? vfs::read_disk_file(*written, kMaxCommandFileBytes) : data.library.files().read(name);
  if (!bytes.ok()) return bytes.error();
  std::string text(base::as_text(*bytes));
  if (text.size() > kMaxCommandFileBytes || !is_text(text))
    return base::malformed("{} is not a text file of console commands", name);
  return text;
}

std::optional<std::string> configuration_to_run(const GameData& data) {
  for (const std::string_view name : {kConfigurationFile, kStockConfiguration})
    if (has_commands(data, name)) return std::string(name);
  return std::nullopt;
}

base::Result<ReadConfiguration> read_configuration(const GameData& data) {
  const std::optional<std::filesystem::path> written = find_written_file(data, kConfigurationFile);
  TRY(const base::ByteVector bytes, written ? vfs::read_disk_file(*written, kMaxCommandFileBytes)
                                            : data.library.files().read(kConfigurationFile));
  ReadConfiguration read;
  for (std::string_view rest = base::as_text(bytes); !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (is_text(line))
      read.text += line;
    else
      ++read.unreadable_lines;
    read.text += '\n';
  }
  return read;
}

base::Result<std::optional<std::filesystem::path>> copy_damaged_configuration(const GameData& data) {
  const std::filesystem::path file = data.write_folder / kConfigurationFile;
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) return std::optional<std::filesystem::path>();
  std::filesystem::path copy = file;
  copy += ".damaged";
  std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing, failure);
  if (failure) return base::error(base::ErrorCode::kIo, "{}: {}", copy.string(), failure.message());
  return std::optional(std::move(copy));
}

std::string read_history(const GameData& data) {
  for (auto folder = data.write_folders.rbegin(); folder != data.write_folders.rend(); ++folder) {
    const base::Result<base::ByteVector> bytes =
        vfs::read_disk_file(*folder / kHistoryFile, kMaxCommandFileBytes);
    if (bytes.ok()) return std::string(base::as_text(*bytes));
  }
  return {};
}

std::string configuration_text(std::string_view bindings, std::string_view variables) {
  return fmt::format(
      "// Written by Temblor when it ends. Put your own commands into autoexec.cfg: it runs after this "
      "file.\n{}{}",
      bindings, variables);
}

}  // namespace temblor::host
