# SPDX-License-Identifier: GPL-2.0-or-later
# Stages a copy of LIGGGHTS-PUBLIC 3.8.0 and overlays our styles:
#
#   cmake -DLIGGGHTS_WORK=<folder> [-DLIGGGHTS_SOURCE=<folder or tarball>] -P StageLiggghts.cmake
#
# Without LIGGGHTS_SOURCE the distribution's source package is fetched (once, kept in LIGGGHTS_WORK).
# Result: LIGGGHTS_WORK/src with the stock sources, links to our headers, and the style_*.h lists that
# LIGGGHTS's own Make.sh derives from them. The copy is made once per source; the lists are derived
# again only when a registration in styles/ changed. The source itself is never written to.
cmake_minimum_required(VERSION 3.25)

set(tarball_name liggghts_3.8.0+repack1.orig.tar.xz)
set(tarball_sha256 c18721d9a870c5170f03b91e4f1ffe13335c66ed1f0ff2c64ebd3be91c37867a)
set(how_to_help "give -DLIGGGHTS_SOURCE=<LIGGGHTS-PUBLIC 3.8.0: its folder, or Debian's ${tarball_name}>")
set(ext ${CMAKE_CURRENT_LIST_DIR})
set(staged ${LIGGGHTS_WORK}/src)

# Stops with one line; the leading blank keeps CMake from wrapping it.
function(stop text)
  string(REGEX REPLACE "[\r\n]+ *" " " text "${text}")
  message(FATAL_ERROR " LIGGGHTS: ${text}")
endfunction()

function(check_tarball file)
  file(SHA256 ${file} sha256)
  if(NOT sha256 STREQUAL tarball_sha256)
    stop("${file} has SHA-256 ${sha256}, expected ${tarball_sha256}: ${how_to_help}")
  endif()
endfunction()

# Sets `source` to a checked folder with the sources (ending in src) or a checked tarball.
function(find_source)
  if(NOT LIGGGHTS_SOURCE)
    set(source ${LIGGGHTS_WORK}/${tarball_name})
    if(NOT EXISTS ${source})
      message(STATUS "Fetching the distribution's source package of LIGGGHTS")
      execute_process(COMMAND sh ${ext}/fetch-liggghts.sh ${LIGGGHTS_WORK}
                      ERROR_VARIABLE why RESULT_VARIABLE failed)
      if(failed OR NOT EXISTS ${source})
        string(REGEX REPLACE "\n.*" "" why "${why}")
        stop("cannot fetch ${tarball_name} with apt (${why}): ${how_to_help}")
      endif()
    endif()
    check_tarball(${source})
  elseif(NOT EXISTS ${LIGGGHTS_SOURCE})
    stop("LIGGGHTS_SOURCE=${LIGGGHTS_SOURCE} does not exist: ${how_to_help}")
  elseif(NOT IS_DIRECTORY ${LIGGGHTS_SOURCE})
    set(source ${LIGGGHTS_SOURCE})
    check_tarball(${source})
  else()
    set(source ${LIGGGHTS_SOURCE})
    if(EXISTS ${source}/src/version_liggghts.txt)
      string(APPEND source /src)
    endif()
    foreach(file version_liggghts.txt Make.sh main.cpp fix_multisphere.h)
      if(NOT EXISTS ${source}/${file})
        stop("LIGGGHTS_SOURCE=${LIGGGHTS_SOURCE} is not a LIGGGHTS source (no ${file}): ${how_to_help}")
      endif()
    endforeach()
    file(STRINGS ${source}/version_liggghts.txt version LIMIT_COUNT 1)
    if(NOT version STREQUAL "3.8.0")
      stop("LIGGGHTS_SOURCE=${LIGGGHTS_SOURCE} is version ${version}, expected 3.8.0: ${how_to_help}")
    endif()
  endif()
  set(source ${source} PARENT_SCOPE)
endfunction()

