#include "app/stock_tools/stock_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace temblor::app {
namespace {

namespace fs = std::filesystem;
using V = FlagValues;
using Words = FlagWords;
using Command = StockCommand;

double to_number(const std::string& word) {
  return parse_flag_number(word).value_or(0);
}

int to_whole(const std::string& word, int least, int most) {
  return static_cast<int>(std::clamp(to_number(word), double(least), double(most)));
}

// A folder of WADs that does not exist is no error for the stock tools.
void add_wad_place(Words values, Command& io_command) {
  std::error_code failure;
  if (fs::exists(values[0], failure))
    io_command.options.wads.push_back(values[0]);
  else
    io_command.notes.push_back(fmt::format("{}: no such folder; it is not searched for WADs", values[0]));
}

// The stock tools also take the folder id1 itself.
void set_base_folder(Words values, Command& io_command) {
  std::error_code failure;
  fs::path folder = values[0];
  if (!folder.has_filename()) folder = folder.parent_path();
  if (folder.filename() == "id1") folder = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  if (fs::is_directory(folder / "id1", failure))
    io_command.folders.base_folder = folder.string();
  else
    io_command.notes.push_back(fmt::format("-basedir {} has no id1; it is ignored", values[0]));
}

void omit(Command& io_command, std::uint8_t kinds) {
  io_command.options.omitted_detail |= kinds;
}

void write_brush_list(Words, Command& io_command) {
  io_command.options.brush_list = true;
}
void write_brush_list_and_hulls(Words, Command& io_command) {
  io_command.options.brush_list = true;
  io_command.notes.emplace_back("the level keeps its clip hulls beside BRUSHLIST");
}

// Luxels are 16 texels wide at a scale of 1.
void set_light_map_scale(Words values, Command& io_command) {
  constexpr double kTexels = 16;
  const double exponent = std::round(std::log2(std::clamp(to_number(values[0]) * kTexels, 1.0, 128.0)));
  const auto texels = static_cast<int>(std::exp2(exponent));
  io_command.options.luxel_texels = texels;
  if (texels != to_number(values[0]) * kTexels)
    io_command.notes.push_back(fmt::format("-lmscale {}: {} is used", values[0], texels / kTexels));
}

void set_directions(Words, Command& io_command) {
  io_command.options.directions = true;
}

constexpr const char* kNoQuake2 = "Temblor does not write levels of Quake II and Hexen II";
constexpr const char* kNoDebug = "Temblor writes no such debug output";
constexpr const char* kSounds = "leaves get all ambient sounds";

constexpr StockFlag kCommonFlags[] = {
    {"basedir", V::kText, set_base_folder},
    {"defaultpaths"},
    {"filepriority", V::kText},
    {"gamedir", V::kText,
     [](Words values, Command& io) { io.folders.games.push_back(fs::path(values[0]).filename().string()); }},
    {"h", V::kNone, [](Words, Command& io) { io.wants_help = true; }},
    {"help", V::kNone, [](Words, Command& io) { io.wants_help = true; }},
    {"log"},
    {"lowpriority", V::kOptionalNumber},
    {"nocolor"},
    {"nodefaultpaths"},
    {"nolog"},
    {"nopercent"},
    {"noprogress"},
    {"nostat", V::kNone, [](Words, Command& io) { io.options.quiet = true; }},
    {"noverbose", V::kNone, [](Words, Command& io) { io.options.quiet = true; }},
    {"path", V::kText, add_wad_place},
    {"q2rtx", V::kNone, nullptr, kNoQuake2, true},
    {"quiet", V::kNone, [](Words, Command& io) { io.options.quiet = true; }},
    {"threads", V::kNumber, [](Words v, Command& io) { io.options.threads = to_whole(v[0], 0, 256); }},
    {"v"},
    {"verbose"},
    {"vv"},
};

constexpr StockFlag kQbspFlags[] = {
    {"2psb", V::kNone, [](Words, Command& io) { io.options.psb2 = true; }},
    {"add", V::kText, nullptr, "use a misc_external_map (docs/mapping.md)", true},
    {"aliasdef", V::kText, nullptr, "Temblor has no alias definitions", true},
    {"allowupgrade"},
    {"bmodelcontents", V::kNone, nullptr, "brush entities are solid"},
    {"bsp2", V::kNone, [](Words, Command& io) { io.options.bsp2 = true; }},
    {"bspleak", V::kNone, nullptr, "the path of a leak is in the .pts file"},
    {"bspx", V::kNone, write_brush_list},
    {"bspxonly", V::kNone, write_brush_list_and_hulls},
    {"chop"},
    {"chopfragment"},
    {"contenthack", V::kNone, nullptr, "overlapping brushes are always cut"},
    {"convert", V::kText, nullptr, "Temblor does not convert maps", true},
    {"debugbspbrushes", V::kNone, nullptr, kNoDebug},
    {"debugchop", V::kNone, nullptr, kNoDebug},
    {"debugleafvolumes", V::kNone, nullptr, kNoDebug},
    {"debugleak", V::kNone, nullptr, kNoDebug},
    {"epsilon", V::kNumber},
    {"filldetail", V::kOptionalNumber},
    {"filltype", V::kText},
    {"forcegoodtree"},
    {"forceprt1", V::kNone, nullptr, "the .prt file is PRT2 if the map has detail"},
    {"hexen2", V::kNone, nullptr, kNoQuake2, true},
    {"hlbsp", V::kNone, [](Words, Command& io) { io.options.hlbsp = true; }},
    {"includeskip", V::kNone, nullptr, "faces with the texture skip are left out"},
    {"keepprt"},
    {"leakdist", V::kNumber,
     [](Words v, Command& io) { io.options.leak_step = std::max(0.0, to_number(v[0])); }},
    {"leaktest", V::kNone, [](Words, Command& io) { io.options.leak_is_error = true; }},
    {"litwater", V::kOptionalNumber,
     [](Words v, Command& io) { io.options.world_keys.emplace_back("litwater", v[0]); }},
    {"lmscale", V::kNumber, nullptr, "give -lmscale to light instead"},
    {"logbmodels"},
    {"loghulls"},
    {"maxedges", V::kNumber, nullptr, "faces are split at 60 edges"},
    {"maxnodesize", V::kNumber},
    {"microvolume", V::kNumber},
    {"midsplitbrushfraction", V::kNumber},
    {"midsplitsurffraction", V::kNumber},
    {"missing_textures_as_zero_size", V::kNone, nullptr, "missing textures are checkerboards"},
    {"noallowupgrade", V::kNone, nullptr, "a level that is too large for version 29 becomes BSP2"},
    {"nochop", V::kNone, nullptr, "overlapping brushes are always cut"},
    {"noclip", V::kNone, [](Words, Command& io) { io.options.no_clip = true; }},
    {"nodetail", V::kNone, [](Words, Command& io) { io.options.no_detail = true; }},
    {"noedgereuse", V::kNone, nullptr, "edges are shared"},
    {"noextendedsurfflags"},
    {"nofill", V::kNone, [](Words, Command& io) { io.options.no_fill = true; }},
    {"nomerge", V::kNone, nullptr, "faces are merged"},
    {"nomergeacrossliquids", V::kNone, nullptr, "faces are merged"},
    {"nooldaxis", V::kNone, nullptr, "standard alignment is that of the original qbsp"},
    {"noskip", V::kNone, nullptr, "faces with the texture skip are left out"},
    {"nosoftware"},
    {"nosubdivide", V::kNone, nullptr, "faces are cut at 240 texels, which engines need"},
    {"notex", V::kNone, nullptr, "textures are written"},
    {"notjunc", V::kNone, nullptr, "T-junctions are repaired"},
    {"notranswater", V::kNone, [](Words, Command& io) { io.options.opaque_water = true; }},
    {"notriggermodels", V::kNone, nullptr, "triggers are models"},
    {"objexport", V::kNone, nullptr, kNoDebug},
    {"oldaxis"},
    {"oldleak", V::kNone, nullptr, "give -leakdist the distance between the points of a leak's path"},
    {"oldrottex"},
    {"omitdetail", V::kNone, [](Words, Command& io) { omit(io, kAllDetail); }},
    {"omitdetailfence", V::kNone, [](Words, Command& io) { omit(io, kFenceDetail); }},
    {"omitdetailillusionary", V::kNone, [](Words, Command& io) { omit(io, kIllusionaryDetail); }},
    {"omitdetailwall", V::kNone, [](Words, Command& io) { omit(io, kWallDetail); }},
    {"onlyents", V::kNone, nullptr, "entities alone are updated whenever the brushes are unchanged"},
    {"outsidedebug", V::kNone, nullptr, kNoDebug},
    {"prt"},
    {"q2bsp", V::kNone, nullptr, kNoQuake2, true},
    {"qbism", V::kNone, nullptr, kNoQuake2, true},
    {"software"},
    {"splitsky"},
    {"splitspecial"},
    {"splitturb", V::kOptionalNumber,
     [](Words v, Command& io) { io.options.world_keys.emplace_back("litwater", v[0]); }},
    {"subdivide", V::kNumber,
     [](Words v, Command& io) {
       constexpr double kLeast = 16, kMost = 240;
       io.options.subdivide_texels = std::clamp(to_number(v[0]), kLeast, kMost);
       if (to_number(v[0]) > kMost || to_number(v[0]) < kLeast)
         io.notes.push_back(
             fmt::format("-subdivide {}: {} texels are used", v[0], *io.options.subdivide_texels));
     }},
    {"texturedefs", V::kText, nullptr, "Temblor has no texture definitions", true},
    {"tjunc", V::kText},
    {"transsky", V::kNone, nullptr, "sky blocks sight"},
    {"transwater"},
    {"wadpath", V::kText, add_wad_place},
    {"worldextent", V::kNumber},
    {"wrbrushes", V::kNone, write_brush_list},
    {"wrbrushesonly", V::kNone, write_brush_list_and_hulls},
    {"xwadpath", V::kText, add_wad_place},
};

constexpr StockFlag kVisFlags[] = {
    {"fast", V::kNone, [](Words, Command& io) { io.options.fast = true; }},
    {"level", V::kNumber},
    {"noambient", V::kNone, nullptr, kSounds},
    {"noambientlava", V::kNone, nullptr, kSounds},
    {"noambientsky", V::kNone, nullptr, kSounds},
    {"noambientslime", V::kNone, nullptr, kSounds},
    {"noambientwater", V::kNone, nullptr, kSounds},
    {"noautoclean"},
    {"nostate"},
    {"phsonly", V::kNone, nullptr, kNoQuake2, true},
    {"visdist", V::kNumber, nullptr, "places are visible at any distance"},
};

constexpr StockFlag kLightFlags[] = {
    {"addmin", V::kNone, [](Words, Command& io) { io.options.light_keys.emplace_back("addmin", "1"); }},
    {"arghradcompat", V::kNone, nullptr, "keys of ArghRad are not read"},
    {"bounce", V::kOptionalNumber, [](Words v, Command& io) { io.options.bounces = to_whole(v[0], 0, 16); }},
    {"bouncedebug", V::kNone, nullptr, kNoDebug, true},
    {"bouncelightsdebug", V::kNone, nullptr, kNoDebug, true},
    {"bspx", V::kNone, set_directions},
    {"bspxlit"},
    {"bspxlux", V::kNone, set_directions},
    {"bspxonly", V::kNone, set_directions},
    {"debugface", V::kThreeNumbers, nullptr, kNoDebug},
    {"debugmottle", V::kNone, nullptr, kNoDebug, true},
    {"debugneighbours", V::kNone, nullptr, kNoDebug, true},
    {"debugoccluded", V::kNone, nullptr, kNoDebug, true},
    {"debugvert", V::kThreeNumbers, nullptr, kNoDebug},
    {"dirtdebug", V::kNone, nullptr, kNoDebug, true},
    {"emissivequality", V::kText},
    {"exportobj", V::kNone, nullptr, kNoDebug},
    {"extra", V::kNone, [](Words, Command& io) { io.options.extra = 2; }},
    {"extra4", V::kNone, [](Words, Command& io) { io.options.extra = 4; }},
    {"facestyles", V::kNumber, nullptr, "faces have at most 4 styles"},
    {"fast", V::kNone, [](Words, Command& io) { io.options.fast = true; }},
    {"gate", V::kNumber},
    {"highlightseams", V::kNone, nullptr, kNoDebug, true},
    {"lightgrid", V::kNone, [](Words, Command& io) { io.options.light_grid = true; }},
    {"lightgrid_dist", V::kThreeNumbers,
     [](Words v, Command& io) {
       for (int axis = 0; axis < 3; ++axis)
         io.options.light_grid_dist[axis] =
             static_cast<float>(std::max(1.0, to_number(v[static_cast<std::size_t>(axis)])));
     }},
    {"lightgrid_format", V::kText},
    {"lit", V::kNone, [](Words, Command& io) { io.options.force_lit = true; }},
    {"lit2", V::kNone, nullptr, "Temblor writes .lit files of version 1"},
    {"litonly", V::kNone, nullptr, "light is always written to the level, too", true},
    {"lmscale", V::kNumber, set_light_map_scale},
    {"lmshift", V::kNumber,
     [](Words v, Command& io) { io.options.luxel_texels = 1 << to_whole(v[0], 0, 7); }},
    {"lux", V::kNone, set_directions},
    {"nolighting", V::kNone, nullptr, "use `temblor compile --no-light`", true},
    {"nolights", V::kNone, nullptr, "lights are never left out", true},
    {"novanilla", V::kNone, nullptr, "gray light is written, too"},
    {"novisapprox"},
    {"onlyents", V::kNone, nullptr, "the light is brought up to date; it stays if nothing has changed"},
    {"parse_escape_sequences", V::kNone, nullptr, "values are written as they are"},
    {"phongdebug", V::kNone, nullptr, kNoDebug, true},
    {"phongdebug_obj", V::kNone, nullptr, kNoDebug},
    {"radlights", V::kText, nullptr, "use lights with the key _surface", true},
    {"soft", V::kOptionalNumber, [](Words v, Command& io) { io.options.soft = to_whole(v[0], 0, 16); }},
    {"sunsamples", V::kNumber, [](Words v, Command& io) { io.options.sky_rays = to_whole(v[0], 1, 4096); }},
    {"surflight_dump", V::kNone, nullptr, kNoDebug},
    {"surflight_subdivide", V::kNumber, nullptr, "surface lights are 128 units apart"},
    {"visapprox", V::kText},
    {"world_units_per_luxel", V::kNumber,
     [](Words v, Command& io) { io.options.units_per_luxel = std::clamp(to_number(v[0]), 0.0, 1024.0); }},
    {"wrnormals", V::kNone, [](Words, Command& io) { io.options.face_normals = true; }},
};

}  // namespace

std::optional<double> parse_flag_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [after, code] = std::from_chars(word.data(), end, number);
  return code == std::errc{} && after == end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::span<const StockFlag> list_tool_flags(StockTool tool) {
  switch (tool) {
    case StockTool::kQbsp:
      return kQbspFlags;
    case StockTool::kVis:
      return kVisFlags;
    case StockTool::kLight:
      return kLightFlags;
  }
  return {};
}

std::span<const StockFlag> list_common_flags() {
  return kCommonFlags;
}

}  // namespace temblor::app
