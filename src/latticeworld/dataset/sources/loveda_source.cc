#include "latticeworld/dataset/sources/loveda_source.h"

#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/class_picture.h"
#include "latticeworld/dataset/sources/downsample.h"
#include "latticeworld/dataset/sources/source_files.h"
#include "latticeworld/relief/height_map/picture_header.h"

namespace latticeworld {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kImages = "images_png";
constexpr std::string_view kMasks = "masks_png";
constexpr std::string_view kLegalFolders =
    "legal are a folder with Train or Val, one with Urban or Rural, and one with images_png and "
    "masks_png";

// An image with its mask, one of which may be missing.
struct Pair {
  fs::path folder;   // holds images_png and masks_png
  std::string file;  // "1366.png"
};

const PictureLegend& Legend() {
  static const PictureLegend kLegend = [] {
    PictureLegend legend;
    legend.vocabulary = Vocabulary::kSuburb;
    constexpr std::string_view kLetters("\0GBRWDFA", 8);  // by value
    for (std::size_t v = 0; v < kLetters.size(); ++v) {
      const auto grey = static_cast<std::uint8_t>(v);
      legend.entries.push_back({{grey, grey, grey}, kLetters[v]});
    }
    return legend;
  }();
  return kLegend;
}

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool HoldsPairs(const fs::path& folder) {
  return IsFolder(folder / kImages) || IsFolder(folder / kMasks);
}

// Adds what lies in a folder that holds images_png and masks_png.
Status AddPairs(const fs::path& folder, const std::string& prefix, std::vector<Pair>* pairs,
                std::vector<std::string>* names) {
  std::set<std::string> files;
  for (const std::string_view side : {kImages, kMasks}) {
    if (!IsFolder(folder / side)) continue;
    LW_ASSIGN_OR_RETURN(const std::vector<std::string> found, NamesIn(folder / side, ".png"));
    files.insert(found.begin(), found.end());
  }
  for (const std::string& file : files) {
    pairs->push_back({folder, file});
    names->push_back(prefix + SafeName(file.substr(0, file.size() - 4)));
  }
  return Status();
}

// Adds what lies in a folder that holds the domains; false: it holds none of them.
Result<bool> AddDomains(const fs::path& folder, const std::string& prefix, LoveDaScenes scenes,
                        std::vector<Pair>* pairs, std::vector<std::string>* names) {
  bool any = false;
  for (const std::string domain : {"Rural", "Urban"}) {
    if (!HoldsPairs(folder / domain)) continue;
    any = true;
    const LoveDaScenes other = domain == "Rural" ? LoveDaScenes::kUrban : LoveDaScenes::kRural;
    if (scenes == other) continue;
    LW_RETURN_IF_ERROR(
        AddPairs(folder / domain, prefix + ToLowerAscii(domain) + "-", pairs, names));
  }
  return any;
}

// A file of a pair; that it is missing is said of the pair.
Result<std::string> ReadHalf(const Pair& pair, std::string_view side, std::string_view other) {
  const fs::path path = pair.folder / side / pair.file;
  Result<std::string> bytes = ReadSourceFile(path);
  if (!bytes.ok() && bytes.status().code() == StatusCode::kNotFound) {
    return NotFound(path.string() + " is missing; " + (pair.folder / other / pair.file).string() +
                    " is there");
  }
  return bytes;
}

class LoveDaSource final : public InstanceSource {
 public:
  LoveDaSource(std::vector<Pair> pairs, std::vector<std::string> names)
      : pairs_(std::move(pairs)),
        names_(std::move(names)),
        card_{"loveda", "Segmented aerial images of LoveDA, each turned four times",
              "CC-BY-NC-SA-4.0",
              "Wang, Zheng, Ma, Lu and Zhong 2021, \"LoveDA: A Remote Sensing Land-Cover Dataset "
              "for Domain Adaptive Semantic Segmentation\", NeurIPS Datasets and Benchmarks"} {}

