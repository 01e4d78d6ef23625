#include "vfs/file_system.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/text.h"
#include "formats/archives/archive.h"
#include "formats/archives/pak.h"

namespace temblor::vfs {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

constexpr std::string_view kFirstGame = "id1";
constexpr std::string_view kReleaseFolder = "rerelease";

struct FolderEntry {
  std::string name;  // as on disk
  fs::path path;
  bool is_folder;
};

// Lists a folder in byte order of the names. Symbolic links count as the file or folder they lead to.
base::Result<std::vector<FolderEntry>> list_folder(const fs::path& folder) {
  std::error_code error;
  std::vector<FolderEntry> entries;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    std::error_code ignored;  // a broken link is neither file nor folder
    const bool is_folder = i->is_directory(ignored);
    if (is_folder || i->is_regular_file(ignored))
      entries.push_back({i->path().filename().string(), i->path(), is_folder});
  }
  if (error) return base::Error{ErrorCode::kIo, error.message(), folder.string()};
  std::sort(entries.begin(), entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) { return a.name < b.name; });
  return entries;
}

// Finds the folder of that name, ignoring case; null if there is none.
const FolderEntry* find_folder(const std::vector<FolderEntry>& entries, std::string_view name) {
  const FolderEntry* found = nullptr;
  for (const FolderEntry& entry : entries)
    if (entry.is_folder && base::equal_ignoring_case(entry.name, name) && (!found || entry.name == name))
      found = &entry;
  return found;
}

base::Result<fs::path> find_game_folder(const fs::path& base_folder, const std::string& name) {
  if (!formats::is_contained_name(name) || name.find('/') != std::string::npos)
    return base::error(ErrorCode::kUsage, "\"{}\" is not the name of a game folder", base::printable(name));
  TRY(const std::vector<FolderEntry> entries, list_folder(base_folder));
  const FolderEntry* const found = find_folder(entries, name);
  if (!found)
    return base::Error{ErrorCode::kNotFound,
                       fmt::format("no game folder \"{}\" here; check --basedir and --game", name),
                       base_folder.string()};
  return found->path;
}

// Finds pak0.pak, pak1.pak, ... up to the first missing number.
std::vector<fs::path> find_paks(const std::vector<FolderEntry>& entries) {
  std::vector<fs::path> paks;
  for (const FolderEntry* found = nullptr;; paks.push_back(found->path)) {
    const std::string wanted = fmt::format("pak{}.pak", paks.size());
    found = nullptr;
    for (const FolderEntry& entry : entries)
      if (!entry.is_folder && base::equal_ignoring_case(entry.name, wanted)) found = &entry;
    if (found == nullptr) return paks;
  }
}

// Finds the archives with one of these extensions, sorted by name.
std::vector<fs::path> find_zips(const std::vector<FolderEntry>& entries,
                                std::initializer_list<std::string_view> extensions) {
  std::vector<std::pair<std::string, fs::path>> found;
  for (const FolderEntry& entry : entries) {
    const std::string name = base::to_lower(entry.name);
    const auto has = [&](std::string_view extension) { return name.ends_with(extension); };
    if (!entry.is_folder && std::any_of(extensions.begin(), extensions.end(), has))
      found.emplace_back(name, entry.path);
  }
  std::sort(found.begin(), found.end());
  std::vector<fs::path> zips;
  for (auto& [name, path] : found) zips.push_back(std::move(path));
  return zips;
}

base::Status explain_damage(base::Status mounted) {
  if (mounted.ok()) return mounted;
  base::Error error = mounted.error();
  error.what += "; copy this archive from the game again, or move it elsewhere";
  return error;
}

}  // namespace

fs::path find_id1_parent(const fs::path& base_folder) {
  const auto find = [](const fs::path& folder, std::string_view name) -> std::optional<fs::path> {
    const base::Result<std::vector<FolderEntry>> entries = list_folder(folder);
    const FolderEntry* const found = entries.ok() ? find_folder(*entries, name) : nullptr;
    return found == nullptr ? std::nullopt : std::optional(found->path);
  };
  if (find(base_folder, kFirstGame)) return base_folder;
  const std::optional<fs::path> release = find(base_folder, kReleaseFolder);
  return release && find(*release, kFirstGame) ? *release : base_folder;
}

std::optional<std::string> normalize_name(std::string_view name) {
  std::string normalized = base::to_lower(name);
  std::replace(normalized.begin(), normalized.end(), '\\', '/');
  if (!formats::is_contained_name(normalized)) return std::nullopt;
  return normalized;
}

