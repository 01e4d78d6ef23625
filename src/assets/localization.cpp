#include "assets/localization.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::assets {
namespace {

std::string make_file_name(std::string_view language) {
  return fmt::format("localization/loc_{}.txt", base::to_lower(language));
}

base::Result<formats::ReadLocalization> read_file(const vfs::FileSystem& files, const std::string& name) {
  TRY(const base::ByteVector bytes, files.read(name));
  return formats::read_localization(base::as_text(bytes)).with_file(files.describe(name));
}

formats::Localization load_file(const vfs::FileSystem& files, const std::string& name,
                                std::vector<std::string>& io_notes) {
  base::Result<formats::ReadLocalization> read = read_file(files, name);
  if (!read.ok()) {
    io_notes.push_back(read.error().message());
    return {};
  }
  for (const formats::LocalizationProblem& problem : read->problems)
    io_notes.push_back(fmt::format("{}: line {}: {}", files.describe(name), problem.line, problem.what));
  if (const std::size_t more = read->problem_count - read->problems.size(); more > 0)
    io_notes.push_back(
        fmt::format("{}: {} more cannot be read", files.describe(name), base::counted(more, "line")));
  return std::move(read->localization);
}

}  // namespace

formats::Localization load_localization(const vfs::FileSystem& files, std::string_view language,
                                        std::vector<std::string>& io_notes) {
  const std::string common = make_file_name(kDefaultLanguage), own = make_file_name(language);
  formats::Localization texts;
  if (files.contains(common)) texts = load_file(files, common, io_notes);
  if (own == common) return texts;
  if (files.contains(own))
    texts.add(load_file(files, own, io_notes));
  else if (files.contains(common))
    io_notes.push_back(fmt::format("no {}: texts stay English", base::quotable(own)));
  return texts;
}

}  // namespace temblor::assets
