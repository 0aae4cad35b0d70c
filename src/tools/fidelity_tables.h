#ifndef LATTICEWORLD_TOOLS_FIDELITY_TABLES_H_
#define LATTICEWORLD_TOOLS_FIDELITY_TABLES_H_

#include <iosfwd>
#include <string_view>

#include "latticeworld/generation/fidelity/fidelity.h"
#include "latticeworld/generation/fidelity/fidelity_benchmark.h"

namespace latticeworld::tools {

// A line a claim, the words that were not understood, and the sum.
void PrintReport(const FidelityReport& report, std::ostream* out);

// A line a kind of claim, and the sum. title: "layout, development part".
void PrintScore(std::string_view title, const FidelityScore& score, std::ostream* out);
// A line a claim that is not satisfied.
void PrintMisses(const FidelityScore& score, std::ostream* out);
// A line a warning.
void PrintWarnings(const FidelityScore& score, std::ostream* out);
// A line a part of a text that was read twice: what is known of its readings (ReadingEvidence) as
// NAME=NUMBER.
void PrintEvidence(const FidelityScore& score, std::ostream* out);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_FIDELITY_TABLES_H_