base::Result<FileSystem> FileSystem::open(const fs::path& base_folder, std::span<const std::string> games) {
  if (std::error_code ignored; !fs::is_directory(base_folder, ignored))
    return base::Error{ErrorCode::kNotFound, "no such folder; --basedir names the folder that holds id1",
                       base_folder.string()};
  std::vector<std::string> names;
  for (const std::string& game : games) {
    if (base::equal_ignoring_case(game, kFirstGame)) continue;
    // A game that is listed twice moves to the top.
    std::erase_if(names, [&](const std::string& name) { return base::equal_ignoring_case(name, game); });
    names.push_back(game);
  }
  names.insert(names.begin(), std::string(kFirstGame));
  const fs::path parent = find_id1_parent(base_folder);
  FileSystem files;
  TRY(const std::vector<FolderEntry> shared, list_folder(parent));
  for (const fs::path& path : find_zips(shared, {".kpf"}))
    TRY_STATUS(explain_damage(files.mount_zip(path, 0)));
  for (const std::string& name : names) {
    TRY(const fs::path folder, find_game_folder(parent, name));
    TRY_STATUS(files.mount_game(folder));
  }
  return files;
}

// Later mounts hide earlier ones, so the order here is the reverse of the search order.
base::Status FileSystem::mount_game(const fs::path& folder) {
  folders_.push_back(folder);
  TRY_STATUS(mount_loose_files(folder, folders_.size() - 1));
  TRY(const std::vector<FolderEntry> entries, list_folder(folder));
  for (const fs::path& path : find_paks(entries)) TRY_STATUS(explain_damage(mount_pak(path)));
  for (const fs::path& path : find_zips(entries, {".pk3", ".kpf"}))
    TRY_STATUS(explain_damage(mount_zip(path, folders_.size() - 1)));
  return base::Ok{};
}

base::Status FileSystem::mount_over(std::size_t game, const fs::path& folder) {
  CHECK(game < folders_.size(), "{} of {}", game, folders_.size());
  std::error_code ignored;
  return fs::is_directory(folder, ignored) ? mount_loose_files(folder, game) : base::Ok{};
}

// It counts as a file of the last game.
void FileSystem::mount_file(std::string_view name, const fs::path& path) {
  add_file(name, {.path = path, .game = folders_.empty() ? 0 : folders_.size() - 1});
}

void FileSystem::hide_file(std::string_view name) {
  const std::optional<std::string> normalized = normalize_name(name);
  if (!normalized) return;
  files_.erase(*normalized);
  hidden_.erase(*normalized);
}

base::Status FileSystem::mount_loose_files(const fs::path& folder, std::size_t game) {
  struct Pending {
    fs::path path;
    std::string prefix;               // path of the folder below the game folder
    std::vector<fs::path> parents{};  // without links
  };
  std::vector<Pending> pending{{folder, ""}};
  add_source({folder, game, std::nullopt});
  while (!pending.empty()) {
    Pending current = std::move(pending.back());
    pending.pop_back();
    std::error_code error;
    fs::path real = fs::canonical(current.path, error);
    // A link to a folder that contains it would never end.
    if (std::find(current.parents.begin(), current.parents.end(), real) != current.parents.end()) continue;
    current.parents.push_back(std::move(real));
    TRY(const std::vector<FolderEntry> entries, list_folder(current.path));
    // Lower case is last in byte order, so it wins among names that differ only in case.
    for (const FolderEntry& entry : entries) {
      const std::string name = current.prefix + entry.name;
      if (entry.is_folder)
        pending.push_back({entry.path, name + '/', current.parents});
      else
        add_file(name, {.path = entry.path, .game = game});
    }
  }
  return base::Ok{};
}

base::Status FileSystem::mount_pak(const fs::path& path) {
  TRY(const std::uint64_t archive_bytes, disk_file_size(path));
  TRY(const base::ByteVector header_bytes,
      read_disk_range(path, 0, std::min<std::uint64_t>(archive_bytes, formats::kPakHeaderBytes)));
  TRY(const formats::PakHeader header,
      formats::read_pak_header(header_bytes, archive_bytes).with_file(path.string()));
  TRY(const base::ByteVector directory,
      read_disk_range(path, header.directory_offset, header.directory_bytes));
  const std::vector<formats::PakEntry> entries = formats::read_pak_directory(directory, archive_bytes);
  add_source({path, folders_.size() - 1, entries.size()});
  // Backward, so that the first entry with a name wins.
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
    add_file(entry->name,
             {.path = path, .range = Range{entry->offset, entry->size}, .game = folders_.size() - 1});
  return base::Ok{};
}

