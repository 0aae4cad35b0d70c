#include "latticeworld/generation/fidelity/crossing_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/layout/claims/crossings.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/terrain/water/shallow_rivers.h"

namespace latticeworld {
namespace {

template <std::size_t kCount>
bool IsOneOf(const std::string& word, const std::array<std::string_view, kCount>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> WordsOf(std::string_view text) {
  std::string letters = ToLowerAscii(text);
  for (char& letter : letters) {
    if (std::isalpha(static_cast<unsigned char>(letter)) == 0) letter = ' ';
  }
  std::vector<std::string> words;
  for (std::string& word : Split(letters, ' ')) {
    if (!word.empty()) words.push_back(std::move(word));
  }
  return words;
}

// Whether the text has one of the words without a denial right before it.
template <std::size_t kCount>
bool AsksFor(const std::array<std::string_view, kCount>& words, std::string_view instruction) {
  constexpr std::array<std::string_view, 4> kDenials = {"no", "not", "without", "never"};
  constexpr std::array<std::string_view, 3> kBetween = {"a", "any", "the"};
  std::string before;
  for (const std::string& word : WordsOf(instruction)) {
    if (IsOneOf(word, words) && !IsOneOf(before, kDenials)) return true;
    if (!IsOneOf(word, kBetween)) before = word;
  }
  return false;
}

bool HasBridge(const Scene& scene) {
  return !scene.terrain->bridges.empty() ||
         std::any_of(scene.props.begin(), scene.props.end(),
                     [](const Prop& prop) { return prop.kind == PropKind::kBridge; });
}

bool HasFord(const SymbolicLayout& layout) {
  const Grid<Crossing> crossings = CrossingsOf(layout, /*fords=*/true);
  return std::find(crossings.begin(), crossings.end(), Crossing::kFord) != crossings.end();
}

}  // namespace

bool AsksForFords(std::string_view instruction) {
  constexpr std::array<std::string_view, 4> kWords = {"ford", "fords", "forded", "fording"};
  return AsksFor(kWords, instruction);
}

bool AsksForBridges(std::string_view instruction) {
  constexpr std::array<std::string_view, 5> kWords = {"bridge", "bridges", "bridged", "footbridge",
                                                      "footbridges"};
  return AsksFor(kWords, instruction);
}

std::optional<BridgeKind> BridgeKindAskedFor(std::string_view instruction) {
  struct Word {
    std::string_view word;
    BridgeKind kind;
  };
  constexpr std::array<Word, 10> kMaterials = {{{"stone", BridgeKind::kStoneArch},
                                                {"arch", BridgeKind::kStoneArch},
                                                {"arched", BridgeKind::kStoneArch},
                                                {"plank", BridgeKind::kPlank},
                                                {"wooden", BridgeKind::kPlank},
                                                {"timber", BridgeKind::kPlank},
                                                {"girder", BridgeKind::kGirder},
                                                {"steel", BridgeKind::kGirder},
                                                {"iron", BridgeKind::kGirder},
                                                {"concrete", BridgeKind::kGirder}}};
  std::optional<BridgeKind> kind;
  std::string before;
  for (const std::string& word : WordsOf(instruction)) {
    if (word == "bridge" || word == "bridges") {
      for (const Word& material : kMaterials) {
        if (before == material.word) kind = material.kind;
      }
    }
    before = word;
  }
  return kind;
}

bool FordsRivers(std::string_view instruction, double size_m) {
  if (AsksForFords(instruction)) return true;
  return RiversAreShallow(size_m) && !AsksForBridges(instruction);
}

std::vector<std::string> CrossingWarnings(std::string_view instruction,
                                          const SymbolicLayout& layout, const Scene& scene) {
  std::vector<std::string> warnings;
  if (AsksForBridges(instruction) && !HasBridge(scene)) {
    warnings.push_back(
        "a bridge is asked for, and there is none: bridges stand where a road crosses a river or a "
        "lake, and no road of this world does");
  }
  if (AsksForFords(instruction) && !HasFord(layout)) {
    warnings.push_back(
        "a ford is asked for, and there is none: fords are where a road crosses a river of up to "
        "three layout cells, and no road of this world does");
  }
  return warnings;
}

}  // namespace latticeworld
