// References from sources and documents to files of this repository: a renamed page must not leave dead links
// behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> find_all(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

// Pages as sources name them: from the root of the repository.
std::vector<std::string> find_pages(const std::string& text) {
  if (text.find("docs/") == std::string::npos) return {};  // a regular expression is slow
  return find_all(text, R"((?:^|[^\w/])(docs/[\w/-]+\.md))");
}

// Targets of Markdown links, relative to the page: no addresses of web sites, and no anchors.
std::vector<std::string> find_links(const std::string& text) {
  return find_all(text, R"(\]\(([^)#:\s]+)(?:#[^)]*)?\))");
}

std::vector<fs::path> files_in(const fs::path& folder, const std::vector<std::string>& extensions) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    for (const std::string& extension : extensions)
      if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  return files;
}

TEST(References, PagesThatSourcesNameExist) {
  std::vector<std::string> missing;
  for (const char* top : {"src", "tests", "bench", "fuzz", "game", "cmake", "tools"})
    for (const fs::path& file :
         files_in(repository_root() / top, {".h", ".cpp", ".qc", ".cmake", ".sh", ".txt", ".md"}))
      for (const std::string& page : find_pages(read_text(file)))
        if (!fs::exists(repository_root() / page) && file.filename() != fs::path(__FILE__).filename())
          missing.push_back(file.filename().string() + ": " + page);
  EXPECT_THAT(missing, IsEmpty());
}

TEST(References, LinksOfPagesResolve) {
  std::vector<fs::path> pages = files_in(repository_root() / "docs", {".md"});
  for (const char* page : {"README.md", "CONTRIBUTING.md", "game/README.md"})
    pages.push_back(repository_root() / page);
  std::vector<std::string> missing;
  for (const fs::path& page : pages)
    for (const std::string& link : find_links(read_text(page)))
      if (!fs::exists(page.parent_path() / link)) missing.push_back(page.filename().string() + ": " + link);
  EXPECT_THAT(missing, IsEmpty());
}

TEST(ReferenceRules, FindPagesAndLinks) {
  EXPECT_THAT(find_pages("// docs/a-b.md has it (docs/c/d.md).\n \"x/docs/e.md\""),
              ElementsAre("docs/a-b.md", "docs/c/d.md"));
  EXPECT_THAT(find_links("[a](b.md), [c](d/e.md#f), [g](https://h.org/i.md), [j](#k), ![l](m.png)"),
              ElementsAre("b.md", "d/e.md", "m.png"));
}

}  // namespace
}  // namespace temblor::test
