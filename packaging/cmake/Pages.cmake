# voroproof_page(ROOM/SUBJECT [MADE]): the page of ROOM/SUBJECT/page/ as the C++ constant SUBJECT_page, in
# SUBJECT_page.cpp of the current build directory. It may refer to the file MADE of the build.
function(voroproof_page place)
  get_filename_component(subject ${place} NAME)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${subject}_page.cpp)
  set(folder ${CMAKE_SOURCE_DIR}/${place}/page)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DMADE=${ARGN} -DNAME=${subject}_page -DHEADER=${place}/${subject}_page.h
      -DOUTPUT=${output} -P ${CMAKE_SOURCE_DIR}/packaging/cmake/EmbedPage.cmake
    DEPENDS ${files} ${ARGN} ${CMAKE_SOURCE_DIR}/packaging/cmake/EmbedPage.cmake
    VERBATIM)
endfunction()
