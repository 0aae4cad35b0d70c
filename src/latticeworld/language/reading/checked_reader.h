#ifndef LATTICEWORLD_LANGUAGE_READING_CHECKED_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_CHECKED_READER_H_

#include <memory>

#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Two readers read every text, and each reading is checked by the other: the first one's, a
// model's, counts where it is sure of its sentences, else the second one's does. Of an environment
// the reading that counts is completed by what only the other one has read. The other reading
// stands beside it (second). A text that is already the small language needs no second reader.
// name(): "checked". Errors: those of the readers.
std::shared_ptr<InstructionReader> MakeCheckedReader(std::shared_ptr<InstructionReader> first,
                                                     std::shared_ptr<InstructionReader> second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_CHECKED_READER_H_
