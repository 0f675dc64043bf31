# Flags that every target of ours has. -ffp-contract=off: the same bits everywhere (DESIGN: no fused multiply-add).
add_library(lsysc_options INTERFACE)
target_compile_options(lsysc_options INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
                                               -ffp-contract=off -fvisibility=hidden)
target_compile_definitions(lsysc_options INTERFACE _GNU_SOURCE)
if(LSYSC_WERROR)
  target_compile_options(lsysc_options INTERFACE -Werror)
endif()
if(LSYSC_SANITIZE)
  set(LSYSC_SANITIZE_FLAGS -fsanitize=${LSYSC_SANITIZE})
  target_compile_options(lsysc_options INTERFACE ${LSYSC_SANITIZE_FLAGS} -fno-omit-frame-pointer)
  target_link_options(lsysc_options INTERFACE ${LSYSC_SANITIZE_FLAGS})
endif()
