// Captions of sounds for players who cannot hear them: captions.txt of a game directory, written by `temblor
// art`. Text, a sound per line:
//
//   // a comment
//   dog/dattack1.wav dog snarls      a file below "sound/", and what a player would hear
//   misc/null.wav -                  no caption: silence
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::formats {

constexpr std::size_t kMaxCaptions = 8192, kMaxCaptionChars = 32;

struct Captions {
  // By sound, in lower case. An empty caption: the sound is silent.
  std::map<std::string, std::string, std::less<>> texts;
  // The numbers of lines without a caption, counted from 1; at most 20.
  std::vector<std::size_t> bad_lines;
};

// Captions are printable ASCII; longer ones are cut, and later lines of the same sound count.
Captions read_captions(std::string_view text);

// A line of the file.
std::string format_caption_line(std::string_view sound, std::string_view caption);

}  // namespace temblor::formats
