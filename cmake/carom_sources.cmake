# carom_sources(<out> <folder>): every .cpp of a folder and below it that is not a unit test.
# carom_unit_tests(<out> <folder>): every *_test.cpp there.
# Both notice a file that is added later: the next build configures again.
function(carom_sources out folder)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
    list(FILTER files EXCLUDE REGEX "_test\\.cpp$")
    set(${out} ${files} PARENT_SCOPE)
endfunction()

function(carom_unit_tests out folder)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*_test.cpp)
    set(${out} ${files} PARENT_SCOPE)
endfunction()
