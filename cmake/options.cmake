# Flags for every target of this project; PRIVATE, so that no consumer inherits them.
add_library(deburr_options INTERFACE)
# Contraction to fused multiply-add would make results depend on the processor and the compiler.
target_compile_options(deburr_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic
  -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast $<$<BOOL:${DEBURR_WERROR}>:-Werror>)
if(DEBURR_SANITIZE)
  target_compile_options(deburr_options INTERFACE -fsanitize=${DEBURR_SANITIZE}
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(deburr_options INTERFACE -fsanitize=${DEBURR_SANITIZE})
endif()

# A compiler cache saves more, but not with precompiled headers.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(DEBURR_QUICK_BUILD OFF)
endif()
# gcc cleans its memory up from 128 MiB on, which takes a tenth of its time; nothing here needs 1 GiB.
if(DEBURR_QUICK_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("SHELL:--param ggc-min-heapsize=1048576")
endif()
