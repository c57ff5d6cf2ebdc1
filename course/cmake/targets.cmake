# One function for each kind of target; nothing is written out by hand twice.

# Warnings are errors for our code. Paths in objects are relative to the root:
# reports show them, and the judge tells shown from hidden cases by them. All of
# it is for programs (-fPIE); what a submission is linked with adds -fPIC.
# course_options(target MORE_OPTIONS...)
function(course_options target)
    target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR})
    target_compile_options(
        ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                          -Wsign-conversion -Werror -fPIE
                          -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/= ${ARGN})
endfunction()

# PRECOMPILED: the owner of the precompiled header that it takes.
# course_library(name SOURCES... LINK... PRECOMPILED owner)
function(course_library name)
    cmake_parse_arguments(ARG "" "PRECOMPILED" "SOURCES;LINK" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    course_options(${name})
    target_link_libraries(${name} PUBLIC ${ARG_LINK})
    if(ARG_PRECOMPILED)
        target_precompile_headers(${name} REUSE_FROM ${ARG_PRECOMPILED})
    endif()
endfunction()

# A precompiled header that targets share by REUSE_FROM. Theirs must be the same
# options, but for definitions that no header of it mentions; g++ 12 breaks down
# on another -O.
# course_precompiled(name HEADERS... LINK... OPTIONS...)
function(course_precompiled name)
    cmake_parse_arguments(ARG "" "" "HEADERS;LINK;OPTIONS" ${ARGN})
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/glue/${name}.cpp
         CONTENT "// Generated: a precompiled header needs a source.\n")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL
                ${CMAKE_BINARY_DIR}/glue/${name}.cpp)
    course_options(${name} ${ARG_OPTIONS})
    target_link_libraries(${name} PRIVATE ${ARG_LINK})
    target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# A target of many small sources that read a command line: what they take to
# compile is CLI11, and their work is done elsewhere. So they are compiled as
# one, in a sixth of the time (40 sources: 20 s instead of 130), and what they
# keep to themselves has names of its own.
function(course_commands name)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON
                                             UNITY_BUILD_BATCH_SIZE 0)
    target_compile_options(${name} PRIVATE -O0)
endfunction()

