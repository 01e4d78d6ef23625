#include "artgen/parts.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr int kDeepest = 16;  // parts that use parts

base::Result<std::string> name_of(const RecipeLine& line) {
  Arguments arguments(line);
  std::string name = arguments.text();
  TRY_STATUS(arguments.finish());
  return name;
}

void mark(std::vector<RecipeLine>& io_lines, const std::string& part) {
  for (RecipeLine& line : io_lines) {
    if (line.part.empty()) line.part = part;
    mark(line.below, part);
  }
}

base::Result<std::vector<RecipeLine>> expand(const std::vector<RecipeLine>& lines, const Parts& parts,
                                             int depth) {
  std::vector<RecipeLine> expanded;
  for (const RecipeLine& line : lines) {
    if (line.word != "use") {
      RecipeLine copy = line;
      TRY(copy.below, expand(line.below, parts, depth));
      expanded.push_back(std::move(copy));
      continue;
    }
    TRY(const std::string name, name_of(line));
    const auto part = parts.find(name);
    if (part == parts.end())
      return recipe_error(line, fmt::format("there is no part '{}'", base::quotable(name)));
    if (depth >= kDeepest) return recipe_error(line, "parts use one another in a circle");
    std::vector<RecipeLine> own = part->second->below;
    mark(own, name);
    TRY(std::vector<RecipeLine> used, expand(own, parts, depth + 1));
    for (RecipeLine& below : used) expanded.push_back(std::move(below));
  }
  return expanded;
}

}  // namespace

base::Status add_part(const RecipeLine& part, Parts& io_parts) {
  TRY(std::string name, name_of(part));
  if (!io_parts.emplace(std::move(name), &part).second)
    return recipe_error(part, "there is another of this name");
  return base::Ok{};
}

base::Result<RecipeLine> with_parts(const RecipeLine& thing, const Parts& parts) {
  RecipeLine whole = thing;
  TRY(whole.below, expand(thing.below, parts, 0));
  return whole;
}

}  // namespace temblor::artgen
