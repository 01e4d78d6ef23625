#include "app/compile_command.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>

#include "app/command_line.h"
#include "app/diagnostics.h"
#include "app/game_files.h"
#include "app/progress.h"
#include "app/written_file.h"
#include "artgen/palette.h"
#include "assets/assets.h"
#include "base/text.h"
#include "compiler/compile_level.h"
#include "compiler/make_wad.h"
#include "compiler/prefabs.h"
#include "compiler/wad_paths.h"
#include "formats/lit.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

constexpr const char* kHelpFooter = R"(Examples:
  temblor --basedir quake compile maps/castle.map -o quake/id1/maps/castle.bsp
  temblor compile castle.map --fast
  temblor compile castle.map --wad textures/stone.wad --extra 4

Textures are looked for in --wad, then in what the map's "wad" key names. Without game data the palette is that of
Temblor's own game.)";

base::Result<std::string> read_text(const fs::path& path) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(path));
  return std::string(base::as_text(bytes));
}

// Its bytes live as long as it does.
struct SourceFiles {
  std::vector<std::unique_ptr<base::ByteVector>> bytes;
  std::vector<compiler::TextureSource> sources;

  bool add(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    base::Result<base::ByteVector> read = vfs::read_disk_file(path);
    if (!read.ok()) return false;
    bytes.push_back(std::make_unique<base::ByteVector>(std::move(read).value()));
    sources.push_back({path.filename().string(), *bytes.back()});
    return true;
  }
};

// The PNG files of a folder, in order of their names, as a WAD.
base::Result<base::ByteVector> wad_of_pictures(const fs::path& folder, const formats::Palette& palette) {
  std::error_code failure;
  std::vector<fs::path> paths;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure))
    if (base::to_lower(it->path().extension().string()) == ".png") paths.push_back(it->path());
  if (failure) return base::Error{ErrorCode::kNotFound, "--textures: no such folder", folder.string()};
  std::sort(paths.begin(), paths.end());
  std::vector<base::ByteVector> bytes;
  for (const fs::path& path : paths) {
    TRY(base::ByteVector png, vfs::read_disk_file(path));
    bytes.push_back(std::move(png));
  }
  std::vector<compiler::PngFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i].string(), bytes[i]});
  return compiler::make_wad(files, palette);
}

base::Result<SourceFiles> find_textures(const CompileCommandOptions& options, const formats::Map& map,
                                        const formats::Palette& palette, compiler::Warnings& io_warnings) {
  SourceFiles files;
  if (!options.textures.empty()) {
    TRY(base::ByteVector wad, wad_of_pictures(options.textures, palette));
    files.bytes.push_back(std::make_unique<base::ByteVector>(std::move(wad)));
    files.sources.push_back({options.textures, *files.bytes.back()});
  }
  std::vector<fs::path> folders;
  for (const std::string& wad : options.wads) {
    std::error_code ignored;
    if (fs::is_directory(wad, ignored))
      folders.emplace_back(wad);
    else if (!files.add(wad))
      return base::Error{ErrorCode::kNotFound, "--wad: no such file or folder", wad};
  }
  const std::string_view key =
      map.entities.empty() ? "" : map.entities.front().fields.find("wad").value_or("");
  for (const std::string& entry : compiler::split_wad_key(key)) {
    const auto candidates = compiler::wad_candidates(entry, fs::path(options.map).parent_path(), folders);
    const bool found = std::any_of(candidates.begin(), candidates.end(),
                                   [&](const fs::path& path) { return files.add(path); });
    if (!found)
      io_warnings.push_back({"WAD not found", fmt::format("{} (--wad FOLDER says where to look)", entry)});
  }
  return files;
}

base::Result<formats::Palette> find_palette(const GameFolders& folders) {
  std::error_code ignored;
  if (folders.base_folder.empty() && !fs::is_directory("id1", ignored)) return artgen::make_palette();
  TRY(const vfs::FileSystem files, open_files(folders));
  TRY(const assets::Look look, assets::load_look(files));
  return look.palette;
}

