#include "language/grounded/environment/environment_country.h"

#include <gtest/gtest.h>

#include <utility>

#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {

SymbolicLayout Country() {
  SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  for (int row = 0; row < 10; ++row) {
    for (int col = 0; col < 10; ++col) {
      layout.cells(row, col) = 'W';
      layout.cells(31 - row, 31 - col) = 'F';
      layout.cells(row, 31 - col) = 'A';
    }
  }
  for (int row = 14; row < 18; ++row) {
    for (int col = 14; col < 18; ++col) layout.cells(row, col) = 'B';
  }
  for (int row = 22; row < 32; ++row) layout.cells(row, 2) = 'R';
  return layout;
}

EnvironmentAnswer GenerateInCountry(const std::string& instruction, double size_m) {
  const SymbolicLayout layout = Country();
  EnvironmentRequest request;
  request.instruction = instruction;
  request.layout = &layout;
  request.size_m = size_m;
  Result<EnvironmentAnswer> answer =
      MakeGroundedEnvironmentGenerator()->Generate(request, Progress());
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  return answer.ok() ? std::move(answer).value() : EnvironmentAnswer();
}

}  // namespace latticeworld
