// Options of `temblor compile`, and the parsers of those that are neither numbers nor names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::app {

enum class CompileStage : std::uint8_t { kBsp, kVisibility, kLight };

// Kinds of detail brushes (compiler/bsp/brushes/brush_class.h), a sum.
enum DetailKind : std::uint8_t {
  kPlainDetail = 1,
  kWallDetail = 2,
  kFenceDetail = 4,
  kIllusionaryDetail = 8,
  kAllDetail = 15,
};

// The part of one process in a stage that several processes share, counted from 1: "2/4".
struct Shard {
  std::uint32_t number = 1, count = 1;
};
constexpr std::uint32_t kMaxShards = 9999;
// Parses "K/N" with 1 <= K <= N <= kMaxShards.
base::Result<Shard> parse_shard(std::string_view text);

// Parses "bsp", "vis", or "light".
base::Result<CompileStage> parse_compile_stage(std::string_view text);
const char* stage_name(CompileStage stage);

// Parses "X,Y,Z", each at least 1.
base::Result<math::Vec3> parse_grid_dist(std::string_view text);

struct CompileCommandOptions {
  // A .map file, or a .bsp to compute visibility and light for.
  std::string source;
  // The level to write; empty: the source with .bsp.
  std::string out;
  // HTML page about the level to write; empty: none.
  std::string report;
  // Folder of PNG files, which precede all other textures; empty: none.
  std::string textures;
  // WADs, levels, and folders, searched before those that the map names.
  std::vector<std::string> wads;
  // The option with which this command line adds such a folder.
  std::string wad_option = "--wad";
  // Run only this stage, and keep what is still valid of the others.
  std::optional<CompileStage> only{};
  // Compute this part of visibility or light, or merge the results of all parts. Both need `only`.
  std::optional<Shard> shard{};
  bool merge = false;
  // Compile again after every change.
  bool watch = false;
  // Neither read nor write a build file.
  bool clean = false;
  // Rough visibility; light without dirt and bounces.
  bool fast = false;
  // Skip the stage.
  bool no_vis = false, no_light = false;
  // Liquids block visibility.
  bool opaque_water = false;
  // Treat liquids as the run that made the portals did, instead of as opaque_water says.
  bool keeps_portals = false;
  // Print neither counts nor times.
  bool quiet = false;
  // Write a portal file (.prt) beside the level.
  bool portals = false;
  // A leak ends the run with an error, after the files that show it are written.
  bool leak_is_error = false;
  // Greatest distance between the points of a leak's path, in units; 0: only its corners.
  double leak_step = 0;
  // Leave out the clip hulls, or the filling of the outside.
  bool no_clip = false, no_fill = false;
  // Longest side of a lit face, in texels.
  std::optional<double> subdivide_texels{};
  // Detail brushes that are left out (a sum of DetailKind); the others count as structure.
  std::uint8_t omitted_detail = 0;
  bool no_detail = false;
  // Compute mip levels instead of using those of the source.
  bool built_mips = false;
  // Write BSP2 even if the level fits version 29.
  bool bsp2 = false;
  // Write 2PSB.
  bool psb2 = false;
  // Write version 30, with the clip hulls and colored light of Half-Life.
  bool hlbsp = false;
  // Light samples in each direction: 1, 2, or 4.
  int extra = 1;
  int soft = 0;  // luxels over which light is averaged
  // 0 to 16; nothing: as the map says.
  std::optional<int> bounces{};
  // Keys of worldspawn that replace those of the map: for all stages, and for light alone.
  std::vector<std::pair<std::string, std::string>> world_keys, light_keys;
  // Directions of a sky dome or a sun's penumbra, at most.
  std::optional<int> sky_rays{};
  // Write a .lit file even if all light is white.
  bool force_lit = false;
  // Texels between light samples on all faces, 1 to 128; nothing: as the map says.
  std::optional<int> luxel_texels{};
  // Units between light samples on all faces, whatever their texture; 0: by texels; nothing: as the map says.
  std::optional<double> units_per_luxel{};
  // Write a light grid; its samples are this many units apart along each axis.
  bool light_grid = false;
  math::Vec3 light_grid_dist{32.0f};
  // Write BSPX lumps for newer engines: all brushes, light without a limit, the normals of faces, and the
  // directions of light (also as a .lux file).
  bool brush_list = false, hdr = false, face_normals = false, directions = false;
  // Nothing or 0: one per core.
  std::optional<int> threads{};
};

}  // namespace temblor::app
