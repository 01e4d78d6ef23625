#include "app/compile/level_limits.h"

namespace temblor::app {

std::vector<LevelLimit> list_level_limits(const formats::Bsp& bsp) {
  return {{"models", bsp.models.size(), 256},
          {"planes", bsp.planes.size(), 32767},
          {"vertices", bsp.vertices.size(), 65535},
          {"nodes", bsp.nodes.size(), 32767},
          {"texinfos", bsp.texinfos.size(), 4096},
          {"faces", bsp.faces.size(), 65535},
          {"clipnodes", bsp.clipnodes.size(), 32767},
          {"leaves", bsp.leaves.size(), 8192},
          {"marksurfaces", bsp.marksurfaces.size(), 65535},
          {"edges", bsp.edges.size(), 256000},
          {"surfedges", bsp.surfedges.size(), 512000},
          {"light bytes", bsp.lighting.size(), 1048576},
          {"visibility bytes", bsp.visibility.size(), 1048576}};
}

}  // namespace temblor::app
