# Finds OpenCV by its own configuration where that is installed, and else by its parts: Debian's
# packages of single modules (libopencv-core-dev ...) come without one.
# Gives the targets opencv_<component> and OpenCV_INCLUDE_DIRS.
find_package(OpenCV QUIET CONFIG COMPONENTS ${OpenCV_FIND_COMPONENTS})
if(OpenCV_FOUND)
  return()
endif()
unset(OpenCV_DIR CACHE)

include(FindPackageHandleStandardArgs)
find_path(OpenCV_INCLUDE_DIRS opencv2/core/mat.hpp PATH_SUFFIXES opencv4)
set(opencv_needed OpenCV_INCLUDE_DIRS)
foreach(component IN LISTS OpenCV_FIND_COMPONENTS)
  find_library(OpenCV_${component}_LIBRARY opencv_${component})
  mark_as_advanced(OpenCV_${component}_LIBRARY)
  list(APPEND opencv_needed OpenCV_${component}_LIBRARY)
  if(OpenCV_INCLUDE_DIRS AND OpenCV_${component}_LIBRARY AND NOT TARGET opencv_${component})
    add_library(opencv_${component} UNKNOWN IMPORTED)
    set_target_properties(opencv_${component} PROPERTIES
      IMPORTED_LOCATION ${OpenCV_${component}_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIRS})
  endif()
endforeach()
mark_as_advanced(OpenCV_INCLUDE_DIRS)
find_package_handle_standard_args(OpenCV REQUIRED_VARS ${opencv_needed})
