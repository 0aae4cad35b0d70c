#ifndef LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_
#define LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/language_stack.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// A request that a WorldGenerator has found nothing wrong with. Only the generator makes one, so
// who holds one need not ask again.
class AcceptedRequest {
 public:
  const GenerationRequest& operator*() const { return request_; }
  const GenerationRequest* operator->() const { return &request_; }
  GenerationRequest Take() && { return std::move(request_); }

 private:
  friend class WorldGenerator;
  explicit AcceptedRequest(GenerationRequest request) : request_(std::move(request)) {}

  GenerationRequest request_;
};

// Request to World. One request at a time; call from one thread (Cancel comes through Progress).
class WorldGenerator {
 public:
  // sketches: how they become land. catalogue: what worlds are furnished with; not null.
  explicit WorldGenerator(LanguageStack language, SketchTranslator sketches = SketchTranslator(),
                          std::shared_ptr<const Catalogue> catalogue = Catalogue::BuiltIn());

  // Everything that can be said about a request before any work is done, every violation at once.
  Status Validate(const GenerationRequest& request) const;
  // The same for who wants to know early and to generate later: the request is looked at once.
  // Errors: INVALID_ARGUMENT (every violation).
  Result<AcceptedRequest> Accept(GenerationRequest request) const;

  // Errors: INVALID_ARGUMENT (every violation), CANCELLED, RESOURCE_EXHAUSTED, what readers and
  // generators say.
  Result<std::shared_ptr<const World>> Generate(const GenerationRequest& request,
                                                const Progress& progress);
  // request: accepted by this generator. Errors: as above, but for the violations.
  Result<std::shared_ptr<const World>> Generate(AcceptedRequest request, const Progress& progress);

  std::vector<std::string> reader_names() const;
  std::vector<std::string> generator_names() const;

 private:
  Result<std::shared_ptr<const World>> Make(AcceptedRequest request, const Progress& progress);

  LanguageStack language_;
  SketchTranslator sketches_;
  std::shared_ptr<const Catalogue> catalogue_;
};

// The generator with what needs no model: readers "rules" and "controlled", generator "grounded".
WorldGenerator MakeDefaultWorldGenerator();

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_WORLD_GENERATOR_H_
