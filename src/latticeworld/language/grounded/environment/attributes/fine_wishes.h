#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_WISHES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_WISHES_H_

#include <cstddef>

#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// Puts what tokens [first, last) say of an asset type among the wishes of `heard`.
class FineWishes {
 public:
  FineWishes(NotedTokens* noted, HeardEnvironment* heard) : noted_(*noted), heard_(*heard) {}

  // "autumn" and "oak" narrow each other down; "wheat and maize" leaves both. If values exclude
  // each other, the last one said counts, with a warning.
  void AddVariant(const VariantWord& word, std::size_t first, std::size_t last);

  void AddParameter(const ParameterWord& word, std::size_t first, std::size_t last);

  // A density (the key does not count) or a parameter; takes the place of one said before.
  void AddNumber(EnvironmentClaimKind kind, AssetType asset, ParameterKey key, double least,
                 double value, double most, std::size_t first, std::size_t last);

  // Whether something is said of the property of the asset type that `word` speaks of.
  bool HasVariant(const VariantWord& word) const;

 private:
  NotedTokens& noted_;
  HeardEnvironment& heard_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_WISHES_H_
