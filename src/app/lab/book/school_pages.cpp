#include "app/lab/book/school_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/files/atomic_write.h"
#include "app/files/picture_file.h"
#include "app/html/html.h"
#include "lab/lessons.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;
namespace school = lab::school;

constexpr int kLessonWidth = 640, kLessonHeight = 400;

std::string picture_name(const school::Lesson& lesson) {
  return fmt::format("school-{}.png", lesson.name);
}

std::uint32_t to_pixel(const school::Color& color) {
  const auto channel = [](float value) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
  };
  return 0xff000000u | channel(color.red) << 16 | channel(color.green) << 8 | channel(color.blue);
}

base::Status write_picture(const fs::path& path, const school::Picture& picture) {
  render::FrameBuffer frame(picture.width(), picture.height(), render::PixelFormat::kRgb);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      frame.rgb()[static_cast<std::size_t>(y * picture.width() + x)] = to_pixel(picture.color(x, y));
  return write_picture_file(path.string(), frame, {});
}

std::string make_page() {
  std::string html =
      begin_page("The school", "a { color: var(--bar); }") +
      "<p><a href=\"index.html\">The laboratory's book</a></p>\n<h1>The school</h1>\n"
      "<p>A small renderer, apart from the engine's, in the order in which to learn it. Each lesson "
      "names the function to read, in <code>src/lab/school</code>.</p>\n";
  for (const school::Lesson& lesson : school::list_lessons())
    html += fmt::format(
        "<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n<p class=\"soft\">Read "
        "<code>{}</code> in <code>{}</code>.</p>\n<img class=\"wide\" alt=\"{}\" "
        "src=\"{}\"/>\n</section>\n",
        lesson.name, escape_html(lesson.title), escape_html(lesson.text), lesson.function, lesson.file,
        escape_html(lesson.title), picture_name(lesson));
  return html + "</body>\n</html>\n";
}

}  // namespace

base::Status make_page_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder))
    return make_write_error(folder, failure ? failure.message() : "it is not a folder", Remedy::kOtherOutput);
  return base::Ok{};
}

base::Status write_school(const fs::path& folder) {
  TRY_STATUS(make_page_folder(folder));
  for (const school::Lesson& lesson : school::list_lessons())
    TRY_STATUS(write_picture(folder / picture_name(lesson), lesson.draw(kLessonWidth, kLessonHeight)));
  return replace_file(folder / "school.html", base::as_bytes(make_page()));
}

std::string describe_lessons() {
  std::string text;
  for (const school::Lesson& lesson : school::list_lessons())
    text += fmt::format("{}: {}\n  {}\n  Read {} in src/lab/school/{}.\n", lesson.name, lesson.title,
                        lesson.text, lesson.function, lesson.file);
  return text;
}

}  // namespace temblor::app
