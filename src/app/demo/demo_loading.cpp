#include "app/demo/demo_loading.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/files/game_files.h"
#include "base/text.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

constexpr std::string_view kSuffix = ".dem";

bool is_on_disk(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

// Returns an error that suggests demos with similar names.
base::Error make_unknown_demo_error(const vfs::FileSystem& files, const std::string& name,
                                    const std::string& stem) {
  base::Error error = base::error(base::ErrorCode::kNotFound, "no such demo in {}; {}",
                                  files.folders().back().parent_path().string(),
                                  suggest(stem, list_stems(files, "", kSuffix)));
  error.file = name;
  return error;
}

}  // namespace

// The game directories precede the disk, so "demo1" plays the game's demo even if the current directory has a
// demo1.dem.
base::Result<LoadedDemo> load_demo(const GameFolders& folders, const std::string& demo) {
  TRY(vfs::FileSystem files, open_files(folders));
  const bool has_suffix = base::to_lower(demo).ends_with(kSuffix);
  const std::string name = has_suffix ? demo : demo + std::string(kSuffix);
  LoadedDemo loaded{name, {}, assets::Library(std::move(files)), {}};
  const vfs::FileSystem& found_in = loaded.library.files();
  if (found_in.contains(name)) {
    TRY(loaded.bytes, found_in.read(name));
    loaded.name = found_in.describe(name);
  } else if (is_on_disk(name)) {
    TRY(loaded.bytes, vfs::read_disk_file(name));
  } else {
    return make_unknown_demo_error(found_in, name, name.substr(0, name.size() - kSuffix.size()));
  }
  TRY(loaded.look, loaded.library.look());
  return loaded;
}

}  // namespace temblor::app