// A progress line for each stage that takes long.
class TerminalWatcher : public compiler::CompileWatcher {
 public:
  void begin_stage(const char* name) override {
    progress_.reset();
    progress_ = std::make_unique<Progress>(name);
  }
  bool progress(std::size_t done, std::size_t total) override {
    progress_->update(done, total);
    return true;
  }
  void finish() { progress_.reset(); }

 private:
  std::unique_ptr<Progress> progress_;
};

// As editors show it: a point a line.
std::string points_text(const compiler::LeakWay& leak) {
  std::string text;
  for (const math::Vec3d& point : leak.points_world)
    text += fmt::format("{:.2f} {:.2f} {:.2f}\n", point.x, point.y, point.z);
  return text;
}

void print_warnings(const compiler::Warnings& warnings) {
  std::map<std::string, std::vector<const compiler::Warning*>> by_kind;
  for (const compiler::Warning& warning : warnings) by_kind[warning.kind].push_back(&warning);
  constexpr std::size_t kMostShown = 3;
  for (const auto& [kind, group] : by_kind) {
    std::string line = fmt::format("{} ({})", kind, group.size());
    for (std::size_t i = 0; i < std::min(group.size(), kMostShown); ++i)
      line += fmt::format("{} {}", i == 0 ? ":" : ";", group[i]->what);
    if (group.size() > kMostShown) line += "; ...";
    print_note(line);
  }
}

void print_summary(const compiler::CompiledLevel& level, const fs::path& out, std::size_t bytes,
                   formats::BspVersion version) {
  struct Count {
    const char* what;
    std::size_t count, classic;
  };
  const formats::Bsp& bsp = level.bsp;
  fmt::print("{}: {} bytes, version {}\n", out.string(), bytes, formats::name_of(version));
  // The limits of the original engine; 0: none that matters.
  for (const Count& c :
       {Count{"models", bsp.models.size(), 256}, Count{"planes", bsp.planes.size(), 32767},
        Count{"vertices", bsp.vertices.size(), 65535}, Count{"nodes", bsp.nodes.size(), 32767},
        Count{"leafs", bsp.leafs.size(), 8192}, Count{"clipnodes", bsp.clipnodes.size(), 32767},
        Count{"faces", bsp.faces.size(), 65535}, Count{"marksurfaces", bsp.marksurfaces.size(), 65535},
        Count{"edges", bsp.edges.size(), 256000}, Count{"textures", bsp.miptexes.size(), 512},
        Count{"light bytes", bsp.lighting.size(), 1048576},
        Count{"visibility bytes", bsp.visibility.size(), 1048576}})
    fmt::print("  {:<18} {:>8} of {}{}\n", c.what, c.count, c.classic,
               c.count > c.classic ? "  over the original's limit" : "");
  fmt::print("  leafs seen on average {:.1f} %\n", level.mean_visible_share * 100);
  for (const compiler::StageTime& time : level.times)
    fmt::print("  {:<18} {:>8.2f} s\n", time.name, time.wall_s);
}

}  // namespace