# One test program per *_test.cpp of a folder, linked with Catch2's main.
# course_tests(folder LINK...)
function(course_tests folder)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    if(NOT COURSE_TESTS)
        return()
    endif()
    file(GLOB tests CONFIGURE_DEPENDS ${folder}/*_test.cpp)
    foreach(test ${tests})
        get_filename_component(name ${test} NAME_WE)
        add_executable(${name} ${test})
        course_options(${name})
        target_compile_definitions(
            ${name} PRIVATE COURSE_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                            COURSE_BINARY_DIR="${CMAKE_BINARY_DIR}")
        target_link_libraries(${name} PRIVATE ${ARG_LINK} course_test_main)
        target_precompile_headers(${name} REUSE_FROM course_catch2)
        add_test(NAME ${name} COMMAND ${name}
                 WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    endforeach()
endfunction()

# The headers of the project that `ARGN` include, directly or not, and they.
function(course_included_headers result)
    set(found ${ARGN})
    set(todo ${ARGN})
    while(todo)
        list(POP_FRONT todo header)
        file(STRINGS ${header} lines REGEX "^#include \"")
        foreach(line ${lines})
            string(REGEX REPLACE ".*\"(.*)\".*" "${CMAKE_SOURCE_DIR}/\\1" path
                                 "${line}")
            if(NOT path IN_LIST found)
                list(APPEND found ${path})
                list(APPEND todo ${path})
            endif()
        endforeach()
    endwhile()
    set(${result} ${found} PARENT_SCOPE)
endfunction()

# The declaration of the exercise's function, from its contract: sets `result`
# to "ReturnType;parameters;names of the parameters separated by commas".
function(course_read_contract header function result_type parameters names)
    file(READ ${header} text)
    string(REGEX REPLACE "//[^\n]*" "" text "${text}")
    string(REGEX REPLACE "#[^\n]*" "" text "${text}")
    # Brackets would confuse CMake's lists.
    string(REGEX REPLACE "[[][^]]*[]]" "" text "${text}")
    if(NOT text MATCHES
       "([A-Za-z_][A-Za-z_0-9:<>, \n]*[ \n>&*])${function}[(]([^()]*)[)]")
        message(FATAL_ERROR "${header}: expected the declaration of ${function}")
    endif()
    set(type "${CMAKE_MATCH_1}")
    set(list "${CMAKE_MATCH_2}")
    string(STRIP "${type}" type)
    string(REGEX REPLACE "<[^<>]*>" "" plain "${list}")
    string(REGEX REPLACE "<[^<>]*>" "" plain "${plain}")
    string(REGEX MATCHALL "[A-Za-z_][A-Za-z_0-9]*[ \n]*(,|$)" found "${plain}")
    string(REGEX REPLACE "[ \n,]" "" found "${found}")
    string(REPLACE ";" ", " found "${found}")
    set(${result_type} "${type}" PARENT_SCOPE)
    set(${parameters} "${list}" PARENT_SCOPE)
    set(${names} "${found}" PARENT_SCOPE)
endfunction()

# The generated sources of an exercise: the proxy that the judge calls, and the
# entries that the worker and the recorder of walks call.
function(course_generate_glue topic name)
    set(header exercises/${topic}/${name}.h)
    set(glue ${CMAKE_BINARY_DIR}/glue)
    if(EXISTS ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}.csv)
        file(CONFIGURE OUTPUT ${glue}/${name}_data.cpp CONTENT
"// Generated: the submitted file of a data exercise.
#include \"${header}\"
#include \"course/runner/submitted_table.h\"

std::vector<std::vector<TableCell>> ${name}() {
    return course::submitted_table();
}
")
        return()
    endif()
    course_read_contract(${CMAKE_SOURCE_DIR}/${header} ${name} type parameters
                         names)
    file(CONFIGURE OUTPUT ${glue}/${name}_proxy.cpp CONTENT
"// Generated: stands in for the student's function in the judge.
#include \"${header}\"
#include \"course/runner/proxy.h\"

${type} ${name}(${parameters}) {
    return course::remote_call<${type}>(\"${name}\", ${names});
}
")
    file(CONFIGURE OUTPUT ${glue}/${name}_entry.cpp CONTENT
"// Generated: what the worker calls in a submission.
#include \"${header}\"
#include \"course/runner/platform.h\"
#include \"course/runner/worker.h\"

extern \"C\" const course::Entry course_entry;
constinit const course::Entry course_entry = course::entry_for<&${name}>();

#if COURSE_LINUX
// Static variables with a destructor name it; the bare link has no crtbegin.
extern \"C\" [[gnu::visibility(\"hidden\")]] void* __dso_handle;
void* __dso_handle = nullptr;
#endif
")
    file(CONFIGURE OUTPUT ${glue}/${name}_walk.cpp CONTENT
"// Generated: what the recorder of walks calls in a submission.
#include \"${header}\"
#include \"course/player/walk_entry.h\"

extern \"C\" const course::WalkEntry course_walk_entry;
constinit const course::WalkEntry course_walk_entry =
    course::walk_entry_for<&${name}, \"${names}\">();

extern \"C\" [[gnu::visibility(\"hidden\")]] void* __dso_handle;
void* __dso_handle = nullptr;
")
endfunction()

# A suite, or the proxy of what it calls: compiled once, linked into every judge
# of its exercise.
function(course_suite target source)
    add_library(${target} OBJECT ${source})
    course_options(${target})
    target_link_libraries(${target} PRIVATE course_judge)
    target_precompile_headers(${target} REUSE_FROM course_judge)
endfunction()

# A judge in judges/<kind>/<name>: suites, and what they call. Without
# COURSE_JUDGES all of it is compiled and nothing linked.
# course_judge(kind name SOURCES... SUITES... LINK...)
function(course_judge kind name)
    cmake_parse_arguments(ARG "" "" "SOURCES;SUITES;LINK" ${ARGN})
    set(target judge_${kind}_${name})
    if(NOT COURSE_JUDGES)
        if(ARG_SOURCES)
            add_library(${target} OBJECT ${ARG_SOURCES})
            course_options(${target})
        endif()
        return()
    endif()
    add_executable(${target} ${ARG_SOURCES})
    course_options(${target})
    foreach(suite ${ARG_SUITES})
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:${suite}>)
    endforeach()
    target_link_libraries(${target} PRIVATE ${ARG_LINK} course_judge
                                            course_judge_main)
    set_target_properties(
        ${target} PROPERTIES OUTPUT_NAME ${name} RUNTIME_OUTPUT_DIRECTORY
                             ${CMAKE_BINARY_DIR}/judges/${kind})
endfunction()

# The reference solutions of the exercises that an exercise builds on: those
# whose contracts its contract includes.
function(course_references_before topic name result)
    set(contract ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}.h)
    course_included_headers(headers ${contract})
    list(FILTER headers INCLUDE REGEX "^${CMAKE_SOURCE_DIR}/exercises/")
    list(REMOVE_ITEM headers ${contract})
    list(TRANSFORM headers REPLACE "^${CMAKE_SOURCE_DIR}/exercises/(.*)[.]h$"
                                   "${CMAKE_SOURCE_DIR}/solutions/\\1.cpp")
    set(${result} ${headers} PARENT_SCOPE)
endfunction()

# What calls a submission, compiled once, where the compile step finds it: file
# <name>.o in `folder`, made by the target <name>_<kind>_file; with the
# references that it may call, whose names a submission may define anew for
# itself.
# course_entry(kind folder name REFERENCES... DEFINITIONS...)
function(course_entry kind folder name)
    cmake_parse_arguments(ARG "" "" "REFERENCES;DEFINITIONS" ${ARGN})
    set(target ${name}_${kind})
    add_library(${target} OBJECT EXCLUDE_FROM_ALL
                ${CMAKE_BINARY_DIR}/glue/${target}.cpp)
    course_options(${target} -fPIC)
    target_compile_definitions(${target} PRIVATE ${ARG_DEFINITIONS})
    set(entry $<TARGET_OBJECTS:${target}>)
    set(file ${CMAKE_BINARY_DIR}/student/${folder}/${name}.o)
    set(make_file ${CMAKE_COMMAND} -E copy ${entry} ${file})
    set(before "")  # the caller's is not ours
    if(ARG_REFERENCES)
        set(references ${target}_references)
        add_library(${references} OBJECT EXCLUDE_FROM_ALL ${ARG_REFERENCES})
        course_options(${references} -fPIC)
        target_compile_definitions(${references} PRIVATE ${ARG_DEFINITIONS})
        set(before $<TARGET_OBJECTS:${references}>)
        set(weak ${CMAKE_BINARY_DIR}/glue/${target}_references.o)
        set(make_file
            ${CMAKE_LINKER} -r -o ${weak} ${before}
            COMMAND ${CMAKE_OBJCOPY} --weaken ${weak}
            COMMAND ${CMAKE_LINKER} -r -o ${file} ${entry} ${weak})
    endif()
    add_custom_command(
        OUTPUT ${file}
        COMMAND ${make_file}
        DEPENDS ${target} ${entry} ${before}
        COMMAND_EXPAND_LISTS)
    add_custom_target(${target}_file DEPENDS ${file})
endfunction()

# The entries of an exercise: for the worker, and for the recorder of walks. The
# recorder does not see inside of what a submission calls of earlier exercises.
function(course_entries topic name)
    course_entry(entry entries ${name} REFERENCES ${ARGN})
    target_precompile_headers(${name}_entry REUSE_FROM course_entry_headers)
    add_custom_target(${name}_entry_is_built ALL DEPENDS ${name}_entry_file)
    file(STRINGS ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}.h tables
         REGEX "^[^/#]*HalfEdgeTable")
    if(tables)
        course_entry(walk walks ${name} REFERENCES ${ARGN}
                     DEFINITIONS COURSE_TABLE=2 COURSE_TABLE_SILENT)
    endif()
endfunction()

# All targets of one exercise, from the files that it consists of:
#   judges/lab/<name>        public suite against a submission
#   judges/grade/<name>      public and hidden suite against a submission
#   judges/reference/<name>  the same against the reference, in process
function(course_add_exercise topic name)
    # Of some exercises a copy for one assignment has the contract only.
    if(NOT EXISTS ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}.md)
        return()
    endif()
    if(NOT EXISTS ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}_test.cpp)
        message(WARNING "exercises/${topic}/${name}.h: the exercise has no "
                        "public suite ${name}_test.cpp, it is left out")
        return()
    endif()
    course_generate_glue(${topic} ${name})
    if(EXISTS ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}.csv)
        set(proxy ${CMAKE_BINARY_DIR}/glue/${name}_data.cpp)
        set(reference ${proxy})
    else()
        set(proxy ${CMAKE_BINARY_DIR}/glue/${name}_proxy.cpp)
        set(reference ${CMAKE_SOURCE_DIR}/solutions/${topic}/${name}.cpp)
        course_references_before(${topic} ${name} before)
        if(IS_DIRECTORY ${CMAKE_SOURCE_DIR}/solutions)
            list(APPEND reference ${before})
            course_entries(${topic} ${name} ${before})
        else()
            course_entries(${topic} ${name})
        endif()
    endif()
    set(hidden ${CMAKE_SOURCE_DIR}/grader/suites/${topic}/${name}_test.cpp)

    course_suite(${name}_proxy ${proxy})
    course_suite(${name}_shown
                 ${CMAKE_SOURCE_DIR}/exercises/${topic}/${name}_test.cpp)
    course_judge(lab ${name} SUITES ${name}_proxy ${name}_shown)
    if(NOT EXISTS ${hidden})
        return()
    endif()
    course_suite(${name}_hidden ${hidden})
    course_judge(grade ${name}
                 SUITES ${name}_proxy ${name}_shown ${name}_hidden
                 LINK course_oracle)
    course_judge(reference ${name} SOURCES ${reference}
                 SUITES ${name}_shown ${name}_hidden LINK course_oracle)
endfunction()

# An exercise is added by adding its files: each contract makes one.
function(course_add_all_exercises)
    file(GLOB contracts CONFIGURE_DEPENDS RELATIVE
         ${CMAKE_SOURCE_DIR}/exercises ${CMAKE_SOURCE_DIR}/exercises/*/*.h)
    # A contract is read when the build is configured.
    list(TRANSFORM contracts PREPEND ${CMAKE_SOURCE_DIR}/exercises/
         OUTPUT_VARIABLE files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
    foreach(contract ${contracts})
        get_filename_component(topic ${contract} DIRECTORY)
        get_filename_component(name ${contract} NAME_WE)
        course_add_exercise(${topic} ${name})
    endforeach()
endfunction()
