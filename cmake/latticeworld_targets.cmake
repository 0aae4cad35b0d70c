set(LATTICEWORLD_CORE_DIR ${PROJECT_SOURCE_DIR}/src/latticeworld)

set(LATTICEWORLD_WARNINGS -Wall -Wextra -Wshadow)
# Errno and traps hinder vectorising; no value changes without them. Never -ffast-math: NaN means
# dry, infinity what is not there.
set(LATTICEWORLD_GRID_LOOPS -O3 -fno-math-errno -fno-trapping-math)

# latticeworld_library(<room> [HEADERS set] [GRID_LOOPS] SOURCES ... [PUBLIC targets]
#                      [PRIVATE targets])
# One static library a room, latticeworld_<room>, whose headers are included from src/. Those of the
# core are installed for other programs, as latticeworld::<room> (cmake/latticeworld_packages.cmake).
# HEADERS says which precompiled headers its sources have: standard (where it is not given) or eigen
# (cmake/precompiled). GRID_LOOPS has its loops over whole grids vectorised.
function(latticeworld_library room)
  cmake_parse_arguments(ARG "GRID_LOOPS" "HEADERS" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target latticeworld_${room})
  add_library(${target} STATIC ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  target_compile_options(${target} PRIVATE ${LATTICEWORLD_WARNINGS})
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${room})
  set(headers ${ARG_HEADERS})
  if(NOT headers)
    set(headers standard)
  endif()
  if(ARG_GRID_LOOPS)
    target_compile_options(${target} PRIVATE ${LATTICEWORLD_GRID_LOOPS})
    string(APPEND headers _grid_loops)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # tried with no other
    target_precompile_headers(${target} REUSE_FROM latticeworld_precompiled_${headers})
  endif()
  cmake_path(IS_PREFIX LATTICEWORLD_CORE_DIR ${CMAKE_CURRENT_SOURCE_DIR} is_core)
  if(is_core)
    install(TARGETS ${target} EXPORT latticeworld_core
            ARCHIVE DESTINATION lib/latticeworld_core COMPONENT dev
            INCLUDES DESTINATION include/latticeworld_core)
  endif()
endfunction()

# latticeworld_few_units(<room> APART sources...) compiles eight sources of a room as one, but for those
# that have a helper of the same name as another. For rooms that nobody changes: what is changed is
# compiled together with seven others.
function(latticeworld_few_units room)
  cmake_parse_arguments(ARG "" "" "APART" ${ARGN})
  set_target_properties(latticeworld_${room} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  set_source_files_properties(${ARG_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# latticeworld_discover_tests(<target> <prefix> [property value]...) makes a CTest test of each TEST()
# in a program, named <prefix>.Suite.Test; the program is asked for their names when ctest begins.
include(GoogleTest)
function(latticeworld_discover_tests target prefix)
  gtest_discover_tests(${target} TEST_PREFIX ${prefix}. DISCOVERY_MODE PRE_TEST
                       DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 ${ARGN})
endfunction()

# latticeworld_test_path(<source> <NAME> <path>) defines NAME as the text of a path, for that source
# alone: a path of this clone on every source of a test would let no other clone use what ccache
# has of them.
function(latticeworld_test_path source name path)
  set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS "${name}=\"${path}\"")
endfunction()

# latticeworld_test(<room> SOURCES ... [LIBRARIES ...]) makes <room>_test and the CTest tests of it.
function(latticeworld_test room)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  set(target ${room}_test)
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE latticeworld_${room} ${ARG_LIBRARIES} GTest::gtest_main)
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  latticeworld_discover_tests(${target} ${room} LABELS ${room})
endfunction()
