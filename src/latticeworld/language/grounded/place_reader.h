#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_PLACE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_PLACE_READER_H_

#include <vector>

#include "latticeworld/language/grounded/reading_state.h"

namespace latticeworld {

// Gives places to what was named before them, or keeps them for what comes ("In the north ...").
class PlaceReader {
 public:
  explicit PlaceReader(ReadingState* state) : state_(*state) {}

  void Read(const LayoutItem& item);
  // To what was named before.
  void Attach(const LayoutItem& item);
  // Tells a new mention the place that leads its clause.
  void ApplyLead(Mention* added) const;

 private:
  void Lead(const LayoutItem& item);
  std::vector<int> Owners() const;

  ReadingState& state_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_PLACE_READER_H_