# Copies the flat sources to `to`, without what an earlier build derived.
function(copy_sources to)
  set(folder ${source})
  if(NOT IS_DIRECTORY ${source})
    file(ARCHIVE_EXTRACT INPUT ${source} DESTINATION ${to}.unpacked PATTERNS "*/src/*")
    file(GLOB folder ${to}.unpacked/*/src)
  endif()
  file(GLOB files ${folder}/*.h ${folder}/*.cpp ${folder}/Make.sh ${folder}/version_*.txt)
  list(FILTER files EXCLUDE REGEX "/(style_[a-z_]*|version_liggghts)\\.h$")
  file(COPY ${files} DESTINATION ${to})
  file(REMOVE_RECURSE ${to}.unpacked)
endfunction()

# Replaces text of a stock source (stock/mends.cmake says which and why). A tree in which it is mended
# already passes; any other text is not the LIGGGHTS we know.
function(mend folder name old new)
  set(file ${folder}/${name})
  file(READ ${file} text)
  string(FIND "${text}" "${old}" at_old)
  string(FIND "${text}" "${new}" at_new)
  if(at_old GREATER -1)
    string(REPLACE "${old}" "${new}" text "${text}")
    file(WRITE ${file} "${text}")
  elseif(at_new EQUAL -1)
    stop("${source} is not LIGGGHTS 3.8.0 (${name} lacks '${old}'): ${how_to_help}")
  endif()
endfunction()

include(${ext}/stock/mends.cmake)

function(make_sh folder what)
  execute_process(COMMAND sh Make.sh ${what} WORKING_DIRECTORY ${folder}
                  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE failed)
  if(failed)
    stop("'sh Make.sh ${what}' failed in ${folder}: ${log}")
  endif()
endfunction()

# Writes the list of contact-model combinations that stock LIGGGHTS compiles for its fast path. The
# rule is that of `Make.sh models`, whose own loop takes a minute of starting processes: the product
# of (model number + 1) is below 30, and tangential is not off.
function(write_stock_combinations folder)
  foreach(kind SURFACE NORMAL TANGENTIAL COHESION ROLLING)
    string(TOLOWER ${kind} prefix)
    set(${kind} "")
    if(NOT kind MATCHES "SURFACE|NORMAL")
      set(${kind} ${kind}_OFF:1)
    endif()
    file(GLOB headers ${folder}/${prefix}_model_*.h)
    foreach(header ${headers})
      file(STRINGS ${header} line REGEX "^${kind}_MODEL\\(")
      if(line MATCHES "\\( *([A-Z0-9_]+) *,.*, *([0-9]+) *\\)")
        math(EXPR factor "${CMAKE_MATCH_2} + 1")
        list(APPEND ${kind} ${CMAKE_MATCH_1}:${factor})
      endif()
    endforeach()
  endforeach()
  set(combinations "")
  foreach(surface ${SURFACE})
    foreach(normal ${NORMAL})
      foreach(tangential ${TANGENTIAL})
        foreach(cohesion ${COHESION})
          foreach(rolling ${ROLLING})
            set(models "${normal}, ${tangential}, ${cohesion}, ${rolling}, ${surface}")
            string(REGEX REPLACE "[^,]*:" "" factors "${models}")
            string(REPLACE "," "*" product "${factors}")
            math(EXPR product "${product}")
            if(product LESS 30 AND NOT tangential STREQUAL "TANGENTIAL_OFF:1")
              string(REGEX REPLACE ":[0-9]+" "" models "${models}")
              string(APPEND combinations "GRAN_MODEL(${models})\n")
            endif()
          endforeach()
        endforeach()
      endforeach()
    endforeach()
  endforeach()
  file(WRITE ${folder}/style_contact_model.whitelist "${combinations}")
endfunction()

# Stock lammps.cpp compiles every contact-model combination, for pairs and for walls, together with
# all that depends on any style's header: more than a minute whenever one is touched. Here pairs and
# walls become sources of their own, which depend on the contact models only.
function(split_granular_styles folder)
  file(READ ${folder}/granular_styles.h text)
  foreach(half pair wall)
    set(other wall)
    if(half STREQUAL wall)
      set(other pair)
    endif()
    string(REGEX REPLACE "[^\n]*${other}_factory[^\n]*\\\\\n" "" code "${text}")  # within a macro
    string(REGEX REPLACE "[^\n]*${other}_factory[^\n]*" "" code "${code}")
    string(REPLACE RegisterGranularStyles register_${half}_styles code "${code}")
    file(WRITE ${folder}/granular_${half}_styles.cpp "#include \"fix_insert_stream.h\"
${code}
namespace LAMMPS_NS { void register_granular_${half}_styles() { register_${half}_styles(); } }\n")
  endforeach()
  mend(${folder} lammps.cpp "#include \"granular_styles.h\""
    "namespace LAMMPS_NS { void register_granular_pair_styles(); void register_granular_wall_styles(); }")
  mend(${folder} lammps.cpp "regGranStyles = new RegisterGranularStyles();"
    "regGranStyles = NULL; register_granular_pair_styles(); register_granular_wall_styles();")
endfunction()

# The staged folder appears under its name when it is complete.
function(stage_stock_sources)
  file(SHA256 ${CMAKE_CURRENT_FUNCTION_LIST_FILE} recipe)
  file(SHA256 ${ext}/stock/mends.cmake mends)
  string(APPEND recipe " ${mends}")
  set(stamp ${LIGGGHTS_WORK}/staged.txt)
  if(EXISTS ${stamp} AND EXISTS ${staged})
    file(READ ${stamp} known)
    if(known STREQUAL "${source} ${recipe}")
      return()
    endif()
  endif()

  message(STATUS "Staging LIGGGHTS 3.8.0 from ${source}")
  file(REMOVE ${stamp} ${LIGGGHTS_WORK}/registrations.txt)
  set(partial ${LIGGGHTS_WORK}/partial)
  file(REMOVE_RECURSE ${staged} ${partial} ${partial}.unpacked)
  copy_sources(${partial})
  mend_stock(${partial})
  split_granular_styles(${partial})
  write_stock_combinations(${partial})
  # Without the time of the build, and the commit asked for at run time: an unchanged tree must not
  # compile again.
  file(WRITE ${partial}/version_liggghts.h "#include \"rodpack/version.h\"
#include <string>
#define LIGGGHTS_VERSION (std::string(\"LIGGGHTS-PUBLIC 3.8.0 with rodpack \") + \\
  rodpack::version() + \" (\" + rodpack::commit() + \")\").c_str()
")
  file(RENAME ${partial} ${staged})
  file(WRITE ${stamp} "${source} ${recipe}")
endfunction()

# Links our headers and contact-model combinations into the staged folder, flat as LIGGGHTS wants
# them, and lets Make.sh derive the style lists; it leaves a list alone that did not change.
function(overlay_styles)
  file(GLOB overlay ${ext}/styles/*/*.h ${ext}/styles/*/*.whitelist)
  set(registrations "")
  foreach(file ${overlay})
    file(STRINGS ${file} lines REGEX "_(CLASS|MODEL)")
    string(APPEND registrations "${file} ${lines}\n")
  endforeach()
  set(stamp ${LIGGGHTS_WORK}/registrations.txt)
  if(EXISTS ${stamp})
    file(READ ${stamp} known)
    if(known STREQUAL registrations)
      return()
    endif()
  endif()

  file(REMOVE ${stamp})
  file(GLOB old ${staged}/*)
  foreach(file ${old})
    if(IS_SYMLINK ${file})
      file(REMOVE ${file})
    endif()
  endforeach()
  foreach(file ${overlay})
    get_filename_component(name ${file} NAME)
    if(EXISTS ${staged}/${name})
      stop("${source} already has a file ${name} of ours: give a pristine tree")
    endif()
    file(CREATE_LINK ${file} ${staged}/${name} SYMBOLIC)
  endforeach()
  file(CREATE_LINK ${ext}/core/include/rodpack ${staged}/rodpack SYMBOLIC)

  # Make.sh stamps this one with the time; its age decides what is compiled again.
  file(RENAME ${staged}/version_liggghts.h ${LIGGGHTS_WORK}/version_liggghts.h)
  make_sh(${staged} style)
  make_sh(${staged} models)
  file(RENAME ${LIGGGHTS_WORK}/version_liggghts.h ${staged}/version_liggghts.h)
  file(WRITE ${stamp} "${registrations}")
endfunction()

file(MAKE_DIRECTORY ${LIGGGHTS_WORK})
find_source()
stage_stock_sources()
overlay_styles()
