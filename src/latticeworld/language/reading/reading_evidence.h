#ifndef LATTICEWORLD_LANGUAGE_READING_READING_EVIDENCE_H_
#define LATTICEWORLD_LANGUAGE_READING_READING_EVIDENCE_H_

#include <vector>

#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// What two readings of one text, a model's and a second one, tell about which of them is right, for
// each part. Claims are compared as the small language says them.
std::vector<ReadingEvidence> EvidenceOf(const LayoutReading& model, const LayoutReading& second,
                                        Vocabulary vocabulary);
// layout: what the environment is of; never null.
std::vector<ReadingEvidence> EvidenceOf(const EnvironmentReading& model,
                                        const EnvironmentReading& second,
                                        const SymbolicLayout* layout);

// Returns the natural logarithm of the odds that of two readings that differ in what they get right
// of the part the model's is the better one. It is 0 where they make the same claims, and minus
// infinity where neither makes any: rules tell word by word what they do not understand.
double LogOddsOfModel(const ReadingEvidence& evidence);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_READING_EVIDENCE_H_
