#include "app/files/picture_file.h"

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "app/files/atomic_write.h"
#include "base/text.h"
#include "formats/images/png.h"
#include "render/present.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr std::size_t kMaxDigits = 9;

base::Error make_picture_name_error(const std::string& pattern) {
  return base::error(ErrorCode::kUsage,
                     "-o {}: the name of a picture must end in .png and may contain one %d or %05d", pattern);
}

// Writes the file in place. Pictures are not replaced atomically, because a sequence may have thousands.
base::Status write_file(const std::string& path, base::Bytes bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) return make_write_error(path, std::generic_category().message(errno), Remedy::kOtherOutput);
  return base::Ok{};
}

}  // namespace

bool is_numbered(const std::string& pattern) {
  return pattern.find('%') != std::string::npos;
}

// Parses the pattern by hand instead of passing it to printf(), because it comes from the command line.
base::Result<std::string> numbered_name(const std::string& pattern, std::size_t number) {
  if (!base::to_lower(pattern).ends_with(".png")) return make_picture_name_error(pattern);
  const std::size_t percent = pattern.find('%');
  if (percent == std::string::npos) return pattern;
  const std::size_t end = pattern.find('d', percent);
  if (end == std::string::npos) return make_picture_name_error(pattern);
  const std::string width_text = pattern.substr(percent + 1, end - percent - 1);
  std::size_t width = 0;
  if (!width_text.empty()) {
    const char* text_end = width_text.data() + width_text.size();
    const auto [parsed_end, failure] = std::from_chars(width_text.data(), text_end, width);
    if (failure != std::errc{} || parsed_end != text_end || width > kMaxDigits)
      return make_picture_name_error(pattern);
  }
  const std::string rest = pattern.substr(end + 1);
  if (is_numbered(rest)) return make_picture_name_error(pattern);
  return fmt::format("{}{:0{}}{}", pattern.substr(0, percent), number, width, rest);
}

base::Status write_picture_file(const std::string& path, const render::FrameBuffer& frame,
                                const formats::Palette& palette) {
  TRY(const base::ByteVector png, frame.format() == render::PixelFormat::kIndexed
                                      ? formats::write_png(frame.indexed(), frame.width(), frame.height(),
                                                           render::shown_palette(frame, palette))
                                      : formats::write_png(frame.rgb(), frame.width(), frame.height()));
  return write_file(path, png);
}

}  // namespace temblor::app
