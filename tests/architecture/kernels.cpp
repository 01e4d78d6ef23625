#include "architecture/kernels.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace temblor::test {

namespace {

using FilesByPath = std::map<std::string, const SourceFile*>;

bool includes_highway(const SourceFile& file) {
  return std::any_of(file.includes.begin(), file.includes.end(),
                     [](const Include& include) { return include.target.starts_with("hwy/"); });
}

// A kernel file, or a part that several share: Highway's kind of header guard includes it once per target,
// and its code is in the target's own namespace.
bool is_compiled_per_target(const SourceFile& file) {
  const auto contains = [&](std::string_view text) { return file.text.find(text) != std::string::npos; };
  return std::any_of(file.includes.begin(), file.includes.end(),
                     [](const Include& include) { return include.target == "hwy/foreach_target.h"; }) ||
         (contains("== defined(HWY_TARGET_TOGGLE)") && contains("::HWY_NAMESPACE {"));
}

bool may_hold_kernels(std::string_view path) {
  static constexpr std::string_view kKernelFolders[] = {
      "audio/",           "lab/hidden_surfaces/", "lab/models/",       "lab/perspective/",
      "lab/world_light/", "render/color/",        "render/spans/",     "render/surfaces/",
      "render/alias/",    "render/sprites/",      "render/particles/", "render/translucent/",
      "render/screen/"};
  return std::any_of(std::begin(kKernelFolders), std::end(kKernelFolders),
                     [&](std::string_view folder) { return path.starts_with(folder); });
}

// A parameter list followed by a body: ") {", ") const {", ") noexcept {", ") -> T {", or "= [](...)".
bool has_function_body(const SourceFile& file) {
  static const std::regex body(R"(\)\s*(const|noexcept|override|final|->\s*[\w:<>&*]+|\s)*\{)");
  return std::regex_search(file.text, body);
}

bool has_code_for_one_instruction_set(const SourceFile& file) {
  // Few files contain these texts, and a regular expression is slow.
  static constexpr std::string_view kTexts[] = {"_mm", "__AVX", "__SSE", "immintrin", "arm_neon"};
  if (std::none_of(std::begin(kTexts), std::end(kTexts),
                   [&](std::string_view text) { return file.text.find(text) != std::string::npos; }))
    return false;
  static const std::regex code(R"(\b_mm\d*_\w+\(|__AVX|__SSE|\bimmintrin\b|\barm_neon\b)");
  return std::regex_search(file.text, code);
}

// Every header of ours that `file` includes, directly or through other headers.
std::set<const SourceFile*> find_included_headers(const SourceFile& file, const FilesByPath& by_path) {
  std::set<const SourceFile*> seen;
  std::vector<const SourceFile*> open = {&file};
  while (!open.empty()) {
    const SourceFile* next = open.back();
    open.pop_back();
    for (const Include& include : next->includes) {
      const auto found = by_path.find(include.target);
      // A kernel file names itself for Highway, which compiles it once per target.
      if (!include.quoted || found == by_path.end() || found->second == &file) continue;
      if (seen.insert(found->second).second) open.push_back(found->second);
    }
  }
  return seen;
}

}  // namespace

std::vector<std::string> find_kernel_violations(const std::vector<SourceFile>& files) {
  FilesByPath by_path;
  for (const SourceFile& file : files) by_path[file.path] = &file;
  std::map<const SourceFile*, bool> has_body;  // many kernels include the same headers
  const auto has_function_body_once = [&](const SourceFile* header) {
    const auto [entry, is_new] = has_body.emplace(header, false);
    if (is_new) entry->second = has_function_body(*header);
    return entry->second;
  };

  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    if (includes_highway(file) && !may_hold_kernels(file.path))
      violations.push_back(file.path + ": SIMD code outside the kernel folders");
    if (!is_compiled_per_target(file)) {
      if (has_code_for_one_instruction_set(file))
        violations.push_back(file.path + ": code for one instruction set outside a kernel file");
      continue;
    }
    for (const SourceFile* header : find_included_headers(file, by_path))
      if (!is_compiled_per_target(*header) && has_function_body_once(header))
        violations.push_back(file.path + ": includes " + header->path + ", which has function bodies");
  }
  return violations;
}

}  // namespace temblor::test