base::Status FileSystem::mount_zip(const fs::path& path, std::size_t game) {
  TRY(base::ByteVector bytes, read_disk_file(path, kMaxPk3Bytes - pk3_bytes_));
  pk3_bytes_ += bytes.size();
  TRY(formats::Pk3 opened, formats::read_pk3(std::move(bytes)).with_file(path.string()));
  const auto pk3 = std::make_shared<const formats::Pk3>(std::move(opened));
  add_source({path, game, pk3->entries().size()});
  for (std::size_t i = 0; i < pk3->entries().size(); ++i)
    add_file(pk3->entries()[i].name, {.path = path, .pk3 = pk3, .pk3_position = i, .game = game});
  return base::Ok{};
}

// Skips names that no lookup can find; a PAK may contain any name.
void FileSystem::add_file(std::string_view name, File file) {
  std::optional<std::string> normalized = normalize_name(name);
  if (!normalized) return;
  const auto found = files_.find(*normalized);
  if (found == files_.end()) {
    files_.emplace(std::move(*normalized), std::move(file));
    return;
  }
  if (found->second.game != file.game) {
    File& lower = found->second.game < file.game ? found->second : file;
    hidden_[*normalized].insert_or_assign(lower.game, lower);
  }
  if (found->second.game <= file.game) found->second = std::move(file);
}

void FileSystem::add_source(Source source) {
  const auto higher = std::find_if(sources_.begin(), sources_.end(),
                                   [&](const Source& other) { return other.game > source.game; });
  sources_.insert(higher, std::move(source));
}

const FileSystem::File* FileSystem::find(std::string_view name) const {
  const std::optional<std::string> normalized = normalize_name(name);
  if (!normalized) return nullptr;
  const auto found = files_.find(*normalized);
  return found == files_.end() ? nullptr : &found->second;
}

base::Result<base::ByteVector> FileSystem::read(std::string_view name) const {
  const File* file = find(name);
  if (file == nullptr) {
    std::vector<std::string> searched;
    for (const fs::path& folder : folders_) searched.push_back(folder.string());
    return base::Error{ErrorCode::kNotFound,
                       fmt::format("not in {}; check the name, or add the game that has it with --game",
                                   fmt::join(searched, " or ")),
                       base::printable(name)};
  }
  return read_file(*file, describe(name));
}

base::Result<base::ByteVector> FileSystem::read_file(const File& file, const std::string& description) {
  if (!file.pk3 && !file.range) return read_disk_file(file.path);
  const std::uint64_t size = file.pk3 ? file.pk3->entries()[file.pk3_position].size : file.range->size;
  if (size > kMaxFileBytes)
    return base::Error{ErrorCode::kTooLarge, fmt::format("{} bytes, the limit is {}", size, kMaxFileBytes),
                       description};
  if (file.pk3) return file.pk3->read(file.pk3_position).with_file(description);
  return read_disk_range(file.path, file.range->offset, file.range->size);
}

std::function<base::Result<base::ByteVector>()> FileSystem::reader(std::string_view name) const {
  const File* file = find(name);
  if (file != nullptr)
    return [file = *file, description = describe(name)] { return read_file(file, description); };
  return [error = read(name).error()] { return base::Result<base::ByteVector>(error); };
}

bool FileSystem::contains(std::string_view name) const {
  return find(name) != nullptr;
}

std::string FileSystem::where(std::string_view name) const {
  const File* file = find(name);
  return file == nullptr ? std::string() : file->path.string();
}

std::string FileSystem::describe(std::string_view name, const File& file) {
  if (!file.pk3 && !file.range) return file.path.string();
  return fmt::format("{} in {}", base::printable(name), file.path.string());
}

std::string FileSystem::describe(std::string_view name) const {
  const File* file = find(name);
  return file == nullptr ? base::printable(name) : describe(name, *file);
}

std::vector<FileSystem::Layer> FileSystem::read_layers(std::string_view name) const {
  std::vector<Layer> layers;
  const File* const top = find(name);
  if (top == nullptr) return layers;
  const auto add = [&](const File& file) {
    const std::string description = describe(name, file);
    layers.push_back({file.game, description, read_file(file, description)});
  };
  if (const auto hidden = hidden_.find(*normalize_name(name)); hidden != hidden_.end())
    for (const auto& [game, file] : hidden->second) add(file);
  add(*top);
  return layers;
}

std::optional<std::size_t> FileSystem::find_game(std::string_view name) const {
  const File* file = find(name);
  if (file == nullptr) return std::nullopt;
  return file->game;
}

std::vector<std::string> FileSystem::list(std::string_view prefix, std::string_view suffix) const {
  const std::string wanted_prefix = base::to_lower(prefix);
  const std::string wanted_suffix = base::to_lower(suffix);
  std::vector<std::string> names;
  for (auto i = files_.lower_bound(wanted_prefix); i != files_.end() && i->first.starts_with(wanted_prefix);
       ++i)
    if (i->first.ends_with(wanted_suffix)) names.push_back(i->first);
  return names;
}

}  // namespace temblor::vfs
