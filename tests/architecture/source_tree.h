// The sources as the rules of the house see them: who includes whom, how long files are, what a kernel file
// draws in. Functions return one line for each breach, naming file and line; empty means that the rule holds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace temblor::test {

struct Include {
  int line;            // from 1
  std::string target;  // as written between the quotes or brackets
  bool quoted;         // "ours" rather than <theirs>
};

struct SourceFile {
  std::string path;  // relative to src/, for example "render/edges/edge_table.h"
  int lines = 0;
  std::vector<Include> includes;
  std::string text;  // without comments
};

SourceFile parse_source(std::string path, const std::string& text);

// Every .h and .cpp under `root`, sorted by path.
std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

// A folder includes only what the table of the design allows; sub-folders are private to their folder;
// inside render the stages view, edges, surfaces, spans each include only earlier ones, and none includes
// screen.
std::vector<std::string> layering_breaches(const std::vector<SourceFile>& files);

// No file is longer than `limit_lines`.
std::vector<std::string> length_breaches(const std::vector<SourceFile>& files, int limit_lines);

// No two types of one namespace share a name: in one program the linker would take the functions of either
// for both.
std::vector<std::string> type_breaches(const std::vector<SourceFile>& files);

// Vector code (Highway) only where kernels live, and intrinsics of one instruction set nowhere. Files
// compiled once per instruction set include, directly or not, no function bodies of ours: the linker might
// keep the copy made for a newer CPU.
std::vector<std::string> kernel_breaches(const std::vector<SourceFile>& files);

}  // namespace temblor::test
