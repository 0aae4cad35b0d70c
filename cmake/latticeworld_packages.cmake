# What is installed of the core for other programs, and the three Debian packages that
# scripts/package.sh makes, a package a component:
#
#   messages  ros-latticeworld-msgs   messages in every form, package.xml, catkin's configuration
#   world     ros-latticeworld        nodes, tools, launch files, page, models
#   dev       liblatticeworld-dev     headers, libraries, find_package(latticeworld_core)
include(CMakePackageConfigHelpers)

set(latticeworld_core_dir lib/cmake/latticeworld_core)
install(EXPORT latticeworld_core FILE latticeworld_core_targets.cmake NAMESPACE latticeworld::
        DESTINATION ${latticeworld_core_dir} COMPONENT dev)
configure_package_config_file(cmake/latticeworld_core-config.cmake.in
  ${CMAKE_BINARY_DIR}/latticeworld_core-config.cmake INSTALL_DESTINATION ${latticeworld_core_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/latticeworld_core-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/latticeworld_core-config.cmake
              ${CMAKE_BINARY_DIR}/latticeworld_core-config-version.cmake cmake/FindOpenCV.cmake
        DESTINATION ${latticeworld_core_dir} COMPONENT dev)
install(DIRECTORY src/latticeworld DESTINATION include/latticeworld_core COMPONENT dev
        FILES_MATCHING PATTERN "*.h" PATTERN data EXCLUDE)

if(NOT LATTICEWORLD_WITH_ROS)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL messages world dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/tidy.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_NAME latticeworld)
set(CPACK_PACKAGE_CONTACT "The LatticeWorld team <team@latticeworld.dev>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_MESSAGES_PACKAGE_NAME ros-latticeworld-msgs)
set(CPACK_DEBIAN_MESSAGES_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_MESSAGES_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_MESSAGES_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/cmake/debian/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_DEBIAN_MESSAGES_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_MESSAGES_PACKAGE_DEPENDS
    "libactionlib-msgs-dev, libgeometry-msgs-dev, libroscpp-core-dev, libsensor-msgs-dev, libstd-msgs-dev, python3:any, python3-actionlib-msgs, python3-genpy, python3-geometry-msgs, python3-sensor-msgs, python3-std-msgs, ros-actionlib-msgs, ros-geometry-msgs, ros-message-runtime, ros-sensor-msgs, ros-std-msgs")
set(CPACK_COMPONENT_MESSAGES_DESCRIPTION
    "messages, services and actions of LatticeWorld\n What programs need that talk to its nodes over ROS 1, in C++, Python and Lisp.")

set(CPACK_DEBIAN_WORLD_PACKAGE_NAME ros-latticeworld)
set(CPACK_DEBIAN_WORLD_PACKAGE_DEPENDS
    "ros-latticeworld-msgs (= ${PROJECT_VERSION}), python3:any, python3-move-base-msgs, python3-nav-msgs, python3-rosgraph, python3-rosgraph-msgs, python3-roslaunch, python3-rosmaster, python3-rosnode, python3-rosparam, python3-rospy, python3-rosservice, python3-rostopic, python3-std-msgs, python3-std-srvs, python3-tf2-ros, rosbash, ros-diagnostic-msgs, ros-move-base-msgs, ros-nav-msgs, ros-rosgraph-msgs, ros-std-srvs, ros-tf2-msgs, ros-visualization-msgs, rosout")
set(CPACK_DEBIAN_WORLD_PACKAGE_RECOMMENDS "python3-numpy, python3-venv")  # for fetch_reader.sh
set(CPACK_COMPONENT_WORLD_DESCRIPTION
    "living, physical worlds for robots from words\n Makes terrain, water, vegetation, buildings, weather and agents from text, simulates\n them in real time and speaks ROS 1: nodes, the command line and launch files.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME liblatticeworld-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libboost-dev, libcurl4-openssl-dev, libeigen3-dev, libembree-dev, libgdal-dev, libode-dev, liboctomap-dev, libopencv-core-dev, libopencv-dnn-dev, libopencv-imgcodecs-dev, libopencv-imgproc-dev, libssl-dev, libvalijson-dev, libyaml-cpp-dev, nlohmann-json3-dev, pkg-config, zlib1g-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION
    "core of LatticeWorld for programs of one's own\n Headers, static libraries and a CMake configuration: words to worlds to simulation,\n without ROS.")

# Every Debian package brings its licence and its history.
find_program(GZIP_PROGRAM gzip REQUIRED)
set(changelog ${CMAKE_BINARY_DIR}/changelog.gz)
execute_process(COMMAND ${GZIP_PROGRAM} -9n --stdout ${PROJECT_SOURCE_DIR}/cmake/debian/changelog
                OUTPUT_FILE ${changelog} COMMAND_ERROR_IS_FATAL ANY)
foreach(component messages world dev)
  string(TOUPPER ${component} upper)
  set(documents share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES LICENSE DESTINATION ${documents} RENAME copyright COMPONENT ${component})
  install(FILES ${changelog} DESTINATION ${documents} COMPONENT ${component})
endforeach()
include(CPack)
