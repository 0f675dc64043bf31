# Scanners and parsers: frontend/NAME.l and frontend/NAME.y become NAME.lex.c/.lex.h and NAME.tab.c/.tab.h in the build
# tree; sources include them as "frontend/NAME.lex.h" and "frontend/NAME.tab.h".
find_package(FLEX 2.6 REQUIRED)
find_package(BISON 3.8 REQUIRED)

# Sets `sources` in the caller to the generated files of every *.l and *.y in `folder`.
function(lsysc_generate_parsers sources folder)
  set(made)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${folder})
  file(MAKE_DIRECTORY ${out})
  file(GLOB grammars CONFIGURE_DEPENDS ${folder}/*.y)
  foreach(grammar ${grammars})
    cmake_path(GET grammar STEM name)
    add_custom_command(
      OUTPUT ${out}/${name}.tab.c ${out}/${name}.tab.h
      COMMAND ${BISON_EXECUTABLE} -Wall -Werror=conflicts-sr -Werror=conflicts-rr --defines=${out}/${name}.tab.h
              -o ${out}/${name}.tab.c ${grammar}
      DEPENDS ${grammar}
      VERBATIM)
    list(APPEND made ${out}/${name}.tab.c ${out}/${name}.tab.h)
  endforeach()
  file(GLOB scanners CONFIGURE_DEPENDS ${folder}/*.l)
  foreach(scanner ${scanners})
    cmake_path(GET scanner STEM name)
    add_custom_command(
      OUTPUT ${out}/${name}.lex.c ${out}/${name}.lex.h
      COMMAND ${FLEX_EXECUTABLE} --header-file=${out}/${name}.lex.h -o ${out}/${name}.lex.c ${scanner}
      DEPENDS ${scanner}
      VERBATIM)
    list(APPEND made ${out}/${name}.lex.c ${out}/${name}.lex.h)
  endforeach()
  # The skeletons of flex and bison convert freely; our own warnings are for our own files.
  if(made)
    set_source_files_properties(${made} PROPERTIES COMPILE_OPTIONS "-Wno-conversion;-Wno-sign-compare")
  endif()
  set(${sources} ${made} PARENT_SCOPE)
endfunction()
