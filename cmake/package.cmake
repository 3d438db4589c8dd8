# Debian packages, made by cpack -G DEB in build/package: carom contains the programs, the configurations that shots include,
# examples, manual and completions; carom-lab the laboratory; libcarom-dev the library. In build/release only carom is made.
set(CPACK_PACKAGE_NAME carom)
set(CPACK_PACKAGE_VENDOR "The carom authors")
set(CPACK_PACKAGE_CONTACT "The carom authors")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program)
if(CAROM_LIBRARY)
  list(APPEND CPACK_COMPONENTS_ALL lab library)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# dpkg-shlibdeps finds the libraries; the fonts must be listed.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "films of billiard-style shots, simulated and ray traced")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME carom)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-dejavu-core, fonts-urw-base35")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS rsync)  # only carom cache push, pull and merge
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"A shot is written in YAML, simulated with ODE and baked into timelines; a path tracer with true motion blur and
depth of field films these, at any speed, backwards or from another seat, and writes an MP4.")

set(CPACK_DEBIAN_LAB_PACKAGE_NAME carom-lab)
set(CPACK_DEBIAN_LAB_PACKAGE_DEPENDS "carom (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_LAB_DESCRIPTION
"The laboratory of carom: the command compare, which measures acceleration structures and ray-triangle kernels of the
literature against those of the renderer. Films do not need it.")

# Linking the archives needs the libraries that they use; the package carom contains the configurations that shots include.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libcarom-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS OFF)
string(JOIN ", " CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "carom (= ${PROJECT_VERSION})" pkg-config
  libode-dev libebur128-dev libavcodec-dev libavformat-dev libavutil-dev libswresample-dev libswscale-dev libyaml-cpp-dev libopenexr-dev libpng-dev libzstd-dev libimath-dev
  libhwy-dev libtbb-dev libxxhash-dev libfmt-dev libfreetype-dev libcairo2-dev libpango1.0-dev)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"The static libraries, headers and CMake files of carom, and two example programs: find_package(carom) gives carom::sim,
carom::render and carom::film. Before version 1.0 the interface may change with every release.")
include(CPack)

# Files that belong to no program. Examples are next to the configurations that they include.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION share/carom PATTERN api EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/images/gallery/ DESTINATION share/carom/examples/stills
  FILES_MATCHING PATTERN "example_*.jpg")
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md
  DESTINATION share/doc/carom)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION share/doc/carom)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/carom RENAME copyright)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/carom-lab RENAME copyright COMPONENT lab)
