// The virtual file system: the folders and archives of the games, mounted on top of each other, with lookup
// by name.
//
// Search order, highest priority first:
//
//   files of mount_file()
//   last game folder      files of mount_over()
//                         *.pk3 and *.kpf, in reverse alphabetical order
//                         pakN.pak ... pak1.pak, pak0.pak (N: the last number before the first missing one)
//                         loose files
//   ...                   the same for each earlier game
//   id1                   the same
//   base folder           *.kpf, in reverse alphabetical order
//
// The 2021 release keeps what all its games share in QuakeEX.kpf next to them. KPF archives are zip files
// like PK3; those in a game folder count as PK3.
//
// So archives hide loose files of the same folder, as in the original engine.
//
// Names are relative, with '/' between the parts ('\' means '/'), and case-insensitive, because many mods
// were made on Windows. A server may send any name: one that leaves the game folders is never found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/archives/pk3.h"
#include "vfs/disk.h"

namespace temblor::vfs {

// Limit for all *.pk3 together, which are kept in memory. Each single file has at most kMaxFileBytes.
constexpr std::uint64_t kMaxPk3Bytes = std::uint64_t{1} << 30;

// Returns the folder that holds id1: `base_folder` itself, or the folder "rerelease" in it if only that one
// has an id1. Stores with the 2021 release install it that way, next to the game of 1996.
std::filesystem::path find_id1_parent(const std::filesystem::path& base_folder);

// Returns the name in the form that lookups use: lower case, '/' between parts. Returns nullopt for names
// that are empty, absolute, or contain "..".
std::optional<std::string> normalize_name(std::string_view name);

// Reads folders and archive directories once, when they are mounted; does not see files that are created
// later. Const functions are thread-safe.
class FileSystem {
 public:
  // Mounts id1 and `games`, which are case-insensitive names of folders in find_id1_parent(base_folder)
  // ("id1" may be omitted). Returns kNotFound if the base folder, id1, or a game does not exist, kUsage for
  // an invalid name, and an error that names the archive if one is damaged: a game with half of its files
  // would fail later, in many places.
  static base::Result<FileSystem> open(const std::filesystem::path& base_folder,
                                       std::span<const std::string> games = {});

  // Mounts the loose files of another folder above the files and archives of game number `game`. Does not
  // change folders(). A missing folder counts as empty.
  base::Status mount_over(std::size_t game, const std::filesystem::path& folder);

  // Mounts a file from anywhere on disk under this name, above all files of the game folders. Ignores a name
  // that no lookup can find.
  void mount_file(std::string_view name, const std::filesystem::path& path);
  // Removes a file from view, in whatever game folder it is.
  void hide_file(std::string_view name);

  // Reads a file. A kNotFound error lists the folders that were searched.
  base::Result<base::ByteVector> read(std::string_view name) const;
  // Returns a function that reads the file later, from any thread, even after this object is destroyed.
  std::function<base::Result<base::ByteVector>()> reader(std::string_view name) const;
  bool contains(std::string_view name) const;

  // A file as one game has it.
  struct Layer {
    std::size_t game = 0;     // into folders()
    std::string description;  // as by describe()
    base::Result<base::ByteVector> bytes;
  };
  // Reads the file of each game that has it, id1 first: for files whose contents add up.
  std::vector<Layer> read_layers(std::string_view name) const;

  // Returns the path of the file, or of its archive; empty if there is no such file.
  std::string where(std::string_view name) const;

  // Describes the source of a file in messages: "PATH" for a loose file, "NAME in ARCHIVE", or just the name.
  std::string describe(std::string_view name) const;

  // Returns the index of the file's game in folders() (0 is id1), or nullopt if there is no such file.
  std::optional<std::size_t> find_game(std::string_view name) const;

  // Lists the files with this prefix and suffix, such as list("maps/", ".bsp"): lower case, sorted, without
  // duplicates.
  std::vector<std::string> list(std::string_view prefix, std::string_view suffix) const;

  // The mounted game folders, id1 first.
  std::span<const std::filesystem::path> folders() const { return folders_; }

  // A folder or archive that files are read from.
  struct Source {
    std::filesystem::path path;
    std::size_t game = 0;                     // into folders()
    std::optional<std::size_t> files_inside;  // of an archive
  };
  // All of them in search order, highest priority first.
  std::vector<Source> sources() const { return {sources_.rbegin(), sources_.rend()}; }

 private:
  struct Range {
    std::uint64_t offset = 0, size = 0;
  };
  struct File {
    std::filesystem::path path;                 // of the file, or of its archive
    std::optional<Range> range{};               // place in a PAK
    std::shared_ptr<const formats::Pk3> pk3{};  // archive if it is in a PK3, and the entry
    std::size_t pk3_position = 0;
    std::size_t game = 0;  // into folders_
  };

  // `description`: from describe(), for errors.
  static base::Result<base::ByteVector> read_file(const File& file, const std::string& description);
  base::Status mount_game(const std::filesystem::path& folder);
  base::Status mount_loose_files(const std::filesystem::path& folder, std::size_t game);
  base::Status mount_pak(const std::filesystem::path& path);
  // Mounts a zip file as part of this game.
  base::Status mount_zip(const std::filesystem::path& path, std::size_t game);
  // Mounts a file. It replaces one of the same or a lower game, but not one of a higher game.
  void add_file(std::string_view name, File file);
  // Adds a source above those of its game and of lower games.
  void add_source(Source source);
  const File* find(std::string_view name) const;
  static std::string describe(std::string_view name, const File& file);

  std::vector<std::filesystem::path> folders_;
  std::vector<Source> sources_;                     // lowest priority first
  std::map<std::string, File, std::less<>> files_;  // by normalized name
  // Files that those of higher games hide: by name, then by game.
  std::map<std::string, std::map<std::size_t, File>, std::less<>> hidden_;
  std::uint64_t pk3_bytes_ = 0;
};

}  // namespace temblor::vfs
