#ifndef LATTICEWORLD_LANGUAGE_READING_MADE_UP_H_
#define LATTICEWORLD_LANGUAGE_READING_MADE_UP_H_

#include <string>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Whether two wishes are of the same property of one type of assets.
bool AreOfSame(const FineWish& one, const FineWish& other);

// MadeUp tells what a model made up in its reading of an environment: what no words of the text
// say. Models that were taught "no wind" and "12 m/s" may read "windy, three sheep" as 3 m/s.
class MadeUp {
 public:
  // request, reading: outlive this. The layout and the catalogue of the request are not null.
  MadeUp(const EnvironmentRequest& request, const EnvironmentReading& reading);

  // A parameter of which another reading says the other: they are nothing alike, and the text does
  // not say its numbers, or says them of something else. Headings are said in words, not in
  // numbers, and never count as made up.
  bool Is(const FineWish& wish, const FineWish& other) const;
  // A number of agents in all that is less than those of the reading's groups, and that the text
  // does not say, or says of something else.
  bool Is(const EnvironmentClaim& absence) const;

 private:
  // Whether the text says none of the sentences' numbers, or says them of something else. False
  // where they have none.
  bool AreNumbersOf(const std::vector<std::string>& sentences) const;
  HeardEnvironment HeardOf(const std::string& sentence) const;

  const EnvironmentRequest& request_;
  const EnvironmentReading& reading_;
};

// Returns a model's reading without what neither a word of the text (topics.h) nor a second reading
// speaks of: a model that was taught environments alone reads goblins into texts of land. A warning
// tells what was left out. second: sentences. The layout and the catalogue of the request are not
// null.
EnvironmentReading WithoutUnspoken(const EnvironmentRequest& request, EnvironmentReading reading,
                                   const std::vector<std::string>& second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_MADE_UP_H_
