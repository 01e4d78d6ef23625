#include "architecture/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace temblor::test {

namespace {

using Names = std::set<std::string, std::less<>>;

// Who may include whom, besides itself: the table of docs/architecture.md.
const std::map<std::string, Names, std::less<>>& allowed_folders() {
  static const std::map<std::string, Names, std::less<>> table = [] {
    std::map<std::string, Names, std::less<>> t = {
        {"base", {}},
        {"math", {"base"}},
        {"platform", {"base"}},
        {"command", {"base"}},
        {"formats", {"base", "math"}},
        {"vfs", {"base", "formats"}},
        {"world", {"base", "math", "formats"}},
        {"assets", {"vfs", "world", "formats", "math", "base"}},
        {"movement", {"world", "math", "base"}},
        {"vm", {"formats", "math", "base"}},
        {"net", {"formats", "platform", "math", "base"}},
        {"render", {"world", "formats", "math", "base"}},
        {"audio", {"formats", "math", "base"}},
        {"server", {"vm", "world", "movement", "net", "assets", "command", "formats", "math", "base"}},
        {"client",
         {"net", "world", "movement", "assets", "command", "platform", "render", "audio", "formats", "math",
          "base"}},
        {"compiler", {"world", "formats", "math", "base"}},
        {"artgen", {"formats", "math", "base"}},
    };
    Names below_host;
    for (const auto& [folder, unused] : t)
      if (folder != "compiler" && folder != "artgen") below_host.insert(folder);
    t["host"] = below_host;
    Names all = below_host;
    all.insert({"host", "compiler", "artgen"});
    t["app"] = all;
    return t;
  }();
  return table;
}

// Inside render, from sub-folder to the sub-folders it may include besides itself.
const std::map<std::string, Names, std::less<>>& allowed_stages() {
  static const std::map<std::string, Names, std::less<>> table = {
      {"color", {}},
      {"view", {}},
      {"edges", {"view"}},
      {"surfaces", {"view", "edges", "color"}},
      {"spans", {"view", "edges", "surfaces", "color"}},
      {"models", {"view", "color"}},
      // One face at a time, after everything opaque.
      {"translucent", {"view", "edges", "surfaces", "spans", "models", "color"}},
      // At the end: it may look at what every stage left behind (`--show`), and no stage knows of it.
      {"screen", {"view", "edges", "surfaces", "color"}},
  };
  return table;
}

// "render/edges/scan.h" -> "render", "edges"; the second is empty for a file in the folder's root.
struct Place {
  std::string folder, stage;
};
Place place_of(std::string_view path) {
  const std::size_t first = path.find('/');
  if (first == std::string_view::npos) return {};
  const std::size_t second = path.find('/', first + 1);
  const std::string_view stage =
      second == std::string_view::npos ? "" : path.substr(first + 1, second - first - 1);
  return {std::string(path.substr(0, first)), std::string(stage)};
}

std::string breach_of(const Place& from, const Place& to) {
  const auto folder = allowed_folders().find(from.folder);
  if (folder == allowed_folders().end()) return "folder '" + from.folder + "' is not in the table";
  if (!allowed_folders().contains(to.folder)) return "is not the full path of a header under src/";
  if (from.folder != to.folder) {
    if (!folder->second.contains(to.folder)) return from.folder + " may not include " + to.folder;
    // Implementations of platform interfaces are chosen by the program, and by nobody else.
    const bool chosen_by_app = from.folder == "app" && to.folder == "platform";
    if (!to.stage.empty() && !chosen_by_app)
      return to.folder + "/" + to.stage + " is private to " + to.folder;
    return "";
  }
  if (from.folder != "render" || from.stage.empty() || to.stage.empty() || from.stage == to.stage) return "";
  const auto stage = allowed_stages().find(from.stage);
  if (stage == allowed_stages().end()) return "stage '" + from.stage + "' is not in the table";
  if (!stage->second.contains(to.stage))
    return "render/" + from.stage + " may not include render/" + to.stage;
  return "";
}

std::string at(const SourceFile& file, const Include& include) {
  return file.path + ":" + std::to_string(include.line) + ": \"" + include.target + "\": ";
}

// Line breaks stay, so that line numbers do. String literals with comment marks in them do not occur in
// include lines or function heads, which is all that is looked at.
std::string without_comments(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "//") == 0) {
      i = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
      out.append(static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                     text.begin() + static_cast<std::ptrdiff_t>(end), '\n')),
                 '\n');
      i = end;
    } else {
      out += text[i++];
    }
  }
  return out;
}

bool includes_highway(const SourceFile& file) {
  return std::any_of(file.includes.begin(), file.includes.end(),
                     [](const Include& include) { return include.target.starts_with("hwy/"); });
}

