#include "artgen/scripts/parts.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"

namespace temblor::artgen {
namespace {

// How deeply parts may use other parts; a deeper nesting is a cycle.
constexpr int kMaxDepth = 16;

base::Result<std::string> read_part_name(const ScriptLine& line) {
  Arguments arguments(line);
  std::string name = arguments.text();
  TRY_STATUS(arguments.finish());
  return name;
}

// Records the part that lines come from. Lines of a nested part keep the name of the innermost one.
void mark(std::vector<ScriptLine>& io_lines, const std::string& part) {
  for (ScriptLine& line : io_lines) {
    if (line.part.empty()) line.part = part;
    mark(line.below, part);
  }
}

// A "use" line may stand for several lines, so it is replaced in its parent's list.
base::Result<std::vector<ScriptLine>> expand(const std::vector<ScriptLine>& lines, const Parts& parts,
                                             int depth) {
  std::vector<ScriptLine> expanded;
  for (const ScriptLine& line : lines) {
    if (line.keyword != "use") {
      ScriptLine copy = line;
      TRY(copy.below, expand(line.below, parts, depth));
      expanded.push_back(std::move(copy));
      continue;
    }
    TRY(const std::string name, read_part_name(line));
    const auto part = parts.find(name);
    if (part == parts.end())
      return script_error(line, fmt::format("no part is named '{}'", base::quotable(name)));
    if (depth >= kMaxDepth) return script_error(line, "parts use each other in a circle");
    std::vector<ScriptLine> own = part->second->below;
    mark(own, name);
    TRY(std::vector<ScriptLine> used, expand(own, parts, depth + 1));
    for (ScriptLine& below : used) expanded.push_back(std::move(below));
  }
  return expanded;
}

}  // namespace

base::Status add_part(const ScriptLine& part, Parts& io_parts) {
  TRY(std::string name, read_part_name(part));
  if (!io_parts.emplace(std::move(name), &part).second)
    return script_error(part, "this name is already in use");
  return base::Ok{};
}

base::Result<ScriptLine> expand_parts(const ScriptLine& asset, const Parts& parts) {
  ScriptLine whole = asset;
  TRY(whole.below, expand(asset.below, parts, 0));
  return whole;
}

}  // namespace temblor::artgen
