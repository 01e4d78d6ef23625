#include "assets/localization.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/text.h"

namespace temblor::assets {
namespace {

constexpr std::string_view kFilePrefix = "localization/loc_", kFileSuffix = ".txt";

std::string make_file_name(std::string_view language) {
  return fmt::format("{}{}{}", kFilePrefix, base::to_lower(language), kFileSuffix);
}

// Returns nothing for texts that players could not read.
formats::Localization read_layer(const vfs::FileSystem::Layer& layer, std::vector<std::string>& io_notes) {
  const std::string& file = layer.description;
  if (!layer.bytes.ok()) {
    io_notes.push_back(layer.bytes.error().message());
    return {};
  }
  base::Result<formats::ReadLocalization> read =
      formats::read_localization(base::as_text(*layer.bytes)).with_file(file);
  if (!read.ok()) {
    io_notes.push_back(read.error().message());
    return {};
  }
  for (const formats::LocalizationProblem& problem : read->problems)
    io_notes.push_back(fmt::format("{}: line {}: {}", file, problem.line, problem.what));
  if (const std::size_t more = read->problem_count - read->problems.size(); more > 0)
    io_notes.push_back(fmt::format("{}: {} more cannot be read", file, base::counted(more, "line")));
  if (read->unknown_letters > read->localization.texts().size() / 2) {
    io_notes.push_back(
        fmt::format("{}: the game's characters lack the letters of this language: texts stay English", file));
    return {};
  }
  return std::move(read->localization);
}

}  // namespace

std::vector<std::string> list_languages(const vfs::FileSystem& files) {
  std::vector<std::string> languages;
  for (const std::string& file : files.list(kFilePrefix, kFileSuffix))
    languages.push_back(
        file.substr(kFilePrefix.size(), file.size() - kFilePrefix.size() - kFileSuffix.size()));
  return languages;
}

formats::Localization load_localization(const vfs::FileSystem& files, std::string_view language,
                                        std::vector<std::string>& io_notes) {
  const std::string common = make_file_name(kDefaultLanguage), own = make_file_name(language);
  // By game, then English first.
  std::map<std::size_t, std::vector<formats::Localization>> games;
  for (const vfs::FileSystem::Layer& layer : files.read_layers(common))
    games[layer.game].push_back(read_layer(layer, io_notes));
  if (own != common)
    for (const vfs::FileSystem::Layer& layer : files.read_layers(own))
      games[layer.game].push_back(read_layer(layer, io_notes));
  const std::vector<std::string> known = list_languages(files);
  if (own != common && !known.empty() && !files.contains(own))
    io_notes.push_back(fmt::format("there is no language \"{}\" here, only {}: texts stay English",
                                   base::quotable(language), fmt::join(known, ", ")));
  formats::Localization texts;
  for (auto& [game, own_texts] : games)
    for (formats::Localization& more : own_texts) texts.add(std::move(more));
  return texts;
}

}  // namespace temblor::assets