  const SourceCard& card() const override { return card_; }
  std::size_t group_count() const override { return pairs_.size(); }
  std::string GroupName(std::size_t index) const override {
    LW_CHECK(index < names_.size(), "there is no such group");
    return names_[index];
  }

  Result<std::vector<Instance>> ReadGroup(std::size_t index) const override {
    LW_CHECK(index < pairs_.size(), "there is no such group");
    const Pair& pair = pairs_[index];
    LW_ASSIGN_OR_RETURN(const std::string mask_bytes, ReadHalf(pair, kMasks, kImages));
    LW_ASSIGN_OR_RETURN(const std::string image_bytes, ReadHalf(pair, kImages, kMasks));
    const std::string mask_name = (pair.folder / kMasks / pair.file).string();
    const std::string image_name = (pair.folder / kImages / pair.file).string();
    LW_ASSIGN_OR_RETURN(const Grid<char> mask, ReadClassPicture(mask_bytes, Legend(), mask_name));
    const auto image = internal::ReadColourPictureHeader(image_bytes, "image");
    if (!image.ok()) return DataLoss(image_name + ": " + image.status().message());
    if (image->width != mask.cols() || image->height != mask.rows()) {
      return InvalidArgument(image_name + " has " + std::to_string(image->width) + " x " +
                             std::to_string(image->height) + " pixels and " + mask_name + " " +
                             std::to_string(mask.cols()) + " x " + std::to_string(mask.rows()) +
                             "; legal is the same size");
    }
    Result<SymbolicLayout> layout = Downsample(mask, Vocabulary::kSuburb);
    if (!layout.ok()) return layout.status().WithContext(mask_name);

    std::vector<Instance> instances(4);
    for (int turns = 0; turns < 4; ++turns) {
      Instance& instance = instances[static_cast<std::size_t>(turns)];
      instance.group = names_[index];
      instance.id = names_[index] + "-r" + std::to_string(90 * turns);
      instance.layout = {Vocabulary::kSuburb, Turned(layout->cells, turns)};
    }
    return instances;
  }

 private:
  const std::vector<Pair> pairs_;
  const std::vector<std::string> names_;  // of the groups
  const SourceCard card_;
};

}  // namespace

Result<std::unique_ptr<InstanceSource>> MakeLoveDaSource(const LoveDaOptions& options) {
  const std::string folder = options.folder.string();
  LW_ASSIGN_OR_RETURN(const std::vector<std::string> inside, NamesIn(options.folder, ""));
  std::vector<Pair> pairs;
  std::vector<std::string> names;
  bool known = HoldsPairs(options.folder);
  if (known) {
    LW_RETURN_IF_ERROR(AddPairs(options.folder, "loveda-", &pairs, &names));
  } else {
    for (const std::string part : {"Train", "Val"}) {
      LW_ASSIGN_OR_RETURN(const bool found,
                          AddDomains(options.folder / part, "loveda-" + ToLowerAscii(part) + "-",
                                     options.scenes, &pairs, &names));
      known = known || found;
    }
    LW_ASSIGN_OR_RETURN(const bool found,
                        AddDomains(options.folder, "loveda-", options.scenes, &pairs, &names));
    known = known || found;
  }
  if (!known) {
    return InvalidArgument(
        folder + " is no LoveDA folder (" +
        (inside.empty() ? "it holds no folders" : "it holds " + Quote(Join(inside, ", "), 200)) +
        "); " + std::string(kLegalFolders));
  }
  if (pairs.empty()) {
    return InvalidArgument(folder + " holds no images of the scenes that are asked for (" +
                           std::string(NameOf(options.scenes)) + "); legal are N.png in " +
                           std::string(kImages) + " and " + std::string(kMasks));
  }
  MakeUnique(&names);
  return std::unique_ptr<InstanceSource>(new LoveDaSource(std::move(pairs), std::move(names)));
}

}  // namespace latticeworld
