#ifndef LATTICEWORLD_GENERATION_LANGUAGE_STACK_H_
#define LATTICEWORLD_GENERATION_LANGUAGE_STACK_H_

#include <map>
#include <memory>
#include <string>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Who answers: the symbolic layout and the environment of instructions that have been read.
struct LanguageGenerator {
  std::unique_ptr<LayoutGenerator> layout;
  std::unique_ptr<EnvironmentGenerator> environment;
};

// Who reads instructions and who answers them, by name: any reader goes with any generator. What is
// read goes to the generator and into the fidelity report.
struct LanguageStack {
  std::map<std::string, std::shared_ptr<InstructionReader>> readers;  // never null
  std::map<std::string, LanguageGenerator> generators;                // never null
  std::string default_reader;                                         // one of readers
  std::string default_generator;                                      // one of generators
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_LANGUAGE_STACK_H_
