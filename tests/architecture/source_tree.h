// Reads the sources for the architecture tests: paths, lines, includes, and text without comments.
#pragma once

#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

namespace temblor::test {

struct Include {
  int line;            // from 1
  std::string target;  // the path between the quotes or brackets
  bool quoted;         // true for "ours", false for <theirs>
};

struct SourceFile {
  std::string path;  // relative to the root it was read from, for example "render/edges/edge_table.h"
  int lines = 0;
  std::vector<Include> includes;
  std::string text;  // without comments; line numbers are unchanged
};

// True for a character of a C++ name.
inline bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

SourceFile parse_source(std::string path, const std::string& text);

// Returns every .h and .cpp file under `root`, sorted by path.
std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

}  // namespace temblor::test
