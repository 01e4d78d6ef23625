#include "render/frame/render_views.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <tuple>
#include <vector>

#include "render/frame/render_frame.h"
#include "render/frame/resolve_settings.h"

namespace temblor::render {

namespace {

// The surface cache, for several threads. Each use has a number. A use may find blocks that an earlier one
// has reserved, and must not read them before that one has built them. No thread waits before its own blocks
// are built, so none waits forever.
class SharedSurfaces {
 public:
  explicit SharedSurfaces(SurfaceCache& io_cache) : cache_(io_cache) {}

  // The blocks of the requests, all of them built.
  SurfaceBlocks get(const FrameContext& context, const SurfaceRequests& requests,
                    const MarkTables* mark_tables) {
    std::unique_lock lock(mutex_);
    const SurfaceBlocks blocks = reserve_surfaces(context, requests, cache_);
    const std::uint64_t use = ++last_use_;
    if (!blocks.missing.empty()) {
      building_.insert(use);
      lock.unlock();
      build_surfaces(context, blocks, mark_tables);
      lock.lock();
      building_.erase(use);
      built_.notify_all();
    }
    built_.wait(lock, [&] { return building_.empty() || *building_.begin() > use; });
    return blocks;
  }

 private:
  SurfaceCache& cache_;
  std::mutex mutex_;
  std::condition_variable built_;
  std::uint64_t last_use_ = 0;
  std::set<std::uint64_t> building_;
};

void draw_view(const View& view, const Settings& asked, SharedSurfaces& io_surfaces, FrameCaches& io_caches,
               ViewCaches& io_own) {
  const Settings settings = resolve_settings(asked, *view.scene, *view.frame);
  base::Jobs this_thread(1);
  io_own.prepare(io_caches.level, *view.frame);
  const FrameStages stages;
  const FrameContext context{*view.scene,      settings,    view.frame->format(),
                             io_caches.colors, this_thread, io_own.arenas};
  FrameRecord record;
  const SurfaceRequests requests = find_surfaces(context, stages, io_caches.level, *view.frame, record);
  record.surfaces =
      io_surfaces.get(context, requests, io_caches.mark_tables ? &*io_caches.mark_tables : nullptr);
  draw_surfaces(context, stages, io_caches.skybox, io_own, record, *view.frame);
  draw_over_picture(context, record, *view.frame);
}

// Draws views that share a skybox: the caches hold only one.
void draw_group(std::span<const View> views, const Settings& settings, FrameCaches& io_caches) {
  const View& first = views.front();
  if (first.scene->skybox != nullptr)
    io_caches.skybox.update(*first.scene->skybox, first.scene->fog, io_caches.colors, first.frame->format());
  Settings of_one_thread = settings;
  of_one_thread.threads = 1;
  SharedSurfaces surfaces(io_caches.surfaces);
  std::atomic<std::size_t> next = 0;
  io_caches.jobs->parallel_for(static_cast<std::size_t>(settings.threads), [&](std::size_t thread) {
    for (std::size_t i = next++; i < views.size(); i = next++)
      draw_view(views[i], of_one_thread, surfaces, io_caches, io_caches.views[thread]);
  });
}

// Equal for views that can use the same PreparedSkybox: empty sides have the color of the fog.
auto skybox_key(const View& view) {
  const Scene& scene = *view.scene;
  const SkyboxIdentity* identity = scene.skybox != nullptr ? scene.skybox->identity.get() : nullptr;
  const bool has_fog = identity != nullptr && scene.fog.density > 0;
  const math::Vec3 color = has_fog ? scene.fog.color : math::Vec3(0.0f);
  return std::tuple(identity, has_fog, color.x, color.y, color.z);
}

}  // namespace

void render_views(std::span<const View> views, const Settings& asked, FrameCaches& io_caches) {
  if (views.empty()) return;
  Settings settings = asked;
  settings.threads = std::max(1, asked.threads);
  for (const View& view : views) io_caches.prepare(*view.scene, settings);
  const auto threads = static_cast<std::size_t>(settings.threads);
  if (io_caches.views.size() < threads) io_caches.views.resize(threads);
  const View& first = views.front();
  begin_surface_frame({*first.scene, settings, first.frame->format(), io_caches.colors, *io_caches.jobs,
                       io_caches.view.arenas},
                      io_caches.surfaces);
  std::vector<View> sorted(views.begin(), views.end());
  std::ranges::stable_sort(sorted, {}, skybox_key);
  for (std::span<const View> rest = sorted; !rest.empty();) {
    const auto end = std::ranges::upper_bound(rest, skybox_key(rest.front()), {}, skybox_key);
    const auto group = rest.first(static_cast<std::size_t>(end - rest.begin()));
    draw_group(group, settings, io_caches);
    rest = rest.subspan(group.size());
  }
}

}  // namespace temblor::render
