#ifndef LATTICEWORLD_LANGUAGE_REMOTE_ANSWER_IN_FORM_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_ANSWER_IN_FORM_H_

#include <string>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

// What EnvironmentForm() accepts has numbers in steps. A model that learns from other numbers
// meets, where the form holds at work, what it has never seen.

// Every number of the fine attributes becomes the nearest of the form's values that keeps to the
// rules; one whose bounds leave out all of them stays as it is.
void RoundToForm(EnvironmentConfig* environment,
                 const Catalogue& catalogue = *Catalogue::BuiltIn());

// JSON as the form spells it: no blanks, whole steps as whole numbers. The numbers of a rounded
// environment match the form; others are told as they are.
std::string AnswerInForm(const EnvironmentConfig& environment,
                         const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_ANSWER_IN_FORM_H_
