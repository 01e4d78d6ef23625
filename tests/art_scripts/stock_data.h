#pragma once
#include <filesystem>

namespace temblor::test {

// True for QuakeC files of classes that only levels of the stock game contain, whose models and sounds are
// not part of the shipped game: its archive has no room for them (docs/performance.md).
inline bool needs_stock_data(const std::filesystem::path& quakec_file) {
  return quakec_file.filename() == "monster_boss.qc";
}

}  // namespace temblor::test
