#include "tools/fidelity_tables.h"

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld::tools {
namespace {

// "0.972", "-" for nothing of nothing.
std::string Share(int satisfied, int total) {
  if (total == 0) return "-";
  char text[16];
  std::snprintf(text, sizeof(text), "%.3f", static_cast<double>(satisfied) / total);
  return text;
}

void PrintRow(const std::string& name, int satisfied, int total, std::ostream* out) {
  char line[96];
  std::snprintf(line, sizeof(line), "  %-16s %5d of %5d   %s\n", name.c_str(), satisfied, total,
                Share(satisfied, total).c_str());
  *out << line;
}

void PrintSentences(const char* part, const std::vector<std::string>& sentences,
                    std::ostream* out) {
  if (!sentences.empty()) *out << "  " << part << " read as: " << Join(sentences, ". ") << ".\n";
}

}  // namespace

void PrintReport(const FidelityReport& report, std::ostream* out) {
  for (const ClaimOutcome& claim : report.claims) {
    *out << (claim.satisfied ? "  yes  " : "  NO   ") << NameOf(claim.part) << " " << claim.kind
         << ": " << Quote(claim.words) << "\n"
         << "       " << claim.explanation << "\n";
  }
  for (const std::string& words : report.not_understood) {
    *out << "  not understood: " << Quote(words) << "\n";
  }
  PrintSentences("layout", report.layout_sentences, out);
  PrintSentences("environment", report.environment_sentences, out);
  for (const ClaimOutcome& claim : report.second) {
    if (claim.satisfied) continue;
    *out << "  a second reading asks for " << Quote(claim.words) << ": " << claim.explanation
         << "\n";
  }
  if (report.words > 0) PrintRow("words read", report.words_read, report.words, out);
  const int claims = static_cast<int>(report.claims.size());
  if (report.not_understood.empty()) {
    PrintRow("satisfied", report.satisfied(), claims, out);
    return;
  }
  // A share of what was read would praise a reading that lost something.
  char line[128];
  std::snprintf(line, sizeof(line), "  %-16s %5d of %5d   of what was read; %zu phrase%s not\n",
                "satisfied", report.satisfied(), claims, report.not_understood.size(),
                report.not_understood.size() == 1 ? " was" : "s were");
  *out << line;
}

void PrintScore(std::string_view title, const FidelityScore& score, std::ostream* out) {
  *out << title << "\n";
  for (const auto& [kind, count] : score.by_kind) {
    PrintRow(kind, count.satisfied, count.total, out);
  }
  const FidelityScore::Count all = score.all();
  PrintRow("all claims", all.satisfied, all.total, out);
  PrintRow("valid answers", score.answered, score.items, out);
  char line[64];
  std::snprintf(line, sizeof(line), "  median time      %.1f ms\n", 1000.0 * score.median_s);
  *out << line;
}

void PrintMisses(const FidelityScore& score, std::ostream* out) {
  for (const FidelityScore::Miss& miss : score.misses) {
    *out << "  " << miss.id << " " << miss.kind << ": " << Quote(miss.words) << "\n"
         << "       " << miss.explanation << "\n";
  }
}

void PrintWarnings(const FidelityScore& score, std::ostream* out) {
  for (const FidelityScore::Warning& warning : score.warnings) {
    *out << "  " << warning.id << " warning: " << warning.text << "\n";
  }
}

void PrintEvidence(const FidelityScore& score, std::ostream* out) {
  for (const FidelityScore::TwoReadings& item : score.read_twice) {
    for (const ReadingEvidence& e : item.evidence) {
      *out << "  " << item.id << " evidence of " << NameOf(e.part)
           << ": log_probability=" << FormatDouble(e.log_probability) << " words=" << e.words
           << " carried=" << e.carried << " second_carried=" << e.second_carried
           << " lost=" << e.lost << " second_lost=" << e.second_lost << " claims=" << e.claims
           << " second_claims=" << e.second_claims << " agreed=" << e.agreed << "\n";
    }
  }
}

}  // namespace latticeworld::tools
