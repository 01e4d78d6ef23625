#include "formats/levels/bsp.h"

#include <algorithm>

namespace temblor::formats {
namespace {

struct LumpNames {
  const char* lump;
  const char* record;
};
constexpr std::array<LumpNames, kBspLumpCount> kLumpNames{{
    {"entities", "byte"},
    {"planes", "plane"},
    {"textures", "texture"},
    {"vertices", "vertex"},
    {"visibility", "byte"},
    {"nodes", "node"},
    {"texinfo", "texinfo"},
    {"faces", "face"},
    {"lighting", "sample"},
    {"clipnodes", "clipnode"},
    {"leaves", "leaf"},
    {"marksurfaces", "marksurface"},
    {"edges", "edge"},
    {"surfedges", "surfedge"},
    {"models", "model"},
}};

}  // namespace

const char* version_name(BspVersion version) {
  switch (version) {
    case BspVersion::k29:
      return "29";
    case BspVersion::k2Psb:
      return "2PSB";
    case BspVersion::kBsp2:
      return "BSP2";
    case BspVersion::k30:
      return "30";
  }
  return "unknown";
}

const char* lump_name(BspLump lump) {
  return kLumpNames[static_cast<std::size_t>(lump)].lump;
}
const char* record_name(BspLump lump) {
  return kLumpNames[static_cast<std::size_t>(lump)].record;
}

const BspxLump* Bsp::find_bspx(std::string_view name) const {
  const auto found = std::ranges::find(bspx, name, &BspxLump::name);
  return found == bspx.end() ? nullptr : &*found;
}

}  // namespace temblor::formats
