#include "app/compile/compile_shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/compile/compile_summary.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "compiler/light/build_light.h"
#include "compiler/vis/build_visibility.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

fs::path shard_path(CompileStage stage, const Shard& shard, const LevelPaths& paths) {
  return fs::path(paths.bsp).replace_extension(
      fmt::format(".{}-{}-of-{}", name_of(stage), shard.number, shard.count));
}

// Whether the file is called what the file of some share would be.
bool is_shard_file(const fs::path& file, CompileStage stage, const LevelPaths& paths) {
  const std::string ending = file.extension().string();  // ".vis-2-of-4"
  const std::string start = fmt::format(".{}-", name_of(stage)), middle = "-of-";
  const std::size_t between = ending.find(middle, start.size());
  if (!ending.starts_with(start) || between == std::string::npos) return false;
  const base::Result<Shard> shard = parse_shard(fmt::format(
      "{}/{}", ending.substr(start.size(), between - start.size()), ending.substr(between + middle.size())));
  return shard.ok() && shard_path(stage, *shard, paths).filename() == file.filename();
}

// Whatever their number: those of a run with another count than the last are found as well, and told apart by
// who reads them.
base::Result<std::vector<fs::path>> find_shards(CompileStage stage, const LevelPaths& paths) {
  const fs::path folder = paths.bsp.has_parent_path() ? paths.bsp.parent_path() : fs::path(".");
  std::vector<fs::path> found;
  std::error_code failure;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure))
    if (is_shard_file(it->path(), stage, paths)) found.push_back(it->path());
  if (failure) return base::Error{base::ErrorCode::kIo, failure.message(), folder.string()};
  std::sort(found.begin(), found.end());
  if (found.empty())
    return base::Error{
        base::ErrorCode::kNotFound,
        fmt::format("no shards to merge: run compile --only {} --shard K/N first", name_of(stage)),
        shard_path(stage, {1, 2}, paths).string()};
  return found;
}

// Says so if it is.
bool visibility_is_finished(CompileSession& session) {
  if (session.build().visibility != compiler::VisibilityKind::kFull) return false;
  fmt::print("{}: visibility is finished\n", session.paths().bsp.string());
  return true;
}

base::Status write_visibility_shard(const Shard& shard, const fs::path& path, CompileSession& io_session) {
  if (visibility_is_finished(io_session)) return base::Ok{};
  Interrupt& interrupt = io_session.interrupt();
  interrupt.hold();
  compiler::VisibilityShard made;
  {
    Progress line("visibility");
    const auto progress = [&](std::size_t done, std::size_t total) {
      line.update(done, total);
      return !interrupt.was_noted();
    };
    made = compiler::make_visibility_shard(io_session.build(), {shard.number - 1, shard.count},
                                           io_session.jobs(), progress);
  }
  const base::Status written = replace_file(path, made.state);
  interrupt.let_go();
  TRY_STATUS(written);
  if (made.end == compiler::VisibilityEnd::kStopped)
    return base::Error{base::ErrorCode::kIo, "stopped; --merge joins what is done of it", path.string()};
  return base::Ok{};
}

// Stops now and then to save what is done, in the file that it goes on from.
base::Status write_light_shard(const Shard& shard, const fs::path& path, CompileSession& io_session) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kSaveEvery{120};
  Interrupt& interrupt = io_session.interrupt();
  const compiler::Build& build = io_session.build();
  Progress line("light");
  compiler::LightShardBytes made;
  if (base::Result<base::ByteVector> begun = vfs::read_disk_file(path); begun.ok())
    made.bytes = std::move(begun).value();
  interrupt.hold();
  while (!made.is_finished) {
    const Clock::time_point start = Clock::now();
    const auto progress = [&](std::size_t done, std::size_t total) {
      line.update(done, total);
      return !interrupt.was_noted() && Clock::now() - start < kSaveEvery;
    };
    const base::ByteVector begun = std::move(made.bytes);
    TRY(made, compiler::light_shard(build.bsp, build.face_keys, io_session.light_options(),
                                    {shard.number - 1, shard.count}, begun, io_session.jobs(), progress));
    TRY_STATUS(replace_file(path, made.bytes));
    if (interrupt.was_noted() && !made.is_finished)
      return base::Error{base::ErrorCode::kIo, "stopped; the same command goes on from here", path.string()};
  }
  interrupt.let_go();
  return base::Ok{};
}

// Of files that do not belong together: the command line is right.
template <typename T>
base::Result<T> as_fault_of_files(base::Result<T> result) {
  if (result.ok() || result.error().code != base::ErrorCode::kUsage) return result;
  base::Error error = result.error();
  error.code = base::ErrorCode::kMalformed;
  return error;
}

base::Status merge(CompileStage stage, std::span<const base::Bytes> shards, CompileSession& io_session) {
  if (stage == CompileStage::kVisibility) {
    TRY(const compiler::MergedVisibility merged,
        as_fault_of_files(compiler::merge_visibility_shards(shards, io_session.build())));
    fmt::print("{}: visibility of {} of {} portals{}\n", io_session.paths().bsp.string(),
               merged.finished_portals, merged.portals,
               merged.finished_portals == merged.portals ? "" : "; run the shards again");
    return base::Ok{};
  }
  compiler::Warnings warnings;
  base::Status merged = compiler::merge_light_shards(shards, io_session.light_options(), io_session.jobs(),
                                                     io_session.build(), warnings);
  print_warnings(warnings);
  return as_fault_of_files(std::move(merged));
}

// Visibility of what leaks is none.
base::Status check_closed(CompileStage stage, const compiler::CompileReport& report,
                          const CompileSession& session) {
  if (stage != CompileStage::kVisibility || !report.leak) return base::Ok{};
  return base::Error{base::ErrorCode::kMalformed,
                     describe_leak(*report.leak) + "; compile --only bsp shows the way",
                     session.paths().bsp.string()};
}

}  // namespace

base::Status run_shard(CompileStage stage, const Shard& shard, CompileSession& io_session) {
  TRY(const compiler::CompileReport report, io_session.run_bsp());
  TRY_STATUS(check_closed(stage, report, io_session));
  const fs::path path = shard_path(stage, shard, io_session.paths());
  if (stage == CompileStage::kVisibility) return write_visibility_shard(shard, path, io_session);
  return write_light_shard(shard, path, io_session);
}

base::Status merge_shards(CompileStage stage, CompileSession& io_session) {
  TRY(const compiler::CompileReport report, io_session.run_bsp());
  TRY_STATUS(check_closed(stage, report, io_session));
  const auto write = [&] { return write_level(io_session.build(), report.leak, io_session.paths(), true); };
  if (stage == CompileStage::kVisibility && visibility_is_finished(io_session)) return write();
  TRY(const std::vector<fs::path> files, find_shards(stage, io_session.paths()));
  std::vector<base::ByteVector> bytes;
  for (const fs::path& file : files) {
    TRY(base::ByteVector shard, vfs::read_disk_file(file));
    bytes.push_back(std::move(shard));
  }
  const std::vector<base::Bytes> shards(bytes.begin(), bytes.end());
  const fs::path all_of_them =
      fs::path(io_session.paths().bsp).replace_extension(fmt::format(".{}-*", name_of(stage)));
  TRY_STATUS(merge(stage, shards, io_session).with_file(all_of_them.string()));
  TRY_STATUS(write());
  std::error_code ignored;  // only now: until here they are all that there is of the work
  for (const fs::path& file : files) fs::remove(file, ignored);
  return base::Ok{};
}

}  // namespace temblor::app
