# The profiler's back end, by CAROM_PROFILER: none, tracy or chrome. See docs/profiling.md.
set(CAROM_PROFILER none CACHE STRING "Profiler back end: none (no cost), tracy (needs Tracy), chrome (writes traces for a browser)")
set_property(CACHE CAROM_PROFILER PROPERTY STRINGS none tracy chrome)
if(NOT CAROM_PROFILER MATCHES "^(none|tracy|chrome)$")
    message(FATAL_ERROR "CAROM_PROFILER is \"${CAROM_PROFILER}\"; give none, tracy or chrome")
endif()

set(CAROM_TRACY_TAG v0.11.1 CACHE STRING "The version of Tracy that is fetched; a Tracy server must be of the same")
mark_as_advanced(CAROM_TRACY_TAG)

# carom_find_tracy(): makes the target Tracy::TracyClient. In this order: one that the project has already, the folder in
# FETCHCONTENT_SOURCE_DIR_TRACY, an installed package, a download.
macro(carom_find_tracy)
    if(NOT TARGET Tracy::TracyClient AND NOT FETCHCONTENT_SOURCE_DIR_TRACY)
        find_package(Tracy CONFIG QUIET)
    endif()
    if(NOT TARGET Tracy::TracyClient)
        include(FetchContent)
        FetchContent_Declare(Tracy
            GIT_REPOSITORY https://github.com/wolfpld/tracy.git GIT_TAG ${CAROM_TRACY_TAG} GIT_SHALLOW ON)
        FetchContent_MakeAvailable(Tracy)
    endif()
endmacro()

# carom_add_profiler(<target>): what the back end needs. Public, because <carom/profile.hpp> follows the definition in the user's code too.
function(carom_add_profiler target)
    if(NOT CAROM_PROFILER STREQUAL none)
        target_compile_definitions(${target} PUBLIC CAROM_PROFILER_ON=1)
    endif()
    if(CAROM_PROFILER STREQUAL tracy)
        target_link_libraries(${target} PRIVATE Tracy::TracyClient)
    endif()
endfunction()
