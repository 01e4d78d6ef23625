// MD3 models.
#include <nlohmann/json.hpp>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/models/md3.h"

namespace temblor::app {

base::Result<Inspection> inspect_md3(base::Bytes bytes) {
  TRY(const formats::Md3 md3, formats::read_md3(bytes));
  Inspection surfaces = Inspection::array(), problems = Inspection::array();
  for (const formats::Md3Surface& surface : md3.surfaces) {
    Inspection shaders = Inspection::array();
    for (const std::string& shader : surface.shaders) shaders.push_back(base::printable(shader));
    surfaces.push_back({{"name", base::printable(surface.name)},
                        {"shaders", shaders},
                        {"vertices", surface.texels.size()},
                        {"triangles", surface.triangles.size()}});
    if (surface.shaders.empty()) problems.push_back("a surface names no skin");
  }
  Inspection frames = Inspection::array();
  for (const formats::Md3Frame& frame : md3.frames)
    frames.push_back({{"name", base::printable(frame.name)},
                      {"mins", make_json(frame.bounds.mins)},
                      {"maxs", make_json(frame.bounds.maxs)}});
  return Inspection{{"flags", md3.flags}, {"surfaces", surfaces}, {"frames", frames}, {"problems", problems}};
}

}  // namespace temblor::app
