#include "latticeworld/language/share_words.h"

#include <cstddef>
#include <string_view>

namespace latticeworld {
namespace {

constexpr std::string_view kSeparator = ", ";

// Phrases of one amount, with kSeparator between them.
struct AmountPhrases {
  ShareAmount amount;
  std::string_view phrases;
};

constexpr AmountPhrases kAmounts[] = {
    {{1.0, 0.9, 1.0}, "all of, the whole of, the entirety of"},
    {{0.85, 0.75, 1.0, true},
     "almost all, nearly all, virtually all, practically all, almost all of, nearly all of, "
     "virtually all of, practically all of, just about all of, just about all, the vast "
     "majority of, almost everything, nearly everything, almost the whole, nearly the whole, "
     "almost the entire, nearly the entire, a vast majority of, well nigh all of, close to all "
     "of, almost the whole of, nearly the whole of"},
    {{0.65, 0.45, 1.0, true},
     "most of, the majority of, the bulk of, a majority of, the better part of, the greater "
     "part of, the greatest part of, the lions share of, the lion share of, the larger part "
     "of, the largest part of, the main part of, the biggest part of, the major part of, the "
     "best part of, the most part of, the larger share of, the better half of, the larger half "
     "of, the largest share of, the major portion of, the bigger part of, the greater portion "
     "of, the largest portion of"},
    {{0.65, 0.5, 1.0, true}, "more than half of, more than half, over half of, over half"},
    {{0.35, 0.2, 1.0},
     "much of, a large part of, a good part of, a great deal of, a large portion of, a big "
     "part of, a big chunk of, a large chunk of, a good deal of, a considerable part of, a "
     "large share of, a good chunk of, a large area of, a large swathe of, a large proportion "
     "of, a good portion of, large parts of, big parts of, wide parts of, a great part of, "
     "large portions of, a huge part of, a huge chunk of, a substantial part of, a sizeable "
     "part of, large swathes of, a sizable part of, a significant part of, a big portion of, a "
     "vast area of"},
    {{0.25, 0.12, 1.0, false, true},
     "lots of, a lot of, plenty of, loads of, tons of, heaps of, masses of, an abundance of, a "
     "wealth of, an ample amount of, a large amount of, large amounts of, a great amount of, "
     "oodles of"},
    {{0.08, kLeastShareThere, 0.25, false, true}, "a little"},
    {{0.08, kLeastShareThere, 0.25},
     "a bit of, a little bit of, a touch of, a hint of, a dash of, a trace of, a small part "
     "of, a small portion of, a small amount of, a small share of, a small bit of, a small "
     "area of, a spot of, a smidgen of, a minor part of, small amounts of, small parts of, a "
     "pinch of, a small fraction of, a small chunk of, a minority of, a modest amount of, bits "
     "of"},
    {{0.04, kLeastShareThere, 0.12},
     "a sliver of, a scrap of, a tiny bit of, a tiny part of, a tiny portion of, a tiny amount "
     "of, slivers of, a shred of, a mere sliver of, a thin sliver of, a narrow sliver of, a "
     "tiny fraction of"},
    {{0.03, 0.0, 0.08},
     "hardly any, barely any, scarcely any, next to no, almost no, very little, nearly no, "
     "practically no, virtually no, little to no, little or no, extremely little, precious "
     "little, hardly a"},
};

}  // namespace

const PhraseTable<ShareAmount>& AmountWords() {
  static const PhraseTable<ShareAmount> table = [] {
    PhraseTable<ShareAmount> made;
    for (const auto& [amount, phrases] : kAmounts) {
      for (std::string_view rest = phrases; !rest.empty();) {
        const std::size_t end = rest.find(kSeparator);
        made.Add(rest.substr(0, end), amount);
        rest.remove_prefix(end == rest.npos ? rest.size() : end + kSeparator.size());
      }
    }
    return made;
  }();
  return table;
}

const PhraseTable<ShareBend>& BendWords() {
  static const PhraseTable<ShareBend> table{
      {ShareBend::kAbout,
       {"about", "around", "roughly", "approximately", "some", "circa", "ca", "approx", "say",
        "more or less", "something like", "in the region of", "a good", "close to", "maybe",
        "perhaps", "fully"}},
      {ShareBend::kAtLeast,
       {"at least", "no less than", "not less than", "a minimum of", "minimum", "min"}},
      {ShareBend::kAtMost,
       {"at most", "up to", "no more than", "not more than", "a maximum of", "maximum", "max",
        "at the most"}},
      {ShareBend::kNearly,
       {"nearly", "almost", "just under", "a little under", "not quite", "slightly less than",
        "a bit less than", "just below", "a little less than", "just short of", "close on"}},
      {ShareBend::kMore,
       {"more than", "over", "just over", "a little over", "above", "upwards of",
        "slightly more than", "well over", "a little more than", "a bit more than", "better than"}},
      {ShareBend::kLess, {"less than", "under", "below", "fewer than", "well under"}},
      {ShareBend::kExactly, {"exactly", "precisely", "just", "only", "a full", "a mere"}},
  };
  return table;
}

const PhraseTable<ShareBend>& BendWordsAfter() {
  static const PhraseTable<ShareBend> table{
      {ShareBend::kAtLeast,
       {"or more", "or above", "or over", "or higher", "and more", "and above"}},
      {ShareBend::kAtMost, {"or less", "or below", "or under", "or fewer", "and less"}},
  };
  return table;
}

}  // namespace latticeworld
