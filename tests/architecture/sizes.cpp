#include "architecture/sizes.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <sstream>

namespace temblor::test {

namespace {

// The number of parameters between the parenthesis at `open` and its partner, and the position behind the
// partner. Commas inside brackets and template arguments do not separate parameters.
struct ParameterList {
  int count = 0;
  std::size_t end = std::string::npos;
};
ParameterList count_parameters(const std::string& text, std::size_t open) {
  int depth = 0, commas = 0;
  bool is_empty = true;
  for (std::size_t i = open; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ';' && depth <= 1) return {};
    if (c == '(' || c == '<' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == '>' || c == ']' || c == '}') --depth;
    if (depth == 0) return {is_empty ? 0 : commas + 1, i + 1};
    if (i > open && std::isspace(static_cast<unsigned char>(c)) == 0) is_empty = false;
    if (depth == 1 && c == ',') ++commas;
  }
  return {};
}

// Whether the text before a parenthesis is "TYPE NAME", as in a declaration, and not "NAME" alone, as in a
// call.
bool follows_a_type(const std::string& text, std::size_t name_begin) {
  std::size_t i = name_begin;
  while (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\n')) --i;
  if (i == name_begin || i == 0) return false;
  const char before = text[i - 1];
  if (before == '>' || before == '&' || before == '*') return true;
  if (!is_name_character(before)) return false;
  std::size_t begin = i;
  while (begin > 0 && is_name_character(text[begin - 1])) --begin;
  const std::string word = text.substr(begin, i - begin);
  return word != "return" && word != "else" && word != "case" && word != "new" && word != "throw";
}

bool is_declaration_end(const std::string& text, std::size_t end) {
  static const std::regex ending(
      R"(^\s*(const|noexcept|override|final|\s)*(;|\{|->|:|= (0|default|delete)))");
  return std::regex_search(text.begin() + static_cast<std::ptrdiff_t>(end),
                           text.begin() + static_cast<std::ptrdiff_t>(std::min(end + 80, text.size())),
                           ending);
}

}  // namespace

std::vector<std::string> find_long_files(const std::vector<SourceFile>& files, int max_lines) {
  std::vector<std::string> violations;
  for (const SourceFile& file : files)
    if (file.lines > max_lines)
      violations.push_back(file.path + ": " + std::to_string(file.lines) + " lines, over " +
                           std::to_string(max_lines));
  return violations;
}

std::vector<std::string> find_crowded_folders(const std::vector<std::string>& paths, int max_files) {
  std::map<std::string, int> count_by_folder;
  for (const std::string& path : paths) ++count_by_folder[path.substr(0, path.find_last_of('/'))];
  std::vector<std::string> violations;
  for (const auto& [folder, count] : count_by_folder)
    if (count > max_files)
      violations.push_back(folder + ": " + std::to_string(count) + " files, over " +
                           std::to_string(max_files));
  return violations;
}

std::vector<std::string> find_long_parameter_lists(const std::vector<SourceFile>& files, int max_parameters) {
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    for (std::size_t open = file.text.find('('); open != std::string::npos;
         open = file.text.find('(', open + 1)) {
      std::size_t name_begin = open;
      while (name_begin > 0 &&
             (is_name_character(file.text[name_begin - 1]) || file.text[name_begin - 1] == ':'))
        --name_begin;
      if (name_begin == open || !follows_a_type(file.text, name_begin)) continue;
      const ParameterList list = count_parameters(file.text, open);
      if (list.count <= max_parameters || !is_declaration_end(file.text, list.end)) continue;
      const auto line =
          std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(open), '\n') + 1;
      violations.push_back(
          file.path + ":" + std::to_string(line) + ": " + file.text.substr(name_begin, open - name_begin) +
          " has " + std::to_string(list.count) + " parameters, over " + std::to_string(max_parameters));
    }
  }
  return violations;
}

std::vector<std::string> find_duplicate_types(const std::vector<SourceFile>& files) {
  // Relies on the formatter: definitions start at the left edge, and only the end of a namespace has a
  // comment behind it, which leaves two spaces.
  static const std::regex opened(R"(^namespace ?([\w:]*) \{)");
  static const std::regex type(
      R"(^(?:struct|class|union|enum class|enum) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: :.*)? \{)");
  std::map<std::string, std::string> file_by_type;
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    std::vector<std::string> namespaces;
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (line == "}  " && !namespaces.empty()) namespaces.pop_back();
      if (std::regex_search(line, found, opened)) namespaces.push_back(found[1]);
      if (!std::regex_search(line, found, type)) continue;
      std::string name;
      for (const std::string& space : namespaces) name += (space.empty() ? file.path : space) + "::";
      const auto [earlier, is_new] = file_by_type.try_emplace(name + found[1].str(), file.path);
      if (!is_new) violations.push_back(file.path + ": " + earlier->first + " is also in " + earlier->second);
    }
  }
  return violations;
}

}  // namespace temblor::test
