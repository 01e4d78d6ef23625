#include "formats/archives/archive.h"

namespace temblor::formats {

bool is_contained_name(std::string_view name) {
  for (const char c : name)
    if (c == '\\' || c == ':' || static_cast<unsigned char>(c) < ' ') return false;
  // Check the parts between separators; an empty name has one empty part.
  for (std::size_t begin = 0;;) {
    const std::size_t end = name.find('/', begin);
    const std::string_view part = name.substr(begin, end - begin);
    if (part.empty() || part == "." || part == "..") return false;
    if (end == std::string_view::npos) return true;
    begin = end + 1;
  }
}

}  // namespace temblor::formats
