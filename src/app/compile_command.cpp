#include "app/compile_command.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "app/command_line.h"
#include "app/diagnostics.h"
#include "app/game_files.h"
#include "app/progress.h"
#include "app/texture_files.h"
#include "app/written_file.h"
#include "artgen/palette.h"
#include "assets/assets.h"
#include "compiler/compile_level.h"
#include "compiler/prefabs.h"
#include "formats/lit.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHelpFooter = R"(Examples:
  temblor --basedir quake compile maps/castle.map -o quake/id1/maps/castle.bsp
  temblor compile castle.map --fast
  temblor compile castle.map --wad textures/stone.wad --extra 4

Textures are looked for in --wad, then in what the map's "wad" key names. Without game data the palette is that of
Temblor's own game.)";

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
base::ByteVector points_of(const compiler::LeakWay& leak) {
  std::string text;
  for (const math::Vec3d& point : leak.points_world)
    text += fmt::format("{:.2f} {:.2f} {:.2f}\n", point.x, point.y, point.z);
  const base::Bytes bytes = base::as_bytes(text);
  return {bytes.begin(), bytes.end()};
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
  // Beside the limits of the original engine.
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
  if (level.mean_visible_share)
    fmt::print("  leafs seen on average {:.1f} %\n", *level.mean_visible_share * 100);
  for (const compiler::StageTime& time : level.times)
    fmt::print("  {:<18} {:>8.2f} s\n", time.name, time.wall_s);
}

base::Result<std::string> read_text(const fs::path& path) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(path));
  return std::string(base::as_text(bytes));
}

// With the maps in it.
base::Result<formats::Map> read_map_file(const std::string& path, compiler::Warnings& io_warnings) {
  TRY(const std::string text, read_text(path));
  TRY(formats::Map map, formats::read_map(text).with_file(path));
  const auto read = [](const fs::path& prefab) { return read_text(prefab); };
  return compiler::expand_prefabs(std::move(map), path, read, io_warnings).with_file(path);
}

compiler::CompileOptions compile_options(const CompileCommandOptions& options) {
  compiler::CompileOptions how;
  how.visibility = !options.no_vis;
  how.draft.water_is_transparent = !options.opaque_water;
  how.lighting = !options.no_light;
  how.fast_visibility = options.fast;
  how.light.fast = options.fast;
  how.light.extra = options.extra;
  how.light.bounces = options.bounces;
  how.mip_levels = options.built_mips ? compiler::MipLevels::kBuilt : compiler::MipLevels::kFromSource;
  return how;
}

// The file of that ending beside the level: written anew, or gone, so that none is left of the level as it
// was.
base::Status replace_or_remove(const fs::path& path, const std::optional<base::ByteVector>& bytes) {
  if (bytes) return replace_file(path, *bytes);
  std::error_code ignored;
  fs::remove(path, ignored);
  return base::Ok{};
}

base::Status write_level(const compiler::CompiledLevel& level, const CompileCommandOptions& options,
                         const fs::path& out) {
  formats::BspVersion version = options.bsp2 ? formats::BspVersion::kBsp2 : formats::BspVersion::k29;
  base::Result<base::ByteVector> bytes = formats::write_bsp(level.bsp, version);
  if (!bytes.ok() && version == formats::BspVersion::k29) {
    version = formats::BspVersion::kBsp2;
    bytes = formats::write_bsp(level.bsp, version);
  }
  TRY(const base::ByteVector bsp_bytes, std::move(bytes).with_file(options.map));
  TRY_STATUS(replace_file(out, bsp_bytes));
  std::optional<base::ByteVector> lit, points;
  if (level.lit) lit = formats::write_lit(*level.lit);
  if (level.leak) points = points_of(*level.leak);
  TRY_STATUS(replace_or_remove(fs::path(out).replace_extension(".lit"), lit));
  const fs::path points_path = fs::path(out).replace_extension(".pts");
  TRY_STATUS(replace_or_remove(points_path, points));
  if (level.leak)
    print_note(fmt::format(
        "the level leaks, so it has no visibility: entity {} ({}) sees the outside; the way is in {}",
        level.leak->entity, level.leak->classname, points_path.string()));
  print_summary(level, out, bsp_bytes.size(), version);
  return base::Ok{};
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
  compiler::Warnings warnings;
  TRY(const formats::Map map, read_map_file(options.map, warnings));
  TRY(const formats::Palette palette, find_palette(folders));
  TRY(const TextureFiles textures,
      find_textures({options.textures, options.wads}, options.map, map, palette, warnings));
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  base::Jobs jobs(options.threads.value_or(0) == 0 ? cores : *options.threads);
  TerminalWatcher watcher;
  base::Result<compiler::CompiledLevel> compiled = compiler::compile_level(
      map, textures.sources, palette, compile_options(options), jobs, watcher, warnings);
  watcher.finish();
  print_warnings(warnings);
  TRY(const compiler::CompiledLevel level, std::move(compiled).with_file(options.map));
  const fs::path out =
      options.out.empty() ? fs::path(options.map).replace_extension(".bsp") : fs::path(options.out);
  return write_level(level, options, out);
}

}  // namespace temblor::app
