#include "app/lab/book/write_book.h"

#include <algorithm>

#include "app/files/atomic_write.h"
#include "app/files/system.h"
#include "app/lab/book/book_pages.h"
#include "app/lab/book/school_pages.h"
#include "app/lab/book/space_page.h"
#include "app/lab/lab_picture.h"
#include "lab/registry.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

constexpr FrameSize kPictureSize{640, 400};

// Writes the picture of a technique in the view where it differs most from the engine.
base::Status write_picture(const fs::path& folder, std::span<const LabScenes> levels,
                           const BookFigures& figures, std::size_t technique, const BookOptions& options) {
  const auto found = std::ranges::max_element(
      figures.levels, {}, [&](const LevelFigures& level) { return level.different_shares[technique]; });
  const LabScenes& scenes = levels[static_cast<std::size_t>(found - figures.levels.begin())];
  const assets::Look& look = scenes.look();
  const lab::Choice& choice = figures.choices[technique];
  render::FrameBuffer drawn(kPictureSize.width, kPictureSize.height, options.format);
  render::FrameBuffer engine(kPictureSize.width, kPictureSize.height, options.format);
  std::size_t number = 0;
  TRY_STATUS(scenes.for_each_scene([&](const render::Scene& scene) {
    if (number++ != found->picture_scenes[technique]) return;
    render::Renderer renderer(look.palette, look.colormap);
    renderer.render(scene, options.settings, engine);
    renderer.replace_stages(choice.make_stages());
    renderer.render(scene, options.settings, drawn);
  }));
  return write_lab_picture((folder / picture_file_name(choice.label())).string(), drawn, engine,
                           look.palette);
}

base::Status write_page(const fs::path& path, const std::string& page) {
  return replace_file(path, base::as_bytes(page));
}

}  // namespace

std::vector<lab::Choice> list_book_techniques() {
  std::vector<lab::Choice> choices;
  for (const BookChapter& chapter : list_book_chapters())
    for (const BookEntry& entry : chapter.entries)
      choices.push_back(lab::parse_choice(entry.technique).value());
  return choices;
}

base::Status write_book(const fs::path& folder, std::span<const LabScenes> levels,
                        const BookOptions& options) {
  const std::vector<lab::Choice> techniques = list_book_techniques();
  for (const LabScenes& level : levels) TRY_STATUS(level.check(techniques));
  TRY_STATUS(write_school(folder));
  TRY_STATUS(write_space_page(folder, options.size));
  TRY(const BookFigures figures, measure_book(levels, techniques, options));
  for (std::size_t i = 1; i < figures.choices.size(); ++i)
    TRY_STATUS(write_picture(folder, levels, figures, i, options));
  const BookInput input{figures, options, processor_name()};
  for (const BookChapter& chapter : list_book_chapters())
    TRY_STATUS(write_page(folder / (std::string(chapter.file) + ".html"), make_chapter_page(input, chapter)));
  return write_page(folder / "index.html", make_index_page(input));
}

}  // namespace temblor::app
