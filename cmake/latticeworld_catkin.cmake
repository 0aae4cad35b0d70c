# The catkin side of the package: messages, the compatibility packages, what is exported.
# Gives the target latticeworld_messages: include folders of all messages, and their generation.

# ROS comes from Debian's packages and works with Debian's python alone, whatever another python
# (pyenv, conda) stands first in PATH.
if(NOT PYTHON_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The python that ROS is installed for")
endif()

# Debian's rosrun overlooks every program below a package's own build/ folder: the programs of such a
# build go to devel/ beside it, where those of a catkin workspace are too.
if(NOT CATKIN_DEVEL_PREFIX AND CMAKE_BINARY_DIR STREQUAL "${PROJECT_SOURCE_DIR}/build")
  set(CATKIN_DEVEL_PREFIX ${PROJECT_SOURCE_DIR}/devel)
endif()

set(LATTICEWORLD_ROS_PACKAGES actionlib actionlib_msgs diagnostic_msgs geometry_msgs nav_msgs roscpp
    rosgraph_msgs sensor_msgs std_msgs std_srvs tf2_msgs visualization_msgs)
find_package(catkin REQUIRED COMPONENTS message_generation ${LATTICEWORLD_ROS_PACKAGES})

add_library(latticeworld_messages INTERFACE)

# latticeworld_compat(<package>): uses the system's package, else builds the one in cmake/compat.
function(latticeworld_compat package)
  # Already part of this catkin workspace?
  if(NOT TARGET ${package}_generate_messages_cpp)
    # What an earlier run of this build made is not the system's: look past it.
    string(REPLACE ":" ";" prefixes "$ENV{CMAKE_PREFIX_PATH}")
    list(PREPEND prefixes ${CMAKE_PREFIX_PATH})
    list(REMOVE_ITEM prefixes ${CATKIN_DEVEL_PREFIX} ${CMAKE_INSTALL_PREFIX})
    set(CMAKE_PREFIX_PATH ${prefixes})
    if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")  # there stands what the system has
      list(REMOVE_ITEM CMAKE_SYSTEM_PREFIX_PATH ${CMAKE_INSTALL_PREFIX})
    endif()
    find_package(${package} QUIET NO_CMAKE_ENVIRONMENT_PATH NO_SYSTEM_ENVIRONMENT_PATH)
    if(${package}_FOUND)
      message(STATUS "latticeworld: using ${package} in ${${package}_DIR}")
      target_include_directories(latticeworld_messages SYSTEM INTERFACE ${${package}_INCLUDE_DIRS})
      return()
    endif()
    message(STATUS "latticeworld: no ${package} found, building a wire-compatible one")
    list(PREPEND CMAKE_PREFIX_PATH ${CATKIN_DEVEL_PREFIX})
    add_subdirectory(${PROJECT_SOURCE_DIR}/cmake/compat/${package})
    # rosmsg, rostopic and rosbag find a package of the devel space through its source folder.
    file(READ ${CATKIN_DEVEL_PREFIX}/.catkin source_spaces)
    set(compat ${PROJECT_SOURCE_DIR}/cmake/compat)
    if(NOT compat IN_LIST source_spaces)
      file(APPEND ${CATKIN_DEVEL_PREFIX}/.catkin ";${compat}")
    endif()
  endif()
  add_dependencies(latticeworld_messages ${package}_generate_messages_cpp
                   ${package}_generate_messages_py)
endfunction()
latticeworld_compat(octomap_msgs)
latticeworld_compat(grid_map_msgs)

add_message_files(FILES
  AgentCommand.msg
  AgentEvent.msg
  AgentState.msg
  AgentStates.msg
  Bumper.msg
  ClaimOutcome.msg
  ElementState.msg
  ElementStates.msg
  Environment.msg
  Episode.msg
  EpisodeEnd.msg
  EpisodeStart.msg
  EpisodeStatus.msg
  FelledTree.msg
  GenerationProgress.msg
  JournalEntry.msg
  Layout.msg
  NamedThing.msg
  Observation.msg
  Reading.msg
  SceneChanges.msg
  StageTime.msg
  StateHash.msg
  Status.msg
  TerrainSample.msg
  Weather.msg
  WorldBundle.msg
  WorldFile.msg
  WorldFiles.msg
  WorldInfo.msg
)
add_service_files(FILES
  GenerateWorld.srv
  GetWorld.srv
  GetWorldBundle.srv
  ListEpisodes.srv
  ListWorlds.srv
  LoadWorld.srv
  Lockstep.srv
  OpenGate.srv
  QueryTerrain.srv
  QueryThings.srv
  RemoveAgent.srv
  RemoveElement.srv
  ResetWorld.srv
  RestoreSnapshot.srv
  SaveSnapshot.srv
  SaveWorld.srv
  SetPolicy.srv
  SetRealTimeFactor.srv
  SetWeather.srv
  SpawnAgent.srv
  SpawnElement.srv
  StartEpisode.srv
  Step.srv
  StopEpisode.srv
)
add_action_files(FILES GenerateWorldTask.action)
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs sensor_msgs std_msgs)

catkin_package(CATKIN_DEPENDS message_runtime actionlib_msgs geometry_msgs sensor_msgs std_msgs)

target_include_directories(latticeworld_messages SYSTEM INTERFACE
                           ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_INCLUDE_DESTINATION}
                           ${catkin_INCLUDE_DIRS})
target_link_libraries(latticeworld_messages INTERFACE ${catkin_LIBRARIES})
add_dependencies(latticeworld_messages latticeworld_generate_messages_cpp
                 latticeworld_generate_messages_py)

# latticeworld_node(<name> SOURCES ... LIBRARIES ...): a program that rosrun and roslaunch find.
function(latticeworld_node name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wshadow)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                        ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  install(TARGETS ${name} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME world)  # of all that is installed from here on
catkin_install_python(PROGRAMS scripts/generate_world.py scripts/launch_stack.py
                      DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(FILES scripts/stack_bridge.py clients/latticeworld_stack/latticeworld_stack.py
        DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
# What fetches the model that reads, and joins it with its adapter in models/.
install(PROGRAMS scripts/fetch_reader.sh DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(FILES training/latticeworld_training/__init__.py training/latticeworld_training/gguf.py
              training/latticeworld_training/join_reader.py
        DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/training/latticeworld_training)
install(DIRECTORY launch_cfg models DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
