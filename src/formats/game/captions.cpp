#include "formats/game/captions.h"

#include <algorithm>

#include "base/text.h"

namespace temblor::formats {
namespace {

constexpr std::string_view kCaptionBlanks = " \t\r", kSilent = "-";
constexpr std::size_t kMaxBadLines = 20, kMaxSoundChars = 128;

std::string_view trim_blanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kCaptionBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kCaptionBlanks) + 1 - begin);
}

}  // namespace

Captions read_captions(std::string_view text) {
  Captions captions;
  for (std::size_t number = 1; !text.empty() && captions.texts.size() < kMaxCaptions; ++number) {
    const std::string_view line = trim_blanks(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    if (line.empty() || line.starts_with("//")) continue;
    const std::size_t end = std::min(line.find_first_of(kCaptionBlanks), line.size());
    // Cut first, so that a caption reads the same after it is written.
    const std::string_view caption = trim_blanks(trim_blanks(line.substr(end)).substr(0, kMaxCaptionChars));
    if (caption.empty() || end > kMaxSoundChars) {
      if (captions.bad_lines.size() < kMaxBadLines) captions.bad_lines.push_back(number);
      continue;
    }
    captions.texts.insert_or_assign(base::to_lower(line.substr(0, end)),
                                    caption == kSilent ? "" : base::printable(caption));
  }
  return captions;
}

std::string format_caption_line(std::string_view sound, std::string_view caption) {
  std::string line(sound);
  line += ' ';
  line += caption.empty() ? kSilent : caption;
  return line + '\n';
}

}  // namespace temblor::formats
