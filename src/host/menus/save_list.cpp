#include "host/menus/save_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <system_error>

namespace temblor::host {
namespace {

// Texts as comments store them: within the columns, and with spaces for line ends and underscores.
std::string fit_into_comment(std::string_view text) {
  std::string fitted(text.substr(0, client::kMaxSaveTitle));
  std::replace_if(
      fitted.begin(), fitted.end(), [](char c) { return c == '_' || c == '\n'; }, ' ');
  while (fitted.ends_with(' ')) fitted.pop_back();
  return fitted;
}

}  // namespace

client::MenuSave describe_save(const formats::Sav& sav, const std::string& level_title) {
  client::MenuSave save;
  save.level_title = level_title;
  save.skill = sav.skill;
  save.time_s = double{sav.time_s};
  const std::string text = fit_into_comment(sav.comment);
  if (level_title.empty())
    save.level_title = text;
  else if (text != fit_into_comment(level_title))
    save.title = text;
  if (const std::size_t kills = sav.comment.find("kills:", client::kMaxSaveTitle);
      kills != std::string::npos) {
    save.kills = std::atoi(sav.comment.c_str() + kills + 6);
    if (const std::size_t slash = sav.comment.find('/', kills); slash != std::string::npos)
      save.monsters = std::atoi(sav.comment.c_str() + slash + 1);
  }
  return save;
}

std::string format_date(const std::filesystem::path& file) {
  std::error_code failure;
  const std::filesystem::file_time_type changed = std::filesystem::last_write_time(file, failure);
  if (failure) return {};
  const auto since_epoch = std::chrono::file_clock::to_sys(changed).time_since_epoch();
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(since_epoch).count();
  std::tm date{};
  if (localtime_r(&seconds, &date) == nullptr) return {};
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday,
                     date.tm_hour, date.tm_min);
}

}  // namespace temblor::host
