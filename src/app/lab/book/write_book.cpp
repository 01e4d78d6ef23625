#include "app/lab/book/write_book.h"

#include <algorithm>

#include "app/files/atomic_write.h"
#include "app/files/system.h"
#include "app/lab/book/book_pages.h"
#include "app/lab/book/card_page.h"
#include "app/lab/book/school_pages.h"
#include "app/lab/book/space_page.h"
#include "app/lab/book/wire_page.h"
#include "app/lab/errors/light_film.h"
#include "app/lab/errors/visible_distance.h"
#include "app/lab/lab_picture.h"
#include "lab/registry.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

constexpr FrameSize kPictureSize{640, 400}, kFilmSize{320, 200};

// The level with the view where the technique differs most from the engine.
std::size_t find_picture_level(const BookFigures& figures, std::size_t technique) {
  const auto found = std::ranges::max_element(
      figures.levels, {}, [&](const LevelFigures& level) { return level.different_shares[technique]; });
  return static_cast<std::size_t>(found - figures.levels.begin());
}

// Writes the picture of a technique in the view where it differs most from the engine.
base::Status write_picture(const fs::path& folder, std::span<const LabScenes> levels,
                           const BookFigures& figures, std::size_t technique, const BookOptions& options) {
  const std::size_t level = find_picture_level(figures, technique);
  const LabScenes& scenes = levels[level];
  const assets::Look& look = scenes.look();
  const lab::Choice& choice = figures.choices[technique];
  render::FrameBuffer drawn(kPictureSize.width, kPictureSize.height, options.format);
  render::FrameBuffer engine(kPictureSize.width, kPictureSize.height, options.format);
  const render::Settings settings = scenes.adapt(options.settings);
  render::Renderer of_engine(look.palette, look.colormap), of_technique(look.palette, look.colormap);
  of_technique.replace_stages(choice.make_stages());
  std::size_t number = 0;
  TRY_STATUS(scenes.for_each_picture([&](const render::Scene& scene) {
    // Earlier moments count, because techniques may reuse pictures of models.
    if (number++ > figures.levels[level].picture_scenes[technique]) return;
    of_engine.render(scene, settings, engine);
    of_technique.render(scene, settings, drawn);
  }));
  return write_lab_picture((folder / picture_file_name(choice.label())).string(), drawn, engine,
                           look.palette);
}

base::Status write_pictures(const fs::path& folder, std::span<const LabScenes> levels,
                            const BookFigures& figures, const BookOptions& options) {
  for (std::size_t i = 1; i < figures.choices.size(); ++i)
    TRY_STATUS(write_picture(folder, levels, figures, i, options));
  return base::Ok{};
}

// A film of the view in which the technique's picture is taken.
base::Status write_film(const fs::path& folder, std::span<const LabScenes> levels, const BookFigures& figures,
                        std::string_view label, const BookOptions& options) {
  const auto choice = std::ranges::find(figures.choices, label, &lab::Choice::label);
  const auto technique = static_cast<std::size_t>(choice - figures.choices.begin());
  const std::size_t level = find_picture_level(figures, technique);
  std::size_t number = 0;
  base::Result<base::ByteVector> film{base::ByteVector()};
  TRY_STATUS(levels[level].for_each_picture([&](const render::Scene& scene) {
    if (number++ == figures.levels[level].picture_scenes[technique])
      film = make_light_film(*choice, scene, levels[level].adapt(options.settings), kFilmSize);
  }));
  TRY(const base::ByteVector bytes, std::move(film));
  return replace_file(folder / film_file_name(label), bytes);
}

base::Status write_films(const fs::path& folder, std::span<const LabScenes> levels,
                         const BookFigures& figures, const BookOptions& options) {
  for (const BookChapter& chapter : list_book_chapters())
    for (const BookEntry& entry : chapter.entries)
      if (entry.has_film) TRY_STATUS(write_film(folder, levels, figures, entry.technique, options));
  return base::Ok{};
}

// The engine, and the techniques that draw models, or those that draw the world.
std::vector<lab::Choice> choose_techniques(bool of_models) {
  std::vector<lab::Choice> choices = list_book_techniques();
  std::erase_if(choices, [&](const lab::Choice& choice) {
    const bool is_engine = choice.technique == &lab::list_techniques().front();
    return !is_engine && choice.technique->draws_models != of_models;
  });
  return choices;
}

ModelGrid measure_grid(const LabScenes& scenes, std::span<const lab::Choice> choices,
                       const BookOptions& options) {
  GridOptions grid = options.grid;
  grid.size = options.size;
  grid.format = options.format;
  grid.settings = options.settings;
  return measure_model_grid(scenes, choices, grid);
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

std::vector<CrowdOptions> list_book_crowds() {
  const auto crowd = [](int count, double distance) {
    CrowdOptions options;
    options.count = count;
    options.distance = distance;
    return options;
  };
  return {crowd(1, 30), crowd(10, 100), crowd(100, 300), crowd(100, 1000)};
}

base::Status write_book(const fs::path& folder, std::span<const LabScenes> levels,
                        std::span<const LabScenes> model_scenes, const WireResults& wire,
                        const BookOptions& options) {
  const std::vector<lab::Choice> techniques = choose_techniques(false), of_models = choose_techniques(true);
  for (const LabScenes& level : levels) TRY_STATUS(level.check(techniques));
  for (const LabScenes& scenes : model_scenes) TRY_STATUS(scenes.check(of_models));
  TRY_STATUS(write_school(folder));
  TRY_STATUS(write_space_page(folder, options.size));
  TRY_STATUS(write_wire_page(folder, wire));
  TRY_STATUS(write_card_page(folder, levels.front(), options.card, options.settings));
  TRY(BookFigures figures, measure_book(levels, techniques, options));
  figures.wire = wire;
  TRY(BookFigures model_figures, measure_book(model_scenes, of_models, options));
  model_figures.grid = measure_grid(model_scenes.front(), of_models, options);
  model_figures.visible_distance_units = find_visible_distance(model_scenes.front(), options.settings);
  TRY_STATUS(write_pictures(folder, levels, figures, options));
  TRY_STATUS(write_pictures(folder, model_scenes, model_figures, options));
  TRY_STATUS(write_films(folder, levels, figures, options));
  const BookInput input{figures, options, processor_name(), &model_figures};
  for (const BookChapter& chapter : list_book_chapters())
    TRY_STATUS(write_page(folder / (std::string(chapter.file) + ".html"), make_chapter_page(input, chapter)));
  return write_page(folder / "index.html", make_index_page(input));
}

}  // namespace temblor::app
