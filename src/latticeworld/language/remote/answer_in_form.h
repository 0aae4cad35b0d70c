#ifndef LATTICEWORLD_LANGUAGE_REMOTE_ANSWER_IN_FORM_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_ANSWER_IN_FORM_H_

#include <string>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

// EnvironmentForm() accepts numbers in steps only. A model that learned from other numbers would
// meet numbers that it has never seen where a server enforces the form. The functions here put
// training answers into the form.

// Rounds every number of the fine attributes to the nearest of the form's values that keeps to the
// rules. A number whose bounds leave out all of them stays as it is.
void RoundToForm(EnvironmentConfig* environment,
                 const Catalogue& catalogue = *Catalogue::BuiltIn());

// Writes the environment as JSON as the form spells it: without blanks, and whole steps as whole
// numbers. The numbers of a rounded environment match the form; other numbers are written as they
// are.
std::string AnswerInForm(const EnvironmentConfig& environment,
                         const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_ANSWER_IN_FORM_H_
