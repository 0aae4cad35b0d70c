# latticeworld_embed(<target> <function> files...)
# Compiles text files into a library target. Code finds them by their file name through
#
#   namespace latticeworld { std::string_view <function>(std::string_view file_name); }
#
# which it declares itself; "" for a name that is not among them.
function(latticeworld_embed target function)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${function}_embedded.cc)
  set(paths "")
  foreach(file IN LISTS ARGN)
    list(APPEND paths ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  endforeach()
  string(REPLACE ";" "|" packed "${paths}")
  add_custom_command(
    OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DFUNCTION=${function} "-DFILES=${packed}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()
