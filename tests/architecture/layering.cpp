#include "architecture/layering.h"

#include <map>
#include <set>

namespace temblor::test {

namespace {

using Names = std::set<std::string, std::less<>>;
using NamesByName = std::map<std::string, Names, std::less<>>;

// The folders that each folder may include besides itself (docs/architecture.md has a diagram).
NamesByName make_allowed_folders() {
  NamesByName table = {
      {"base", {}},
      {"math", {"base"}},
      {"platform", {"base"}},
      {"command", {"base"}},
      {"formats", {"base", "math"}},
      {"vfs", {"base", "formats"}},
      {"world", {"base", "math", "formats"}},
      {"assets", {"vfs", "world", "formats", "math", "base"}},
      {"rays", {"math", "base"}},
      {"movement", {"world", "math", "base"}},
      {"vm", {"formats", "math", "base"}},
      {"net", {"formats", "platform", "math", "base"}},
      {"render", {"world", "formats", "math", "base"}},
      // Draws on the graphics card; shares the renderer's stages before the pixels.
      {"render_gl", {"render", "world", "formats", "math", "base"}},
      // Finds the right picture without the renderer's stages, by rays.
      {"oracle", {"render", "world", "formats", "math", "base"}},
      {"lab", {"net", "rays", "render", "world", "formats", "math", "base"}},
      {"audio", {"formats", "math", "base"}},
      // Built-in functions of QuakeC that server and client share.
      {"builtins", {"vm", "command", "formats", "math", "base"}},
      {"server",
       {"builtins", "vm", "world", "movement", "net", "assets", "command", "formats", "math", "base"}},
      {"lockstep", {"server", "net", "command", "platform", "assets", "vfs", "vm", "math", "base"}},
      {"client",
       {"net", "world", "movement", "assets", "command", "platform", "render", "audio", "builtins", "vm",
        "formats", "math", "base"}},
      {"compiler", {"rays", "world", "formats", "math", "base"}},
      {"artgen", {"formats", "math", "base"}},
  };
  Names below_host;
  for (const auto& [folder, unused] : table)
    if (folder != "compiler" && folder != "artgen" && folder != "oracle") below_host.insert(folder);
  table["host"] = below_host;
  table["scripted_player"] = below_host;
  table["scripted_player"].erase("lab");
  Names below_app = below_host;
  below_app.insert({"host", "compiler", "artgen", "oracle"});
  table["app"] = below_app;
  return table;
}

const NamesByName& allowed_folders() {
  static const NamesByName table = make_allowed_folders();
  return table;
}

// The stages of render that each stage may include besides itself.
const NamesByName& allowed_stages() {
  static const NamesByName table = {
      {"color", {}},
      {"view", {"color"}},
      {"edges", {"view"}},
      {"surfaces", {"view", "edges", "color"}},
      {"spans", {"view", "edges", "surfaces", "color"}},
      {"alias", {"view", "color"}},
      {"sprites", {"view", "color"}},
      {"particles", {"view", "color"}},
      // One face at a time, after everything opaque.
      {"translucent", {"view", "edges", "surfaces", "spans", "alias", "sprites", "particles", "color"}},
      // The last stage. It may read every stage's result (`--show`), and no stage knows it.
      {"screen", {"view", "edges", "surfaces", "color"}},
      // The list of stages.
      {"frame",
       {"view", "edges", "surfaces", "spans", "alias", "sprites", "particles", "translucent", "screen",
        "color"}},
  };
  return table;
}

// The headers of render's root that a stage may include: what goes into a frame and what comes out.
const Names& frame_headers() {
  static const Names names = {"render/alias_model.h", "render/draw_list.h",    "render/frame_buffer.h",
                              "render/frame_stats.h", "render/mark_picture.h", "render/marks.h",
                              "render/scene.h",       "render/settings.h",     "render/tint.h"};
  return names;
}

// Folders too large for one room: their sub-folders have public headers.
bool has_public_rooms(std::string_view folder) {
  return folder == "formats" || folder == "net" || folder == "client";
}

// "render/edges/scan.h" -> "render", "edges". `room` is empty for a file in the folder's root.
struct Location {
  std::string folder, room;
};
Location locate(std::string_view path) {
  const std::size_t first = path.find('/');
  if (first == std::string_view::npos) return {};
  const std::size_t second = path.find('/', first + 1);
  const std::string_view room =
      second == std::string_view::npos ? "" : path.substr(first + 1, second - first - 1);
  return {std::string(path.substr(0, first)), std::string(room)};
}

std::string check_stage(const Location& from, const Location& to, const std::string& target) {
  if (from.room.empty() || from.room == to.room) return "";
  const auto stage = allowed_stages().find(from.room);
  if (stage == allowed_stages().end()) return "stage '" + from.room + "' is not in the table";
  if (to.room.empty()) {
    if (from.room == "frame" || frame_headers().contains(target)) return "";
    return "render/" + from.room + " may not include a header of the folder above it";
  }
  if (!stage->second.contains(to.room)) return "render/" + from.room + " may not include render/" + to.room;
  return "";
}

// Returns what is wrong with the include, or an empty string.
std::string check_include(const Location& from, const Location& to, const std::string& target) {
  const auto folder = allowed_folders().find(from.folder);
  if (folder == allowed_folders().end()) return "folder '" + from.folder + "' is not in the table";
  if (!allowed_folders().contains(to.folder)) return "is not the full path of a header under src/";
  if (from.folder == to.folder) return from.folder == "render" ? check_stage(from, to, target) : "";
  if (!folder->second.contains(to.folder)) return from.folder + " may not include " + to.folder;
  // The program alone chooses the implementations of platform interfaces.
  const bool is_chosen_by_app = from.folder == "app" && to.folder == "platform";
  // The laboratory and the renderer on the graphics card replace stages of the renderer, and build on the
  // others.
  const bool is_shared_stage = (from.folder == "lab" || from.folder == "render_gl") && to.folder == "render";
  if (!to.room.empty() && !is_chosen_by_app && !is_shared_stage && !has_public_rooms(to.folder))
    return to.folder + "/" + to.room + " is private to " + to.folder;
  return "";
}

}  // namespace

std::vector<std::string> find_layering_violations(const std::vector<SourceFile>& files) {
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    for (const Include& include : file.includes) {
      if (!include.quoted) continue;
      const std::string problem = check_include(locate(file.path), locate(include.target), include.target);
      if (!problem.empty())
        violations.push_back(file.path + ":" + std::to_string(include.line) + ": \"" + include.target +
                             "\": " + problem);
    }
  }
  return violations;
}

std::vector<std::string> find_unused_public_headers(const std::vector<SourceFile>& files) {
  Names included_from_outside;
  for (const SourceFile& file : files)
    for (const Include& include : file.includes)
      if (locate(file.path).folder != locate(include.target).folder)
        included_from_outside.insert(include.target);
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    const Location location = locate(file.path);
    const bool is_root_header = location.room.empty() && file.path.ends_with(".h");
    if (is_root_header && !included_from_outside.contains(file.path))
      violations.push_back(file.path + ": no other folder includes it; move it to a sub-folder");
  }
  return violations;
}

}  // namespace temblor::test
