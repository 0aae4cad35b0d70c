# Python compiled here is of no use elsewhere; the package's postinst compiles it where it is.
file(GLOB_RECURSE compiled LIST_DIRECTORIES true "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*__pycache__")
foreach(folder IN LISTS compiled)
  if(folder MATCHES "/__pycache__$")
    file(REMOVE_RECURSE "${folder}")
  endif()
endforeach()
