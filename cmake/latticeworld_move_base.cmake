# Gives the target latticeworld_move_base: the messages of move_base's action, and tf2.
find_package(move_base_msgs REQUIRED)
find_package(tf2_ros REQUIRED)

add_library(latticeworld_move_base INTERFACE)
target_include_directories(latticeworld_move_base SYSTEM INTERFACE ${move_base_msgs_INCLUDE_DIRS}
                           ${tf2_ros_INCLUDE_DIRS})
target_link_libraries(latticeworld_move_base INTERFACE ${tf2_ros_LIBRARIES})
