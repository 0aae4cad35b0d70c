#include "latticeworld/language/grounded/repeated_mentions.h"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

bool SayTheSame(const Mention& a, const Mention& b) {
  const auto same_place = [](const Place& p, const Place& q) {
    return p.main == q.main && p.regions == q.regions;
  };
  return a.letter == b.letter && a.noun == b.noun && a.negated == b.negated &&
         a.is_rest == b.is_rest && a.amount == b.amount && a.texture == b.texture &&
         a.number == b.number && a.from == b.from && a.to == b.to &&
         (a.from_mention >= 0) == (b.from_mention >= 0) &&
         (a.to_mention >= 0) == (b.to_mention >= 0) && a.through == b.through &&
         a.meander == b.meander && a.wide == b.wide &&
         std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(), same_place);
}

}  // namespace

std::vector<int> FirstOfRepeated(const std::vector<Mention>& mentions,
                                 std::string_view instruction) {
  std::unordered_map<std::string, int> first_by_words;
  std::vector<int> first(mentions.size());
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    const Mention& mention = mentions[i];
    const std::vector<Token> tokens =
        Tokenize(instruction.substr(mention.begin, mention.end - mention.begin));
    const int known =
        first_by_words.emplace(JoinWords(tokens, 0, tokens.size()), static_cast<int>(i))
            .first->second;
    const bool same = SayTheSame(mentions[static_cast<std::size_t>(known)], mention);
    first[i] = same ? known : static_cast<int>(i);
  }
  return first;
}

}  // namespace latticeworld