CLI::App* add_compile_command(CLI::App& program, CompileCommandOptions& io_options) {
  CLI::App* command = program.add_subcommand("compile", "Makes a level of an editor's .map");
  command->add_option("map", io_options.map, "The .map file")->type_name("MAP")->required();
  command->add_option("-o,--output", io_options.out, "The level; else beside the map, .bsp")
      ->type_name("OUT");
  command
      ->add_option("--wad", io_options.wads,
                   "A WAD or .bsp with textures, or a folder of WADs; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--textures", io_options.textures,
                   "A folder of PNG files: textures that come before all others")
      ->type_name("DIR");
  command->add_flag("--fast", io_options.fast, "Rough visibility, light without dirt and bounces");
  command->add_flag("--no-vis", io_options.no_vis, "Leaves visibility out: everything is drawn");
  command->add_flag("--no-light", io_options.no_light, "Leaves light out: everything is bright");
  command->add_flag("--opaque-water", io_options.opaque_water,
                    "Nothing is seen through the surface of water");
  command->add_flag("--build-mips", io_options.built_mips, "Makes the smaller mip levels anew");
  command->add_flag("--bsp2", io_options.bsp2, "Writes BSP2 though the level fits the original's format");
  command->add_option("--extra", io_options.extra, "Samples of a shadow each way: 1, 2 or 4")
      ->type_name("N")
      ->check(CLI::IsMember({1, 2, 4}));
  command->add_option("--bounce", io_options.bounces, "Bounces of light, whatever the map says")
      ->type_name("N")
      ->check(CLI::Range(0, 16));
  command->add_option("--threads", io_options.threads, "Threads; 0: one for each core")
      ->type_name("N")
      ->check(CLI::Range(0, 256));
  command->footer(kHelpFooter);
  return command;
}

base::Status run_compile(const CompileCommandOptions& options, const GameFolders& folders) {
  TRY(const base::ByteVector text, vfs::read_disk_file(options.map));
  TRY(formats::Map read, formats::read_map(base::as_text(text)).with_file(options.map));
  compiler::Warnings warnings;
  TRY(const formats::Map map,
      compiler::expand_prefabs(
          std::move(read), options.map, [](const fs::path& path) { return read_text(path); }, warnings)
          .with_file(options.map));
  TRY(const formats::Palette palette, find_palette(folders));
  TRY(const SourceFiles textures, find_textures(options, map, palette, warnings));
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  base::Jobs jobs(options.threads.value_or(0) == 0 ? cores : *options.threads);

  compiler::CompileOptions how;
  how.visibility = !options.no_vis;
  how.draft.water_is_transparent = !options.opaque_water;
  how.lighting = !options.no_light;
  how.fast_visibility = options.fast;
  how.light.fast = options.fast;
  how.light.extra = options.extra;
  how.light.bounces = options.bounces;
  how.mip_levels = options.built_mips ? compiler::MipLevels::kBuilt : compiler::MipLevels::kFromSource;
  TerminalWatcher watcher;
  base::Result<compiler::CompiledLevel> compiled =
      compiler::compile_level(map, textures.sources, palette, how, jobs, watcher, warnings);
  watcher.finish();
  print_warnings(warnings);
  TRY(const compiler::CompiledLevel level, std::move(compiled).with_file(options.map));

  const fs::path out =
      options.out.empty() ? fs::path(options.map).replace_extension(".bsp") : fs::path(options.out);
  formats::BspVersion version = options.bsp2 ? formats::BspVersion::kBsp2 : formats::BspVersion::k29;
  base::Result<base::ByteVector> bytes = formats::write_bsp(level.bsp, version);
  if (!bytes.ok() && version == formats::BspVersion::k29) {
    version = formats::BspVersion::kBsp2;
    bytes = formats::write_bsp(level.bsp, version);
  }
  TRY(const base::ByteVector bsp_bytes, std::move(bytes).with_file(options.map));
  TRY_STATUS(replace_file(out, bsp_bytes));
  std::error_code ignored;
  const fs::path lit = fs::path(out).replace_extension(".lit"),
                 points = fs::path(out).replace_extension(".pts");
  if (level.lit)
    TRY_STATUS(replace_file(lit, formats::write_lit(*level.lit)));
  else
    fs::remove(lit, ignored);  // of the level as it was
  if (level.leak) {
    const std::string way = points_text(*level.leak);
    TRY_STATUS(replace_file(points, base::as_bytes(way)));
    print_note(fmt::format("the level leaks: entity {} ({}) sees the outside; the way is in {}",
                           level.leak->entity, level.leak->classname, points.string()));
  } else {
    fs::remove(points, ignored);
  }
  print_summary(level, out, bsp_bytes.size(), version);
  return base::Ok{};
}

}  // namespace temblor::app
