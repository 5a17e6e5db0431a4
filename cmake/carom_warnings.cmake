# carom_warnings(<target>): the warnings that Carom's own code is free of. They do not reach who links the target.
function(carom_warnings target)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion
        $<$<BOOL:${CAROM_WERROR}>:-Werror>)
    # gcc 12 sees an overlap in `"text" + string` that is not there (its bug 105651).
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
endfunction()
