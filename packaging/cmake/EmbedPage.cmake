# Makes OUTPUT, a C++ source that defines the PageTemplate NAME (library/html.h), which HEADER declares, of
# FOLDER/page.html: a page with {{title}} and {{data}} where these belong. Style sheets and scripts of FOLDER that it
# refers to are put into it, so that it needs no other file; the file MADE stands for one of its name.
#
# usage: cmake -DFOLDER=... [-DMADE=...] -DNAME=... -DHEADER=... -DOUTPUT=... -P EmbedPage.cmake

# Replaces each element of `page` that matches by an ELEMENT with the content of the file that the expression's group names.
function(put_files expression element)
  while(page MATCHES "${expression}")
    set(reference "${CMAKE_MATCH_0}")
    set(file ${FOLDER}/${CMAKE_MATCH_1})
    if(MADE AND MADE MATCHES "/${CMAKE_MATCH_1}$")
      set(file ${MADE})
    endif()
    file(READ ${file} content)
    string(REPLACE "${reference}" "<${element}>\n${content}</${element}>" page "${page}")
  endwhile()
  set(page "${page}" PARENT_SCOPE)
endfunction()

# Appends to `source` an array of literals with the text: compilers limit the length of one, and what they compute by themselves:
# a literal with `sv` has its length.
function(append_array name text)
  string(APPEND source "constexpr std::string_view ${name}[] = {\n")
  string(LENGTH "${text}" length)
  set(from 0)
  while(from LESS length)
    string(SUBSTRING "${text}" ${from} 8000 piece)
    string(APPEND source "R\"page(${piece})page\"sv,\n")
    math(EXPR from "${from} + 8000")
  endwhile()
  set(source "${source}};\n" PARENT_SCOPE)
endfunction()

# Sets `before` and `after` to what stands around `mark` in the text.
function(cut text mark)
  string(FIND "${text}" "${mark}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${FOLDER}/page.html has no ${mark}")
  endif()
  string(SUBSTRING "${text}" 0 ${at} before)
  string(LENGTH "${mark}" length)
  math(EXPR end "${at} + ${length}")
  string(SUBSTRING "${text}" ${end} -1 after)
  set(before "${before}" PARENT_SCOPE)
  set(after "${after}" PARENT_SCOPE)
endfunction()

file(READ ${FOLDER}/page.html page)
put_files("<link rel=\"stylesheet\" href=\"([^\"]+)\">" style)
put_files("<script src=\"([^\"]+)\"></script>" script)

set(source "// Made by packaging/cmake/EmbedPage.cmake.\n#include \"${HEADER}\"\n\nnamespace voroproof::internal {\nnamespace {\n\nusing namespace std::string_view_literals;\n\n")
cut("${page}" "{{title}}")
append_array(before_title "${before}")
cut("${after}" "{{data}}\n")
append_array(before_data "${before}")
append_array(after_data "${after}")
string(APPEND source "\n}  // namespace\n\nconst PageTemplate ${NAME}{before_title, before_data, after_data};\n\n}  // namespace voroproof::internal\n")
file(WRITE ${OUTPUT} "${source}")
