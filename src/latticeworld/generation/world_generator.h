#ifndef LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_
#define LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Who reads instructions, and who answers them. What is read goes to who answers, and into the
// fidelity report.
struct LanguageBackend {
  std::shared_ptr<InstructionReader> reader;
  std::unique_ptr<LayoutGenerator> layout;
  std::unique_ptr<EnvironmentGenerator> environment;
};

// Request to World. One request at a time; call from one thread (Cancel comes through Progress).
class WorldGenerator {
 public:
  // backends: by name; default_backend must be among them.
  // sketches: how they become land. catalogue: what worlds are furnished with; not null.
  WorldGenerator(std::map<std::string, LanguageBackend> backends, std::string default_backend,
                 SketchTranslator sketches = SketchTranslator(),
                 std::shared_ptr<const Catalogue> catalogue = Catalogue::BuiltIn());

  // Everything that can be said about a request before any work is done, every violation at once.
  Status Validate(const GenerationRequest& request) const;

  // Errors: INVALID_ARGUMENT (every violation), CANCELLED, RESOURCE_EXHAUSTED, what back ends say.
  Result<std::shared_ptr<const World>> Generate(const GenerationRequest& request,
                                                const Progress& progress);

  std::vector<std::string> backend_names() const;

 private:
  std::map<std::string, LanguageBackend> backends_;
  std::string default_backend_;
  SketchTranslator sketches_;
  std::shared_ptr<const Catalogue> catalogue_;
};

// The generator with every back end that is built in ("grounded").
WorldGenerator MakeDefaultWorldGenerator();

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_
