#ifndef LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_
#define LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/language_stack.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// Request to World. One request at a time; call from one thread (Cancel comes through Progress).
class WorldGenerator {
 public:
  // sketches: how they become land. catalogue: what worlds are furnished with; not null.
  explicit WorldGenerator(LanguageStack language, SketchTranslator sketches = SketchTranslator(),
                          std::shared_ptr<const Catalogue> catalogue = Catalogue::BuiltIn());

  // Everything that can be said about a request before any work is done, every violation at once.
  Status Validate(const GenerationRequest& request) const;

  // Errors: INVALID_ARGUMENT (every violation), CANCELLED, RESOURCE_EXHAUSTED, what readers and
  // generators say.
  Result<std::shared_ptr<const World>> Generate(const GenerationRequest& request,
                                                const Progress& progress);

  std::vector<std::string> reader_names() const;
  std::vector<std::string> generator_names() const;

 private:
  LanguageStack language_;
  SketchTranslator sketches_;
  std::shared_ptr<const Catalogue> catalogue_;
};

// The generator with what needs no model: readers "rules" and "controlled", generator "grounded".
WorldGenerator MakeDefaultWorldGenerator();

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_
