# carom_unity(<target>): with CAROM_UNITY, the files of a folder are compiled as one, which takes a third to a quarter of the time. Names in
# anonymous namespaces then have to be unique within their folder; a file that can't keep to that has the property SKIP_UNITY_BUILD_INCLUSION.
# Without it every file is compiled alone, which shows a missing #include: the preset `release` does that.
option(CAROM_UNITY "Compile the files of each folder as one: much quicker from nothing, slower after a small change" OFF)

# As many files at most in one: two processors then share the work evenly, and the largest takes no more than some seconds.
set(carom_unity_files 12)

function(carom_unity target)
    if(NOT CAROM_UNITY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    target_compile_options(${target} PRIVATE -Wno-shadow # a local name may be that of another file
        $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>) # a test of a fixture in an anonymous namespace is not in a header here
    get_target_property(sources ${target} SOURCES)
    foreach(source ${sources})
        get_filename_component(folder ${source} DIRECTORY)
        string(MAKE_C_IDENTIFIER "${folder}" group)
        math(EXPR part "0${count_${group}} / ${carom_unity_files}")
        math(EXPR count_${group} "0${count_${group}} + 1")
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}_${part}")
    endforeach()
endfunction()
