# How our targets are compiled fast: the headers that everybody includes are compiled once, and the sources of a folder as one.
# LUBBERLINE_UNITY=OFF compiles each source by itself, which is quicker after a change in one of them and finds missing includes.
option(LUBBERLINE_UNITY "Compile the sources of a folder as one" ON)

# lubberline_compile(TARGET [LIGHT] PRECOMPILED HEADER…|REUSE TARGET): to be called where the target's sources are complete.
# LIGHT is for code that waits for people and disks, not for arithmetic: a quarter less time to compile than with -O3.
function(lubberline_compile target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "LIGHT" "REUSE" "PRECOMPILED")
    if(arg_LIGHT)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    if(arg_REUSE)
        target_precompile_headers(${target} REUSE_FROM ${arg_REUSE})
    elseif(arg_PRECOMPILED)
        target_precompile_headers(${target} PRIVATE ${arg_PRECOMPILED})
    endif()
    if(NOT LUBBERLINE_UNITY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        if(source MATCHES "\\.cpp$")
            get_filename_component(folder ${source} DIRECTORY)
            string(MAKE_C_IDENTIFIER "all_${folder}" group)
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
        endif()
    endforeach()
endfunction()
