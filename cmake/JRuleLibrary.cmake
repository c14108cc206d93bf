# How every target of jrule itself is compiled. Users' targets are not touched.

# jrule_target_options(target): C++20, every warning an error, sanitizers and libFuzzer's eyes when asked for.
function(jrule_target_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
  # g++ 12 finds overlaps in std::string concatenation that are not there (GCC bug 105651), and uninitialised parts of
  # std::variant, std::optional and std::regex that are not (GCC bugs 105562, 107138).
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-maybe-uninitialized>")
  # clang blames us for what std::stable_sort of libstdc++ 12 calls inside; g++ still tells what we call ourselves.
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>")
  if(JRULE_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=address,undefined -fno-sanitize-recover=all
                                            -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  if(JRULE_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(JRULE_SANITIZE_THREADS)
    target_compile_options(${target} PUBLIC -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=thread)
  endif()
endfunction()

# jrule_library(name SOURCES ... LINKS ...): one stage of the compiler, as a static library. In release builds at -O2: -O3 takes a
# quarter longer to compile, and only the search for counterexamples is faster for it.
function(jrule_library name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;LINKS")
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PUBLIC ${ARG_LINKS})
  target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-O2>")
  jrule_target_options(${name})
endfunction()
