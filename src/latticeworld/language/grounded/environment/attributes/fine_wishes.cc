#include "latticeworld/language/grounded/environment/attributes/fine_wishes.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

bool SameProperty(const EnvironmentClaim& a, const EnvironmentClaim& b) {
  return a.kind == b.kind && a.asset == b.asset &&
         (a.kind != EnvironmentClaimKind::kVariant || a.variant_key == b.variant_key) &&
         (a.kind != EnvironmentClaimKind::kParameter || a.parameter_key == b.parameter_key);
}

}  // namespace

void FineWishes::AddVariant(const VariantWord& word, std::size_t first, std::size_t last) {
  FineWish wish;
  wish.claim.kind = EnvironmentClaimKind::kVariant;
  wish.claim.asset = word.asset;
  wish.claim.variant_key = word.key;
  wish.claim.values = word.values;
  wish.claim.words = std::string(noted_.Text(first, last));
  for (FineWish& other : heard_.fine) {
    if (!SameProperty(other.claim, wish.claim)) continue;
    std::vector<std::string> both;
    for (const std::string& value : other.claim.values) {
      if (std::find(word.values.begin(), word.values.end(), value) != word.values.end()) {
        both.push_back(value);
      }
    }
    const bool joined = first > 0 && noted_.IsAnyWord(first - 1, {"and", "or"});
    if (!both.empty()) {
      other.claim.values = both;
    } else if (joined) {
      other.claim.values.insert(other.claim.values.end(), word.values.begin(), word.values.end());
    } else {
      heard_.warnings.push_back(Quote(other.claim.words) + " and " + Quote(wish.claim.words) +
                                " cannot both be; the last one said counts");
      other.claim.values = word.values;
      other.claim.words = wish.claim.words;
    }
    return;
  }
  heard_.fine.push_back(std::move(wish));
}

void FineWishes::AddParameter(const ParameterWord& word, std::size_t first, std::size_t last) {
  AddNumber(EnvironmentClaimKind::kParameter, word.asset, word.key, word.least, word.value,
            word.most, first, last);
}

void FineWishes::AddNumber(EnvironmentClaimKind kind, AssetType asset, ParameterKey key,
                           double least, double value, double most, std::size_t first,
                           std::size_t last) {
  FineWish wish;
  wish.claim.kind = kind;
  wish.claim.asset = asset;
  wish.claim.parameter_key = key;
  wish.claim.least = least;
  wish.claim.most = most;
  wish.claim.words = std::string(noted_.Text(first, last));
  wish.value = value;
  for (std::size_t i = first; i < last && i < noted_.size(); ++i) noted_.notes[i].known = true;
  for (FineWish& other : heard_.fine) {
    if (SameProperty(other.claim, wish.claim)) {
      other = std::move(wish);
      return;
    }
  }
  heard_.fine.push_back(std::move(wish));
}

bool FineWishes::HasVariant(const VariantWord& word) const {
  return std::any_of(heard_.fine.begin(), heard_.fine.end(), [&](const FineWish& wish) {
    return wish.claim.kind == EnvironmentClaimKind::kVariant && wish.claim.asset == word.asset &&
           wish.claim.variant_key == word.key;
  });
}

}  // namespace latticeworld
