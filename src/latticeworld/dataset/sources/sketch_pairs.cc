#include "latticeworld/dataset/sources/sketch_pairs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "latticeworld/common/files.h"
#include "latticeworld/common/folder_lock.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/writing/instance_images.h"
#include "latticeworld/dataset/writing/whole_file.h"
#include "latticeworld/relief/sketch/eroded_land.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "pairs";
constexpr char kManifest[] = "pairs.json";
constexpr char kLockName[] = "pairs.lock";
constexpr double kFewestStrokes = 0.005;  // share of the cells
constexpr double kMostStrokes = 0.04;
constexpr int kAtATime = 64;  // pairs between two looks at whether somebody cancelled

std::string NameOf(std::size_t index) {
  char name[32];
  std::snprintf(name, sizeof(name), "%06zu", index);
  return name;
}

std::string ManifestOf(const SketchPairOptions& options) {
  const nlohmann::ordered_json manifest = {
      {"format", 1}, {"seed", options.seed}, {"side", options.side}};
  return manifest.dump() + "\n";
}

// Pairs may be written there: it is not there, empty, or begun with the same options.
Status CheckFolder(const SketchPairOptions& options, const fs::path& out) {
  std::error_code error;
  if (!fs::exists(out, error)) return Status();
  if (fs::exists(out / kManifest, error)) {
    LW_ASSIGN_OR_RETURN(const std::string was, ReadFile(out / kManifest, 1 << 16));
    if (was == ManifestOf(options)) return Status();
    return InvalidArgument(Quote(out.string()) + " was begun with " + Quote(was, 200) +
                           " and cannot go on with " + Quote(ManifestOf(options)));
  }
  const fs::directory_iterator entries(out, error);
  if (error) return FailedPrecondition(Quote(out.string()) + ": " + error.message());
  for (const fs::directory_entry& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (FolderLock::Owns(kLockName, name) || name == kManifest + std::string(kUnfinished)) continue;
    return FailedPrecondition(Quote(out.string()) + " holds " + Quote(name) +
                              " and no pairs.json; legal is an empty folder or one of pairs");
  }
  return Status();
}

Status WritePair(const SketchPairOptions& options, std::size_t index, const fs::path& height_file,
                 const fs::path& sketch_file) {
  const std::uint64_t seed = StreamSeed(options.seed, "pair " + std::to_string(index));
  RandomStream random(seed, "sketch_share");
  const double share = kFewestStrokes * std::pow(kMostStrokes / kFewestStrokes, random.Uniform());
  const Grid<float> land = ErodedLand(options.side, seed, 1);
  LW_ASSIGN_OR_RETURN(const InstanceImages images, DrawImages(land, share));
  LW_RETURN_IF_ERROR(WriteWholeFile(height_file, images.height_png));
  return WriteWholeFile(sketch_file, images.sketch_png);
}

}  // namespace

std::vector<Violation> Validate(const SketchPairOptions& options) {
  std::vector<Violation> violations;
  CheckRange("count", static_cast<double>(options.count), {1.0, 1e6}, " pairs", &violations);
  CheckRange("side", options.side, {64, 1024}, " samples", &violations);
  CheckRange("threads", options.threads, {0, 256}, "", &violations);
  return violations;
}

Result<std::size_t> WriteSketchPairs(const SketchPairOptions& options, const fs::path& out,
                                     const Progress& progress) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal sketch pair options", Validate(options)));
  LW_RETURN_IF_ERROR(CheckFolder(options, out));
  LW_RETURN_IF_ERROR(MakeDirectories(out));
  LW_ASSIGN_OR_RETURN(const FolderLock folder_lock, FolderLock::Take(out / kLockName));
  LW_RETURN_IF_ERROR(CheckFolder(options, out));  // another process may have begun it meanwhile
  LW_RETURN_IF_ERROR(WriteWholeFile(out / kManifest, ManifestOf(options)));
  std::atomic<std::size_t> made{0};
  std::mutex mutex;
  Status failure;
  for (std::size_t begin = 0; begin < options.count; begin += kAtATime) {
    progress.Report(kStage, static_cast<double>(begin) / static_cast<double>(options.count));
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    const int count = static_cast<int>(std::min<std::size_t>(kAtATime, options.count - begin));
    ParallelFor(count, options.threads, [&](int from, int to) {
      for (int i = from; i < to && !progress.cancelled(); ++i) {
        const std::string name = NameOf(begin + static_cast<std::size_t>(i));
        const fs::path height_file = out / (name + "_height.png");
        const fs::path sketch_file = out / (name + "_sketch.png");
        std::error_code error;
        if (fs::exists(height_file, error) && fs::exists(sketch_file, error)) continue;
        const Status status =
            WritePair(options, begin + static_cast<std::size_t>(i), height_file, sketch_file);
        if (status.ok()) {
          ++made;
          continue;
        }
        const std::lock_guard<std::mutex> lock(mutex);
        failure = status;
        return;
      }
    });
    LW_RETURN_IF_ERROR(failure);
  }
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  progress.Report(kStage, 1.0);
  return made.load();
}

}  // namespace latticeworld
