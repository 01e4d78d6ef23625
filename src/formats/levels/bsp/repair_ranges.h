// Ranges of records in another array, such as the faces of a node.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace temblor::formats::bsp_file {

// Cuts the ranges [first, first + count) that exceed an array of `size`. If all of them together are still
// longer than the array, cuts each one where the next one begins; an empty range does not count. Returns the
// number of changed records.
template <typename Record>
std::size_t fit_ranges(std::vector<Record>& io_records, std::size_t size, std::uint32_t Record::*first,
                       std::uint32_t Record::*count) {
  std::size_t changed = 0;
  std::uint64_t total = 0;
  std::vector<Record*> by_first;
  for (Record& record : io_records) {
    if (std::uint64_t{record.*first} + record.*count > size) {
      record.*first = static_cast<std::uint32_t>(std::min<std::size_t>(record.*first, size));
      record.*count = static_cast<std::uint32_t>(std::min<std::size_t>(record.*count, size - record.*first));
      ++changed;
    }
    total += record.*count;
    if (record.*count > 0) by_first.push_back(&record);
  }
  if (total <= size) return changed;
  std::ranges::stable_sort(by_first, {}, [&](const Record* record) { return record->*first; });
  for (std::size_t i = 0; i + 1 < by_first.size(); ++i) {
    const std::uint32_t room = by_first[i + 1]->*first - by_first[i]->*first;
    if (by_first[i]->*count <= room) continue;
    by_first[i]->*count = room;
    ++changed;
  }
  return changed;
}

}  // namespace temblor::formats::bsp_file
