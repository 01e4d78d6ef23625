// The sources that the architecture tests check: the real ones, read once, and invented ones.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "architecture/source_tree.h"

namespace temblor::test {

// The root of the repository.
inline std::filesystem::path repository_root() {
  return TEMBLOR_SOURCE_DIR;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::string text(std::filesystem::file_size(path), '\0');
  std::ifstream(path, std::ios::binary).read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

// Every source of the engine, with paths relative to src/.
inline const std::vector<SourceFile>& engine_sources() {
  static const std::vector<SourceFile> files = read_source_tree(repository_root() / "src");
  return files;
}

// Makes sources from pairs of path and text.
inline std::vector<SourceFile> invent(const std::vector<std::pair<std::string, std::string>>& path_and_text) {
  std::vector<SourceFile> files;
  for (const auto& [path, text] : path_and_text) files.push_back(parse_source(path, text));
  return files;
}

}  // namespace temblor::test
