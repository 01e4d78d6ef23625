// The game's files: folders and archives mounted over one another, looked up by name.
//
// The order, lowest first, a later one hiding an earlier one's file of the same name:
//   game folders: id1, then each game in the order given;
//   in a game folder: its loose files, then pak0.pak, pak1.pak, ... up to the first number that is missing,
//   then its *.pk3 in alphabetical order.
// So archives win over loose files of the same folder, as in the original. What somebody keeps elsewhere for
// a game (mount_over) wins over both.
//
// Names are those of the data: relative, '/' between parts ('\' is taken for '/'), case does not matter.
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

// All *.pk3 together: they are held in memory. One file, wherever it comes from, is at most kMaxFileBytes.
constexpr std::uint64_t kMaxPk3Bytes = std::uint64_t{1} << 30;

// The name as files are looked up by: lower case, '/' between parts. Nothing when it is empty, absolute or
// leads outside ("..").
std::optional<std::string> normalized_name(std::string_view name);

// Folders and archive tables are read once, when they are mounted; files that appear later are not seen.
// Reading is const and may be done from several threads.
class FileSystem {
 public:
  // `games`: names of folders in base_folder, case does not matter; "id1" need not be among them. kNotFound
  // when the base folder, id1 or a game is not there; kUsage for a name that is not a folder's; an archive
  // that is damaged is an error that names it.
  static base::Result<FileSystem> open(const std::filesystem::path& base_folder,
                                       std::span<const std::string> games = {});

  // Loose files of a folder elsewhere, as if they were those of game folder number `game` and its archives
  // did not have them; its folders are still those of open(). A folder that is not there has none.
  base::Status mount_over(std::size_t game, const std::filesystem::path& folder);

  // The file's bytes. kNotFound says which folders were searched.
  base::Result<base::ByteVector> read(std::string_view name) const;
  // Reads it, as read() would, when it is called: by any thread, even when this object is gone.
  std::function<base::Result<base::ByteVector>()> reader(std::string_view name) const;
  bool contains(std::string_view name) const;

  // Where a file comes from: its path on disk, or that of its archive; empty when there is no such file.
  std::string where(std::string_view name) const;

  // The same for a message: "PATH" of a loose file, "NAME in ARCHIVE", or just the name.
  std::string describe(std::string_view name) const;

  // The game folder it comes from: 0 is id1, higher hides lower; nothing when there is no such file.
  std::optional<std::size_t> game_of(std::string_view name) const;

  // All files whose names start and end so, in lower case, sorted, each once: list("maps/", ".bsp").
  std::vector<std::string> list(std::string_view prefix, std::string_view suffix) const;

  // The game folders that are mounted, lowest first.
  std::span<const std::filesystem::path> folders() const { return folders_; }

 private:
  struct Range {
    std::uint64_t offset = 0, size = 0;
  };
  struct File {
    std::filesystem::path path;                 // on disk: the file, or the archive that it is in
    std::optional<Range> range{};               // in a PAK: where
    std::shared_ptr<const formats::Pk3> pk3{};  // in a PK3: which, and its place there
    std::size_t pk3_position = 0;
    std::size_t game = 0;  // into folders_
  };

  // `description` as of describe().
  static base::Result<base::ByteVector> read_file(const File& file, const std::string& description);
  base::Status mount_game(const std::filesystem::path& folder);
  base::Status mount_loose_files(const std::filesystem::path& folder, std::size_t game);
  base::Status mount_pak(const std::filesystem::path& path);
  base::Status mount_pk3(const std::filesystem::path& path);
  // Hides one of the same game, or of a lower one.
  void add_file(std::string_view name, File file);
  const File* find(std::string_view name) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, File, std::less<>> files_;  // by normalized name
  std::uint64_t pk3_bytes_ = 0;
};

}  // namespace temblor::vfs
