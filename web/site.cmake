# The page, complete for any static host: the files of public/, the app, the JavaScript module and the default
# library. The library is made by the native program, hence a path from outside.
set(STRIDEGRAPH_DEFAULT_LIBRARY ${PROJECT_SOURCE_DIR}/build/library/default.sgraph
    CACHE FILEPATH "The .sgraph file that the page opens with")
find_file(STRIDEGRAPH_FONT Inter-Medium.otf PATHS /usr/share/fonts/opentype/inter /usr/share/fonts
          PATH_SUFFIXES opentype/inter NO_CMAKE_FIND_ROOT_PATH)

set(site_parts stridegraph_app)
if(TARGET stridegraph_javascript)
  list(APPEND site_parts stridegraph_javascript)
endif()
add_custom_target(site ALL
  COMMAND ${CMAKE_COMMAND}
    -DPUBLIC=${PROJECT_SOURCE_DIR}/public
    -DSITE=${STRIDEGRAPH_SITE_DIR}
    -DAPP=$<TARGET_FILE_DIR:stridegraph_app>
    -DMODULE=${STRIDEGRAPH_MODULE_DIR}
    -DFONT=${STRIDEGRAPH_FONT}
    -DLIBRARY=${STRIDEGRAPH_DEFAULT_LIBRARY}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/assemble_site.cmake
  COMMENT "Assembling the page in ${STRIDEGRAPH_SITE_DIR}"
  VERBATIM)
add_dependencies(site ${site_parts})
