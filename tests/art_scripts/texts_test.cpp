// Checks the texts of the shipped levels and game code.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::artgen {
namespace {

namespace fs = std::filesystem;

// Returns the first group of each match in the files of a source folder with this extension.
std::vector<std::string> find_texts(std::string_view folder, std::string_view extension,
                                    const std::regex& pattern) {
  std::vector<std::string> texts;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(TEMBLOR_SOURCE_DIR) / folder)) {
    if (entry.path().extension() != extension) continue;
    std::ifstream file(entry.path());
    const std::string source(std::istreambuf_iterator<char>(file), {});
    for (std::sregex_iterator it(source.begin(), source.end(), pattern), end; it != end; ++it)
      texts.push_back((*it)[1]);
  }
  return texts;
}

// Engines break the text in the middle of the screen after 40 letters, also inside a word.
TEST(ShippedTexts, FitTheMiddleOfTheScreen) {
  const std::vector<std::string> messages =
      find_texts("game/maps", ".level", std::regex("message=\"([^\"]*)\""));
  const std::vector<std::string> of_several_lines =
      find_texts("game/quakec", ".qc", std::regex(R"re("([^"]*\\n[^"]+)")re"));
  EXPECT_GT(messages.size(), 20u);
  EXPECT_GT(of_several_lines.size(), 3u);
  std::vector<std::string> texts = messages;
  texts.insert(texts.end(), of_several_lines.begin(), of_several_lines.end());
  for (const std::string& text : texts) {
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find("\\n", begin), text.size());
      EXPECT_LE(end - begin, 40u) << text.substr(begin, end - begin);
      begin = end + 2;
    }
  }
}

}  // namespace
}  // namespace temblor::artgen
