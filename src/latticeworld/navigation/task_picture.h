#ifndef LATTICEWORLD_NAVIGATION_TASK_PICTURE_H_
#define LATTICEWORLD_NAVIGATION_TASK_PICTURE_H_

#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/navigation/tasks.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {

struct Scene;

// PNG of the world from above with the ways of tasks: a ring where each begins, a disc with the
// task's number (its place in `tasks`, from 0) where it ends. Neighbouring numbers have different
// colours. Errors: INVALID_ARGUMENT (options), INTERNAL.
Result<std::string> DrawTasks(const Scene& scene, const std::vector<NavigationTask>& tasks,
                              const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_TASK_PICTURE_H_
