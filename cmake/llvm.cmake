# Linked statically, LLVM brings C++ and compression libraries along (Debian: apt-get install g++ libzstd-dev).
if(LSYSC_STATIC_LLVM)
  enable_language(CXX)
endif()

# LLVM 19 to 22. find_package accepts only an exact major.minor, and without a version Debian 12 gives 14.
foreach(version 19.1 20.1 21.1 22.1)
  if(NOT LLVM_FOUND)
    find_package(LLVM ${version} QUIET CONFIG)
  endif()
endforeach()
if(NOT LLVM_FOUND)
  message(FATAL_ERROR "LLVM 19 to 22 is needed (Debian: apt-get install llvm-19-dev)")
endif()
message(STATUS "LLVM ${LLVM_PACKAGE_VERSION} in ${LLVM_DIR}")

# Gives a target that includes llvm-c/* its headers and libraries.
function(lsysc_use_llvm target)
  separate_arguments(definitions NATIVE_COMMAND ${LLVM_DEFINITIONS})
  target_include_directories(${target} SYSTEM PRIVATE ${LLVM_INCLUDE_DIRS})
  target_compile_definitions(${target} PRIVATE ${definitions})
  if(LSYSC_STATIC_LLVM)
    llvm_map_components_to_libnames(libraries core passes orcjit bitwriter ${LLVM_TARGETS_TO_BUILD})
    target_link_libraries(${target} PUBLIC ${libraries})
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  else()
    target_link_libraries(${target} PRIVATE LLVM)
  endif()
endfunction()