bool is_compiled_per_target(const SourceFile& file) {
  return std::any_of(file.includes.begin(), file.includes.end(),
                     [](const Include& include) { return include.target == "hwy/foreach_target.h"; });
}

bool may_hold_kernels(std::string_view path) {
  const Place place = place_of(path);
  static const Names render_stages = {"color", "spans", "surfaces", "models", "translucent", "screen"};
  return place.folder == "audio" || (place.folder == "render" && render_stages.contains(place.stage));
}

// A parameter list followed by a body: ") {", ") const {", ") noexcept {", ") -> T {", or "= [](...)".
bool has_function_body(const SourceFile& file) {
  static const std::regex body(R"(\)\s*(const|noexcept|override|final|->\s*[\w:<>&*]+|\s)*\{)");
  return std::regex_search(file.text, body);
}

// All headers of ours that `file` draws in, directly or through others.
std::set<const SourceFile*> closure_of(const SourceFile& file,
                                       const std::map<std::string, const SourceFile*>& by_path) {
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

SourceFile parse_source(std::string path, const std::string& text) {
  SourceFile file;
  file.path = std::move(path);
  file.lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  file.text = without_comments(text);
  static const std::regex include_line(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  std::istringstream lines(file.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, include_line))
      file.includes.push_back({number, match[2].str(), match[1].str() == "\""});
  }
  return file;
}

std::vector<SourceFile> read_source_tree(const std::filesystem::path& root) {
  std::vector<SourceFile> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    files.push_back(parse_source(entry.path().lexically_relative(root).generic_string(), text));
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::vector<std::string> layering_breaches(const std::vector<SourceFile>& files) {
  std::vector<std::string> breaches;
  for (const SourceFile& file : files) {
    for (const Include& include : file.includes) {
      if (!include.quoted) continue;
      const std::string breach = breach_of(place_of(file.path), place_of(include.target));
      if (!breach.empty()) breaches.push_back(at(file, include) + breach);
    }
  }
  return breaches;
}

std::vector<std::string> length_breaches(const std::vector<SourceFile>& files, int limit_lines) {
  std::vector<std::string> breaches;
  for (const SourceFile& file : files)
    if (file.lines > limit_lines)
      breaches.push_back(file.path + ": " + std::to_string(file.lines) + " lines, over " +
                         std::to_string(limit_lines));
  return breaches;
}

std::vector<std::string> type_breaches(const std::vector<SourceFile>& files) {
  // By what stands at the left edge, as the formatter lays code out. A namespace's end, and nothing else, has
  // a comment behind it, of which two blanks are left.
  static const std::regex opened(R"(^namespace ?([\w:]*) \{)");
  static const std::regex type(
      R"(^(?:struct|class|union|enum class|enum) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: :.*)? \{)");
  std::map<std::string, std::string> file_of;
  std::vector<std::string> breaches;
  for (const SourceFile& file : files) {
    std::vector<std::string> spaces;
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (line == "}  " && !spaces.empty()) spaces.pop_back();
      if (std::regex_search(line, found, opened)) spaces.push_back(found[1]);
      if (!std::regex_search(line, found, type)) continue;
      std::string name;
      for (const std::string& space : spaces) name += (space.empty() ? file.path : space) + "::";
      const auto [earlier, is_new] = file_of.try_emplace(name + found[1].str(), file.path);
      if (!is_new) breaches.push_back(file.path + ": " + earlier->first + " is also in " + earlier->second);
    }
  }
  return breaches;
}

std::vector<std::string> kernel_breaches(const std::vector<SourceFile>& files) {
  std::map<std::string, const SourceFile*> by_path;
  for (const SourceFile& file : files) by_path[file.path] = &file;
  static const std::regex one_instruction_set(R"(\b_mm\d*_\w+\(|__AVX|__SSE|\bimmintrin\b|\barm_neon\b)");

  std::vector<std::string> breaches;
  for (const SourceFile& file : files) {
    if (includes_highway(file) && !may_hold_kernels(file.path))
      breaches.push_back(file.path + ": vector code outside the folders of kernels");
    if (!is_compiled_per_target(file)) {
      if (std::regex_search(file.text, one_instruction_set))
        breaches.push_back(file.path + ": code for one instruction set outside a kernel file");
      continue;
    }
    for (const SourceFile* header : closure_of(file, by_path))
      if (!is_compiled_per_target(*header) && has_function_body(*header))
        breaches.push_back(file.path + ": draws in " + header->path + ", which has function bodies");
  }
  return breaches;
}

}  // namespace temblor::test
