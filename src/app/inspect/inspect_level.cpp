// Levels (.bsp), their colored light (.lit), its directions (.lux), their visibility patches (.vis), and
// their entity text (.ent).
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/bspx/brush_list.h"
#include "formats/bspx/face_normals.h"
#include "formats/bspx/hdr_light.h"
#include "formats/bspx/light_directions.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "formats/levels/lit.h"
#include "formats/levels/vis_patch.h"
#include "world/level.h"

namespace temblor::app {
namespace {

// Returns the number of entities of each class.
Inspection count_classes(const std::vector<formats::Entity>& entities) {
  std::map<std::string, std::size_t> counts;
  for (const formats::Entity& entity : entities)
    ++counts[entity.classname().empty() ? "(no classname)" : std::string(entity.classname())];
  return Inspection(counts);
}

Inspection count_lumps(const formats::Bsp& bsp) {
  return {{"planes", bsp.planes.size()},       {"vertices", bsp.vertices.size()},
          {"edges", bsp.edges.size()},         {"surfedges", bsp.surfedges.size()},
          {"faces", bsp.faces.size()},         {"texinfos", bsp.texinfos.size()},
          {"nodes", bsp.nodes.size()},         {"leaves", bsp.leaves.size()},
          {"clipnodes", bsp.clipnodes.size()}, {"marksurfaces", bsp.marksurfaces.size()},
          {"models", bsp.models.size()},       {"light samples", bsp.lighting.size()},
          {"PVS bytes", bsp.visibility.size()}};
}

Inspection list_textures(const formats::Bsp& bsp) {
  Inspection textures = Inspection::array();
  for (const formats::BspMiptex& miptex : bsp.miptexes)
    if (miptex.present)
      textures.push_back({{"name", miptex.name}, {"width", miptex.width}, {"height", miptex.height}});
  return textures;
}

// Returns the numbers of the light styles that faces use, in ascending order.
Inspection list_styles(const formats::Bsp& bsp) {
  std::set<int> styles;
  for (const formats::BspFace& face : bsp.faces)
    for (const std::uint8_t style : face.styles)
      if (style != world::kNoStyle) styles.insert(style);
  return Inspection(styles);
}

// Lists faults of a level that can still be played.
Inspection find_problems(const formats::Bsp& bsp, const world::Level& level) {
  Inspection problems(level.notes);
  std::set<std::string> missing;
  for (const world::Face& face : level.faces)
    if (level.texture(face.texture).missing) missing.insert(level.texture(face.texture).name);
  for (const std::string& name : missing)
    problems.push_back(fmt::format("texture \"{}\" is missing: drawn as a checkerboard", name));
  if (bsp.visibility.empty()) problems.push_back("no PVS: everything is drawn from everywhere");
  if (bsp.lighting.empty()) problems.push_back("no light: everything is fully bright");
  bool has_start = false;
  for (const formats::Entity& entity : level.entities)
    has_start = has_start || entity.classname().starts_with("info_player_");
  if (!has_start) problems.push_back("no info_player_start: players have nowhere to spawn");
  return problems;
}

// Counts what the lumps of newer engines hold, which the game itself does not use.
void add_bspx_counts(const formats::Bsp& bsp, Inspection& io_result, std::vector<std::string>& io_problems) {
  if (const formats::BspxLump* lump = bsp.find_bspx(formats::kBrushListLump)) {
    if (const auto models = formats::read_brush_list(lump->data); models.ok()) {
      std::size_t brushes = 0;
      for (const formats::ListedModel& model : *models) brushes += model.brushes.size();
      io_result["listed brushes"] = {{"models", models->size()}, {"brushes", brushes}};
    } else {
      io_problems.push_back(models.error().what);
    }
  }
  const auto add = [&](const char* name, const auto& read, const auto& count) {
    if (!read.ok())
      io_problems.push_back(read.error().what);
    else if (count(*read) > 0)
      io_result[name] = count(*read);
  };
  add("HDR light samples", formats::read_hdr_light(bsp), [](const auto& samples) { return samples.size(); });
  add("light directions", formats::read_light_directions(bsp),
      [](const auto& bytes) { return bytes.size() / 3; });
  add("normals of corners", formats::read_face_normals(bsp),
      [](const formats::FaceNormals& normals) { return normals.corners.size(); });
}

}  // namespace

// Besides the format's reader, this runs the checks that the game runs when it loads a level.
base::Result<Inspection> inspect_bsp(base::Bytes bytes) {
  TRY(const formats::Bsp bsp, formats::read_bsp(bytes));
  TRY(const std::shared_ptr<const world::Level> level, world::make_level(bsp, "inspected"));
  Inspection result;
  std::vector<std::string> bspx_problems;
  result["version"] = formats::version_name(bsp.version);
  result["mins"] = make_json(bsp.models[0].mins);
  result["maxs"] = make_json(bsp.models[0].maxs);
  result["visible leaves"] = level->visible_leaf_count;
  result["counts"] = count_lumps(bsp);
  result["light styles"] = list_styles(bsp);
  result["colored light"] = !level->light_rgb.empty();
  // LMSHIFT, DECOUPLED_LM.
  result["faces with light maps of their own"] = level->light_map_grids.size();
  result["BSPX lumps"] = Inspection::array();
  for (const formats::BspxLump& lump : bsp.bspx)
    result["BSPX lumps"].push_back({{"name", lump.name}, {"bytes", lump.data.size()}});
  add_bspx_counts(bsp, result, bspx_problems);
  result["entities"] = count_classes(level->entities);
  result["textures"] = list_textures(bsp);
  result["problems"] = find_problems(bsp, *level);
  for (const std::string& problem : bspx_problems) result["problems"].push_back(problem);
  return result;
}

base::Result<Inspection> inspect_lit(base::Bytes bytes) {
  TRY(const formats::Lit lit, formats::read_lit(bytes));
  return Inspection{{"light samples", lit.samples.size() / 3}, {"problems", Inspection::array()}};
}

// Bytes are rounded, so that the length of a unit vector may differ by 1%.
base::Result<Inspection> inspect_lux(base::Bytes bytes) {
  constexpr float kTolerance = 0.02f;
  TRY(const std::vector<std::uint8_t> samples, formats::read_lux(bytes));
  std::size_t others = 0;
  for (std::size_t i = 0; i + 3 <= samples.size(); i += 3) {
    const float length = glm::length(formats::unpack_direction(std::span(samples).subspan(i).first<3>()));
    others += std::abs(length - 1) > kTolerance ? 1 : 0;
  }
  Inspection problems = Inspection::array();
  if (others > 0) problems.push_back(fmt::format("vectors that are not of length 1: {}", others));
  return Inspection{{"light directions", samples.size() / 3}, {"problems", std::move(problems)}};
}

base::Result<Inspection> inspect_vis(base::Bytes bytes) {
  TRY(const std::vector<formats::VisPatch> patches, formats::read_vis_patches(bytes));
  Inspection levels = Inspection::array();
  for (const formats::VisPatch& patch : patches)
    levels.push_back({{"level", base::printable(patch.level)},
                      {"leaves", patch.leaf_offsets.size()},
                      {"visibility bytes", patch.visibility.size()}});
  return Inspection{{"levels", levels}, {"problems", Inspection::array()}};
}

base::Result<Inspection> inspect_entities(base::Bytes bytes) {
  const auto [entities, first_fault] = formats::read_faulty_entities(base::as_text(bytes));
  Inspection problems = Inspection::array();
  if (!first_fault.empty()) problems.push_back(first_fault);
  if (entities.empty() || entities[0].classname() != "worldspawn")
    problems.push_back("the first entity is not worldspawn");
  return Inspection{{"count", entities.size()}, {"classes", count_classes(entities)}, {"problems", problems}};
}

}  // namespace temblor::app
