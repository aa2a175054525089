# Makes OUTPUT, a C++ source that defines what apps/movie/movie_sources.h declares, of the files of
# FOLDER; SCRIPTS are the names of those in JavaScript in the order to be loaded, separated by
# commas.
#
# usage: cmake -DFOLDER=... -DSCRIPTS=a.js,b.js -DOUTPUT=... -P EmbedMovie.cmake

# A literal of the file; pieces, since compilers limit the length of one.
function(append_file variable name)
  file(READ ${FOLDER}/${name} content)
  string(LENGTH "${content}" length)
  set(literal "")
  set(from 0)
  while(from LESS length)
    string(SUBSTRING "${content}" ${from} 8000 piece)
    string(APPEND literal "R\"movie(${piece})movie\"\n")
    math(EXPR from "${from} + 8000")
  endwhile()
  set(${variable} "${${variable}}${literal}" PARENT_SCOPE)
endfunction()

set(source "// Made by cmake/EmbedMovie.cmake from apps/movie/.\n#include \"apps/movie/movie_sources.h\"\n\nnamespace voroproof::internal {\n\n")
string(APPEND source "const std::string_view movie_style =\n")
append_file(source player.css)
string(APPEND source ";\nconst std::string_view movie_body =\n")
append_file(source page.html)
string(APPEND source ";\nnamespace {\nconstexpr std::string_view scripts[] = {\n")
string(REPLACE "," ";" names "${SCRIPTS}")
foreach(name IN LISTS names)
  append_file(source ${name})
  string(APPEND source ",\n")
endforeach()
string(APPEND source "};\n}  // namespace\nconst std::span<const std::string_view> movie_scripts(scripts);\n\n}  // namespace voroproof::internal\n")
file(WRITE ${OUTPUT} "${source}")
