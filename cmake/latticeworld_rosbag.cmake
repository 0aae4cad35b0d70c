# Gives the target latticeworld_rosbag: rosbag_storage and topic_tools, and what their headers need,
# which roslz4 and bz2 are part of.
# Found by hand, for find_package(rosbag_storage) of Debian asks for ament and all that it needs.
find_path(LATTICEWORLD_ROSBAG_DIR rosbag/bag.h HINTS ${catkin_INCLUDE_DIRS} REQUIRED)
find_path(LATTICEWORLD_SHAPE_SHIFTER_DIR topic_tools/shape_shifter.h
          HINTS ${catkin_INCLUDE_DIRS} REQUIRED)
# ROS' own packages and Debian's put these into folders of different names.
find_path(LATTICEWORLD_PLUGINLIB_DIR pluginlib/class_loader.hpp
          HINTS ${catkin_INCLUDE_DIRS} PATH_SUFFIXES pluginlib REQUIRED)
find_path(LATTICEWORLD_CLASS_LOADER_DIR class_loader/class_loader.hpp
          HINTS ${catkin_INCLUDE_DIRS} PATH_SUFFIXES class_loader REQUIRED)
set(LATTICEWORLD_ROSBAG_INCLUDES ${LATTICEWORLD_ROSBAG_DIR} ${LATTICEWORLD_SHAPE_SHIFTER_DIR}
    ${LATTICEWORLD_PLUGINLIB_DIR} ${LATTICEWORLD_CLASS_LOADER_DIR})
foreach(folder rcpputils rcutils ament_index_cpp)
  if(IS_DIRECTORY /usr/include/${folder}/${folder})
    list(APPEND LATTICEWORLD_ROSBAG_INCLUDES /usr/include/${folder})
  endif()
endforeach()

add_library(latticeworld_rosbag INTERFACE)
target_include_directories(latticeworld_rosbag SYSTEM INTERFACE ${LATTICEWORLD_ROSBAG_INCLUDES})
foreach(library rosbag_storage roslz4 bz2 topic_tools class_loader console_bridge boost_filesystem
        roslib tinyxml2)
  find_library(LATTICEWORLD_LIB_${library} ${library} HINTS ${catkin_LIBRARY_DIRS} REQUIRED)
  target_link_libraries(latticeworld_rosbag INTERFACE ${LATTICEWORLD_LIB_${library}})
endforeach()
