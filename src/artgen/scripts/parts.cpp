#include "artgen/scripts/parts.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr int kDeepest = 16;  // parts that use parts

base::Result<std::string> name_of(const ScriptLine& line) {
  Arguments arguments(line);
  std::string name = arguments.text();
  TRY_STATUS(arguments.finish());
  return name;
}

void mark(std::vector<ScriptLine>& io_lines, const std::string& part) {
  for (ScriptLine& line : io_lines) {
    if (line.part.empty()) line.part = part;
    mark(line.below, part);
  }
}

base::Result<std::vector<ScriptLine>> expand(const std::vector<ScriptLine>& lines, const Parts& parts,
                                             int depth) {
  std::vector<ScriptLine> expanded;
  for (const ScriptLine& line : lines) {
    if (line.word != "use") {
      ScriptLine copy = line;
      TRY(copy.below, expand(line.below, parts, depth));
      expanded.push_back(std::move(copy));
      continue;
    }
    TRY(const std::string name, name_of(line));
    const auto part = parts.find(name);
    if (part == parts.end())
      return script_error(line, fmt::format("there is no part '{}'", base::quotable(name)));
    if (depth >= kDeepest) return script_error(line, "parts use one another in a circle");
    std::vector<ScriptLine> own = part->second->below;
    mark(own, name);
    TRY(std::vector<ScriptLine> used, expand(own, parts, depth + 1));
    for (ScriptLine& below : used) expanded.push_back(std::move(below));
  }
  return expanded;
}

}  // namespace

base::Status add_part(const ScriptLine& part, Parts& io_parts) {
  TRY(std::string name, name_of(part));
  if (!io_parts.emplace(std::move(name), &part).second)
    return script_error(part, "there is another of this name");
  return base::Ok{};
}

base::Result<ScriptLine> with_parts(const ScriptLine& thing, const Parts& parts) {
  ScriptLine whole = thing;
  TRY(whole.below, expand(thing.below, parts, 0));
  return whole;
}

}  // namespace temblor::artgen
