#include "app/lab/book/book_figures.h"

#include <algorithm>
#include <utility>

#include "app/bench/samples.h"
#include "app/files/progress.h"
#include "app/files/system.h"

namespace temblor::app {
namespace {

double share_different(const render::FrameBuffer& a, const render::FrameBuffer& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.pixel_count(); ++i)
    different +=
        a.format() == render::PixelFormat::kRgb ? a.rgb()[i] != b.rgb()[i] : a.indexed()[i] != b.indexed()[i];
  return static_cast<double>(different) / static_cast<double>(a.pixel_count());
}

class BookMeasurement {
 public:
  BookMeasurement(std::span<const LabScenes> levels, std::vector<lab::Choice> choices,
                  const BookOptions& options)
      : levels_(levels), options_(options), progress_("techniques") {
    figures_.choices = std::move(choices);
  }

  base::Result<BookFigures> run() {
    const double begin_s = clock_s();
    steps_ = figures_.choices.size() * (2 * levels_.size() + options_.sizes.size());
    for (const LabScenes& level : levels_) {
      TRY_STATUS(measure_level(level));
      TRY_STATUS(measure_views(level));
    }
    for (const FrameSize& size : options_.sizes) TRY_STATUS(measure_size(size));
    if (levels_.front().models() == nullptr) {
      TRY(figures_.engine, measure_engine(levels_, make_measure_options(options_.size)));
    }
    figures_.seconds = clock_s() - begin_s;
    return std::move(figures_);
  }

 private:
  MeasureOptions make_measure_options(FrameSize size) const {
    MeasureOptions measure;
    measure.size = size;
    measure.format = options_.format;
    measure.step_deg = options_.step_deg;
    measure.settings = options_.settings;
    // Rays for each pixel would take minutes.
    constexpr double kLongest_s = 2;
    measure.time_limit_s = kLongest_s;
    return measure;
  }

  base::Status measure_level(const LabScenes& scenes) {
    LevelFigures level{scenes.name(), {}, {}, {}};
    FigureOptions options;
    options.measure = make_measure_options(options_.size);
    options.error_size = {std::max(options_.size.width / 2, 64), std::max(options_.size.height / 2, 48)};
    // Scenes of models take long, and all of them show the same few models.
    options.rounds = scenes.models() != nullptr ? 1 : 2;
    TRY(level.techniques, find_figures(scenes, figures_.choices, options));
    done_ += figures_.choices.size();
    progress_.update(done_, steps_);
    TRY_STATUS(find_pictures(scenes, level));
    figures_.levels.push_back(std::move(level));
    return base::Ok{};
  }

  base::Status find_pictures(const LabScenes& scenes, LevelFigures& io_level) const {
    const assets::Look& look = scenes.look();
    const render::Settings settings = scenes.adapt(options_.settings);
    render::FrameBuffer engine(options_.size.width, options_.size.height, options_.format);
    render::FrameBuffer frame(options_.size.width, options_.size.height, options_.format);
    for (const lab::Choice& choice : figures_.choices) {
      render::Renderer engine_renderer(look.palette, look.colormap), renderer(look.palette, look.colormap);
      renderer.replace_stages(choice.make_stages());
      std::size_t number = 0, most = 0;
      double largest = 0;
      TRY_STATUS(scenes.for_each_picture([&](const render::Scene& scene) {
        engine_renderer.render(scene, settings, engine);
        renderer.render(scene, settings, frame);
        const double share = share_different(frame, engine);
        if (share > largest) {
          largest = share;
          most = number;
        }
        ++number;
      }));
      io_level.picture_scenes.push_back(most);
      io_level.different_shares.push_back(largest);
    }
    return base::Ok{};
  }

  // Each view is drawn once to fill the caches; then the fastest of a few frames counts.
  base::Status measure_views(const LabScenes& scenes) {
    const std::size_t first = figures_.views.size();
    const assets::Look& look = scenes.look();
    const render::Settings settings = scenes.adapt(options_.settings);
    render::FrameBuffer frame(options_.size.width, options_.size.height, options_.format);
    for (const lab::Choice& choice : figures_.choices) {
      render::Renderer renderer(look.palette, look.colormap);
      renderer.replace_stages(choice.make_stages());
      std::size_t view = first;
      TRY_STATUS(scenes.for_each_scene([&](const render::Scene& from_scene) {
        for (const float turn_deg : {0.0f, 180.0f}) {
          render::Scene scene = from_scene;
          // Models stand before the camera.
          if (scenes.models() != nullptr && turn_deg != 0) continue;
          scene.camera.angles_deg.y += turn_deg;
          const render::FrameStats stats = renderer.render(scene, settings, frame);
          constexpr int kFrames = 3;
          double fastest_ms = 1e9;
          for (int i = 0; i < kFrames; ++i)
            fastest_ms = std::min(fastest_ms, time_ms([&] { renderer.render(scene, settings, frame); }));
          if (view == figures_.views.size())
            figures_.views.push_back(
                {double{1} * (scenes.models() != nullptr ? stats.triangles : stats.faces_drawn), {}});
          figures_.views[view++].ms.push_back(fastest_ms);
        }
      }));
      progress_.update(++done_, steps_);
    }
    return base::Ok{};
  }

  base::Status measure_size(FrameSize size) {
    SizeTimes times{size, {}};
    MeasureOptions measure = make_measure_options(size);
    measure.step_deg = 360;  // the plot shows growth, not details
    for (const lab::Choice& choice : figures_.choices) {
      measure.technique = &choice;
      TRY(const Measurement measured, levels_.front().measure(measure));
      times.ms.push_back(measured.frame_ms.p50);
      progress_.update(++done_, steps_);
    }
    figures_.sizes.push_back(std::move(times));
    return base::Ok{};
  }

  std::span<const LabScenes> levels_;
  const BookOptions& options_;
  Progress progress_;
  std::size_t done_ = 0, steps_ = 0;
  BookFigures figures_;
};

}  // namespace

base::Result<BookFigures> measure_book(std::span<const LabScenes> levels, std::vector<lab::Choice> choices,
                                       const BookOptions& options) {
  return BookMeasurement(levels, std::move(choices), options).run();
}

}  // namespace temblor::app
