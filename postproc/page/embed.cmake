# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: cmake -DFOLDER=web -DOUT=web_files.cpp -P embed.cmake
# Makes a C++ source of the files in FOLDER, so that the program needs none beside it: raw strings
# hold them as they stand.
file(GLOB files RELATIVE ${FOLDER} ${FOLDER}/*)
set(source "#include \"page/web_files.h\"\n\nnamespace rodpack {\n
std::string_view web_file(std::string_view name) {\n")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} content)
  string(APPEND source "  if (name == \"${file}\") return R\"~rodpack~(${content})~rodpack~\";\n")
endforeach()
string(APPEND source "  return {};\n}\n\n}  // namespace rodpack\n")
file(WRITE ${OUT} "${source}")
