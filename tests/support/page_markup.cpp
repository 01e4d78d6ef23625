#include "support/page_markup.h"

#include <regex>
#include <vector>

namespace temblor::test {

// std::regex needs stack memory for each character that it
// matches.
std::string without_pictures(std::string text) {
  const std::string mark = "base64,";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
    at += mark.size();
    text.erase(at, text.find('"', at) - at);
  }
  return text;
}

std::string find_markup_fault(std::string text) {
  text.erase(0, text.find('\n'));  // <!DOCTYPE html>
  text = without_pictures(std::move(text));
  const std::regex tag(R"(<(/?)([a-zA-Z0-9]+)((?: [a-zA-Z:-]+="[^"<]*")*) ?(/?)>)");
  std::vector<std::string> open;
  std::size_t done = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), tag), end; found != end; ++found) {
    const std::string between = text.substr(done, static_cast<std::size_t>(found->position()) - done);
    if (between.find_first_of("<>") != std::string::npos) return "loose markup: " + between.substr(0, 200);
    done = static_cast<std::size_t>(found->position() + found->length());
    const std::string name = (*found)[2];
    if ((*found)[1].length() > 0) {
      if (open.empty() || open.back() != name) return "unexpected end of " + name;
      open.pop_back();
    } else if ((*found)[4].length() == 0) {
      open.push_back(name);
    }
  }
  if (!open.empty()) return "unclosed " + open.back();
  if (text.find_first_of("<>", done) != std::string::npos) return "loose markup at the end";
  const std::regex entity("&(?!(amp|lt|gt|quot);)");
  return std::regex_search(text, entity) ? "loose &" : "";
}

}  // namespace temblor::test
