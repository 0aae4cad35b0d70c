#ifndef LATTICEWORLD_LANGUAGE_READING_CHECKED_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_CHECKED_READER_H_

#include <memory>

#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Makes a reader that lets `first`, a model, read, and keeps what `second` reads in the same text
// beside it (`second` of the reading). A text that is already the small language is read without
// the second reader. name() is that of `first`. Errors: those of the readers.
std::shared_ptr<InstructionReader> MakeComparedReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second);

// Makes a reader that lets two readers read every text and checks each reading by the other. The
// likelier reading of a layout counts, that of `first`, a model, or that of `second`
// (LogOddsOfModel); where it is that of the model, it is completed (land_completion.h). The parts
// of an environment (ReadingPart) are decided one by one, and what only one reading has counts too.
// What does not count is kept beside it (`second` of the reading). A text that is already the small
// language is read without the second reader. name() is "checked". Errors: those of the readers.
std::shared_ptr<InstructionReader> MakeCheckedReader(std::shared_ptr<InstructionReader> first,
                                                     std::shared_ptr<InstructionReader> second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_CHECKED_READER_H_
