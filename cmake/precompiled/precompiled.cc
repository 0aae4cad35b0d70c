// A target has to have a source; what counts are the headers (CMakeLists.txt).
